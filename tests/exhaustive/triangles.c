/* tests/exhaustive: every triangle of a small grid, by edge functions. See grid.h. */
#include "core/etch.h"
#include "core/raster/triangle_small.h"
#include "grid.h"

enum {
    QUARTERS = 17,
    POINTS = QUARTERS * QUARTERS,
    SIDE = 4,
    PIXELS = SIDE * SIDE
};

/* Whether (x, y) is on the inner side of the edge a b of a clockwise triangle, top and left edges
 * included. */
static bool is_inside(const struct etch_point_q8 *a, const struct etch_point_q8 *b, int64_t x,
                      int64_t y)
{
    const int64_t dx = b->x - a->x, dy = b->y - a->y, e = dx * (y - a->y) - dy * (x - a->x);

    return e > 0 || (e == 0 && (dy < 0 || (dy == 0 && dx > 0)));
}

/* A bit for each pixel of the clip that is covered. */
static uint32_t covered(const struct etch_point_q8 v[3], const struct etch_rect *clip)
{
    const int64_t area = (int64_t)(v[1].x - v[0].x) * (v[2].y - v[0].y) -
                         (int64_t)(v[2].x - v[0].x) * (v[1].y - v[0].y);
    const struct etch_point_q8 *b = area > 0 ? v + 1 : v + 2, *c = area > 0 ? v + 2 : v + 1;
    uint32_t mask = 0;

    if (area == 0)
        return 0;
    for (int16_t j = clip->y0; j < clip->y1; j++)
        for (int16_t i = clip->x0; i < clip->x1; i++) {
            const int64_t x = i * 256 + 128, y = j * 256 + 128;

            if (is_inside(v, b, x, y) && is_inside(b, c, x, y) && is_inside(c, v, x, y))
                mask |= UINT32_C(1) << (j * SIDE + i);
        }
    return mask;
}

static uint32_t taken(uint16_t pixels[PIXELS])
{
    uint32_t mask = 0;

    for (int i = 0; i < PIXELS; i++) {
        mask |= (uint32_t)pixels[i] << i;
        pixels[i] = 0;
    }
    return mask;
}

static bool is_right(const struct etch_point_q8 v[3], struct etch_rect clip)
{
    const struct etch_flat_paint paint = {{etch_kernel_flat}, 1};
    uint16_t pixels[PIXELS] = {0};
    struct etch_surface s;
    struct etch_point_q16 corner[3];
    const uint32_t mask = covered(v, &clip);

    (void)etch_surface_init(&s, pixels, (struct etch_rect){0, 0, SIDE, SIDE}, SIDE);
    s.clip = clip;
    for (int i = 0; i < 3; i++)
        corner[i] = (struct etch_point_q16){(etch_q16)(v[i].x * 256), (etch_q16)(v[i].y * 256)};
    etch_triangle_fill_q16(&s, corner, 1);
    if (taken(pixels) != mask)
        return false;
    etch_triangle_runs_small(&s, v, &paint.paint);
    return taken(pixels) == mask;
}

/* -32 .. 31, from the bits of a number. */
static int32_t move(uint64_t bits)
{
    return (int32_t)(bits & 63) - 32;
}

static struct grid_count triangles(int64_t first, int64_t step, bool moved)
{
    struct grid_count count = {0, 0};

    for (int64_t n = first; n < (int64_t)POINTS * POINTS * POINTS; n += step) {
        const int32_t point[3] = {(int32_t)(n % POINTS), (int32_t)(n / POINTS % POINTS),
                                  (int32_t)(n / POINTS / POINTS)};
        const uint64_t chance = moved ? (uint64_t)n * UINT64_C(0x5851F42D4D) >> 20 : 0;
        const bool clipped = (chance >> 36 & 1) != 0;
        struct etch_point_q8 v[3];

        for (int i = 0; i < 3; i++) {
            v[i].x = point[i] % QUARTERS * 64 + (moved ? move(chance >> 12 * i) : 0);
            v[i].y = point[i] / QUARTERS * 64 + (moved ? move(chance >> (12 * i + 6)) : 0);
        }
        count.tried++;
        if (!is_right(v, clipped ? (struct etch_rect){1, 1, 3, SIDE}
                                 : (struct etch_rect){0, 0, SIDE, SIDE}))
            count.wrong++;
    }
    return count;
}

struct grid_count grid_triangles(int64_t first, int64_t step)
{
    return triangles(first, step, false);
}

struct grid_count grid_triangles_moved(int64_t first, int64_t step)
{
    return triangles(first, step, true);
}
