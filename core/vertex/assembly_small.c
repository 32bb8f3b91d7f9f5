/* vertex/assembly_small.c: clip-space triangles to the sink in few bytes. Called by draw/mesh_small
 * and by applications. See assembly_small.h.
 * Source: I. Sutherland, G. Hodgman, "Reentrant polygon clipping", 1974. */
#include "assembly_small.h"
#include "project_small.h"

enum {
    PLANES = 6,
    COLOR = offsetof(struct etch_clip_vertex, r)
};

/* How far inside of plane i a vertex is: near, far, left, right, bottom, top, the latter pushed
 * out by `shift`. Below 2^42. */
static ETCH_COLD int64_t inside(const struct etch_clip_vertex *v, uint8_t i, uint8_t shift)
{
    const int64_t axis = i < 2 ? v->z : i < 4 ? v->x : v->y;

    return v->w * (INT64_C(1) << shift) + ((i & 1) != 0 ? -axis : axis);
}

/* a of_a + b of_b, for sums of weights up to 2^30. */
static int64_t mix(int32_t a, int32_t b, const int32_t of[2])
{
    return etch_mul_s32(a, of[0]) + etch_mul_s32(b, of[1]);
}

/* The point on a plane of the edge from a, `da` inside of it, to b, `db` outside: a db + b da of
 * any scale, so of one that takes 30 bits. */
static void cut(struct etch_clip_vertex *to, const struct etch_clip_vertex *a,
                const struct etch_clip_vertex *b, int64_t da, int64_t db)
{
    for (; (da | db) >> 29 != 0; da >>= 1)
        db >>= 1;

    const int32_t of[2] = {(int32_t)db, (int32_t)da};
    const etch_q16 *const from_a = (const void *)a, *const from_b = (const void *)b;
    const uint8_t *const color_a = (const uint8_t *)a + COLOR;
    const uint8_t *const color_b = (const uint8_t *)b + COLOR;
    etch_q16 *const to_axis = (void *)to; /* x, y, z, w, then r, g, b, a */
    uint8_t *const to_color = (uint8_t *)to + COLOR;
    const uint32_t sum = (uint32_t)(of[0] + of[1]);
    int64_t most = 0;
    uint8_t shift = 0;

    for (uint8_t i = 0; i < 4; i++) {
        const int64_t v = mix(from_a[i], from_b[i], of);

        most |= v ^ v >> 63;
    }
    for (; most >> 30 != 0; shift++)
        most >>= 1;
    for (uint8_t i = 0; i < 4; i++) {
        to_axis[i] = (int32_t)(mix(from_a[i], from_b[i], of) >> shift);
        to_color[i] = (uint8_t)etch_divide_small(
            (uint64_t)mix(color_a[i], color_b[i], of) + sum / 2, sum);
    }
}

/* Brings a vertex to a scale of 30 bits, so that weights of different ones compare. */
static ETCH_COLD void scale_up(struct etch_clip_vertex *v)
{
    for (uint8_t i = 0; i < 30; i++) {
        const etch_q16 x = v->x ^ v->x >> 31, y = v->y ^ v->y >> 31;
        const etch_q16 z = v->z ^ v->z >> 31, w = v->w ^ v->w >> 31;

        if ((x | y | z | w) >> 29 != 0)
            return;
        v->x *= 2, v->y *= 2, v->z *= 2, v->w *= 2;
    }
}

/* The part of from[0 .. n-1] inside of plane i. */
static ETCH_COLD uint8_t clip(struct etch_clip_vertex *to, const struct etch_clip_vertex *from,
                              uint8_t n, uint8_t i, uint8_t shift)
{
    const struct etch_clip_vertex *a = &from[n - 1];
    int64_t da = inside(a, i, shift);
    uint8_t count = 0;

    for (; n != 0; n--, from++) {
        const int64_t d = inside(from, i, shift);

        if (da >= 0 && d < 0)
            cut(&to[count++], a, from, da, -d);
        if (da < 0 && d >= 0)
            cut(&to[count++], from, a, d, -da);
        if (d >= 0)
            to[count++] = *from;
        a = from, da = d;
    }
    return count;
}

static ETCH_COLD void emit(const struct etch_assembly *assembly, const struct etch_vertex *a,
                           const struct etch_vertex *b, const struct etch_vertex *c)
{
    const struct etch_vertex *const v[3] = {a, b, c};
    const int64_t area = etch_mul_s32(b->x_q8 - a->x_q8, c->y_q8 - a->y_q8) -
                         etch_mul_s32(c->x_q8 - a->x_q8, b->y_q8 - a->y_q8);

    if (area != 0 &&
        assembly->cull != (area > 0 ? ETCH_CULL_CLOCKWISE : ETCH_CULL_COUNTER_CLOCKWISE))
        assembly->sink->triangle(assembly->sink, v);
}

/* Corners in clip space, and then on the screen. */
union polygon {
    struct etch_clip_vertex clip[ETCH_CLIP_MAX];
    struct etch_vertex screen[ETCH_CLIP_MAX];
};

void etch_assemble_triangle_small(const struct etch_assembly *assembly,
                                  const struct etch_clip_vertex v[3])
{
    const struct etch_viewport *const viewport = &assembly->viewport;
    union polygon polygon[2] = {{.clip = {v[0], v[1], v[2]}}};
    struct etch_vertex *const out = polygon[1].screen; /* the last plane leaves it free */
    uint8_t n = 3;

    for (uint8_t i = 0; i < PLANES; i++) {
        uint8_t k = 0;

        while (inside(&v[k], i, 0) < 0)
            if (++k == 3)
                return;
    }
    for (uint8_t i = 0; i < 3; i++)
        scale_up(&polygon[0].clip[i]);
    for (uint8_t i = 0; i < PLANES && n != 0; i++)
        n = clip(polygon[~i & 1].clip, polygon[i & 1].clip, n, i,
                 i < 2   ? 0
                 : i < 4 ? viewport->guard_x
                         : viewport->guard_y);
    for (uint8_t i = 0; i < n; i++) {
        struct etch_clip_vertex *const corner = &polygon[0].clip[i];

        if (corner->w <= 0) /* the eye itself: the triangle is seen edge-on */
            return;
        if (assembly->flat)
            corner->r = v[0].r, corner->g = v[0].g, corner->b = v[0].b, corner->a = v[0].a;
        etch_viewport_project_small(viewport, corner, &out[i]);
        if (i >= 2)
            emit(assembly, &out[0], &out[i - 1], &out[i]);
    }
}
