/* tradeoff/candidate_fast.c: cheap colour planes. See candidates.h.
 *
 * With the extents below 2^bits and a channel's differences below 2^8, the numerators of basis.h are below
 * 2^(bits + 9). Cut to 15 bits, times a reciprocal of 16 bits, a slope errs by 2^-14 of the steepest one;
 * triangles for which that is more than 1/16 step over their extent take the precise way. */
#include "../../core/draw/setup.h"
#include "../../core/fragment/gouraud.h"
#include "candidates.h"

struct fast {
    struct etch_point_q8 a; /* vertex 0 */
    int32_t x1, y1, x2, y2;
    int32_t reciprocal; /* 2^30 / D normalised to 2^15 .. 2^16: 14 .. 15 bits */
    int8_t up;          /* of a slope in 2^-27 steps */
    uint8_t down;       /* of the numerators */
};

static bool prepare(struct fast *f, const struct etch_triangle *t)
{
    const int32_t width = (t->x1 - t->x0) * 256 + 255, height = t->p[2].y - t->p[0].y;
    const uint32_t extent = (uint32_t)(width | height);

    if (width + height >= INT32_C(512) * 256 || t->area >> 32 != 0)
        return false;
    const uint32_t d = (uint32_t)(t->area & UINT32_MAX);
    const uint8_t zeros = etch_leading_zeros(d), bits = (uint8_t)(32 - etch_leading_zeros(extent));
    const int32_t h = (int32_t)(d << zeros >> 16);
    int32_t q = 46261 - (int32_t)((uint32_t)h * 30843 >> 16); /* 2^30 / h by a line .. */
    const int32_t e = (INT32_C(1) << 30) - h * q;             /* .. and one step of Newton's */

    q += (q >> 1) * (e >> 15) >> 14;
    f->reciprocal = q;
    f->down = (uint8_t)(bits + 9 > 15 ? bits + 9 - 15 : 0);
    /* slope = 256 n / D 31 2^27 / 255 = (n >> down) q 2^up 31 / 255, D = h 2^(16 - zeros) */
    f->up = (int8_t)(8 + 27 - 30 - 16 + zeros + f->down);
    f->a = t->p[0];
    f->x1 = (t->p[1].x - t->p[0].x) * t->side;
    f->y1 = (t->p[1].y - t->p[0].y) * t->side;
    f->x2 = (t->p[2].x - t->p[0].x) * t->side;
    f->y2 = height * t->side;
    /* 2^(up + 15) a pixel over 2^(bits - 7) px, to stay below 1/16 step or 2^23 */
    return f->up + 15 + bits - 7 - 3 <= 23 && f->up >= -24;
}

/* d 31 / 255 for |d| < 2^30, and d 63 / 255. */
static int32_t of_31(int32_t d)
{
    return (d >> 3) - (d >> 8);
}

static int32_t of_63(int32_t d)
{
    return (d >> 2) - (d >> 8);
}

static void channel(struct etch_plane *p, const struct fast *f, int32_t d1, int32_t d2, bool green)
{
    const int32_t nx = (d1 * f->y2 - d2 * f->y1) >> f->down,
                  ny = (d2 * f->x1 - d1 * f->x2) >> f->down;
    const int32_t sx = nx * f->reciprocal, sy = ny * f->reciprocal;
    const int32_t gx = green ? of_63(sx) : of_31(sx), gy = green ? of_63(sy) : of_31(sy);

    p->dx = etch_wrap_scale(gx, (int8_t)(f->up - (green ? 1 : 0)));
    p->dy = etch_wrap_scale(gy, (int8_t)(f->up - (green ? 1 : 0)));
    /* from vertex 0 to the centre of its pixel, then to the frame's origin */
    const int32_t fx = 128 - (f->a.x & 255), fy = 128 - (f->a.y & 255);
    const uint32_t fine = (uint32_t)(((int32_t)p->dx >> 8) * fx + ((int32_t)p->dy >> 8) * fy);

    p->origin = etch_wrap_sub(etch_wrap_add(p->origin, fine),
                              etch_wrap_add(etch_wrap_mul(p->dx, (uint32_t)(f->a.x >> 8)),
                                            etch_wrap_mul(p->dy, (uint32_t)(f->a.y >> 8))));
}

void candidate_triangle_fast(const struct etch_surface *s, const struct etch_vertex *const v[3],
                             etch_kernel *kernel)
{
    struct etch_gouraud_paint paint;
    struct etch_triangle t;
    struct fast f;

    if (!setup_visible(&t, s, v))
        return;
    paint.paint.kernel = kernel;
    if (prepare(&f, &t)) {
        const struct etch_vertex *const a = v[t.order[0]], *const b = v[t.order[1]];
        const struct etch_vertex *const c = v[t.order[2]];

        /* 1/8 step from the ends: 31 - 2/8 and 63 - 2/8 of 255 */
        paint.r.origin = a->r * UINT32_C(16185081) + (UINT32_C(5) << 24);
        paint.g.origin = a->g * UINT32_C(16514045) + (UINT32_C(5) << 23);
        paint.b.origin = a->b * UINT32_C(16185081) + (UINT32_C(5) << 24);
        channel(&paint.r, &f, b->r - a->r, c->r - a->r, false);
        channel(&paint.g, &f, b->g - a->g, c->g - a->g, true);
        channel(&paint.b, &f, b->b - a->b, c->b - a->b, false);
    } else {
        struct etch_basis basis;

        setup_color(&paint, &t, etch_basis_setup(&basis, &t) ? &basis : NULL, v);
    }
    etch_triangle_runs(s, &t, &paint.paint);
}
