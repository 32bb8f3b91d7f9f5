/* bench/leaves.c: do the leaf loops of ARMv6-M write what the portable C does? Both are linked, the
 * portable functions under the names portable_*, and get the same seeded arguments. Ends with
 * status 0 if no element differs. See `make bench-leaves`. */
#include "bench.h"

#include "../../core/base/fill.h"
#include "../../core/fragment/depth_rows.h"
#include "../../core/fragment/flat.h"
#include "../../core/fragment/gouraud_narrow.h"
#include "../../core/raster/basis.h"
#include "../../core/raster/edge.h"
#include "../../core/raster/line_walk.h"
#include "../../core/raster/octant.h"

#define WORDS 20000

int main(void);
void portable_etch_fill_rows(uint16_t *p, uint32_t n, uint16_t value, uint32_t rows, size_t stride);
void portable_etch_line_walk(uint16_t *p, uint32_t n, ptrdiff_t along, ptrdiff_t aside, int32_t e,
                             int32_t du, int32_t dv, uint16_t color);
etch_depth_rows portable_etch_depth_rows_less, portable_etch_depth_rows_lequal;
etch_kernel portable_etch_gouraud_narrow_less, portable_etch_gouraud_narrow_lequal;
int16_t *portable_etch_edge_run(struct etch_point_q8 a, struct etch_point_q8 b, int16_t *out,
                                int32_t n);
bool portable_etch_basis_color(const struct etch_basis *b, const struct etch_triangle *t,
                               const struct etch_vertex *const v[3], struct etch_plane *red,
                               struct etch_plane *green, struct etch_plane *blue);
etch_kernel portable_etch_kernel_flat, portable_etch_kernel_gouraud;

void portable_etch_circle_whole(uint16_t *centre, ptrdiff_t row, int32_t r, int32_t end,
                                int32_t steep_end, uint16_t color);

static uint32_t leaf[WORDS], portable[WORDS], seed;

static uint32_t below(uint32_t n)
{
    return wl_next(&seed) % n;
}

static void wipe(void)
{
    for (int i = 0; i < WORDS; i++)
        leaf[i] = portable[i] = 0x01010101;
}

static bool differ(void)
{
    for (int i = 0; i < WORDS; i++)
        if (leaf[i] != portable[i])
            return true;
    return false;
}

/* Rows of every alignment, up to 40 or 3000 wide, strides odd and even. */
static bool fill_differs(uint32_t widest)
{
    const uint32_t n = 1 + below(widest), stride = n + below(5), rows = 1 + below(6);
    const uint32_t at = below(9);
    const uint16_t value = (uint16_t)wl_next(&seed);

    wipe();
    etch_fill_rows((uint16_t *)leaf + at, n, value, rows, stride);
    portable_etch_fill_rows((uint16_t *)portable + at, n, value, rows, stride);
    return differ();
}

/* What runs are made of: they begin within `spread` columns and are `least` pixels or more,
 * `widest` less one at most. */
struct shape {
    uint32_t spread, least, widest;
};

/* A block of runs, some empty, on a window that begins anywhere. */
static bool kernel_differs(etch_kernel *a, etch_kernel *b, const struct etch_paint *paint,
                           struct shape shape)
{
    const int16_t x = (int16_t)below(20), y = (int16_t)below(20);
    const struct etch_rect window = {x, y, (int16_t)(x + 700), (int16_t)(y + 40)};
    const uint8_t n = (uint8_t)(1 + below(ETCH_RUN_BLOCK));
    const int16_t y0 = (int16_t)(y + (int16_t)below(8));
    struct etch_run runs[ETCH_RUN_BLOCK];
    struct etch_surface s, t;

    if (etch_surface_init(&s, (uint16_t *)leaf, window, (uint16_t)(700 + below(3))) != ETCH_OK)
        return true;
    t = s;
    t.pixels = (uint16_t *)portable;
    for (uint8_t i = 0; i < n; i++) {
        runs[i].x0 = (int16_t)(x + (int16_t)below(shape.spread));
        runs[i].x1 = (int16_t)(runs[i].x0 + (int16_t)shape.least +
                               (int16_t)below(shape.widest - shape.least));
    }
    wipe();
    a(&s, y0, runs, n, paint);
    b(&t, y0, runs, n, paint);
    return differ();
}

static struct etch_plane plane(void)
{
    const struct etch_plane p = {wl_next(&seed), wl_next(&seed), wl_next(&seed)};

    return p;
}

/* One that keeps its range in columns 0 .. 719 and rows 0 .. 59, with steps up or down. */
static struct etch_plane gentle_plane(void)
{
    const struct etch_plane p = {(UINT32_C(1) << 31) + below(1 << 20), below(1 << 22) - (1 << 21),
                                 below(1 << 22) - (1 << 21)};

    return p;
}

/* One that nearly uses up its range in columns 0 .. 59. */
static struct etch_plane steep_plane(void)
{
    const uint32_t step = below(UINT32_MAX / 60);
    const struct etch_plane rises = {below(1 << 20), step, 0};
    const struct etch_plane falls = {UINT32_MAX - below(1 << 20), 0 - step, 0};

    return below(2) == 0 ? rises : falls;
}

static bool gouraud_differs(struct etch_plane (*make)(void), struct shape shape)
{
    const struct etch_gouraud_paint paint = {
        {etch_kernel_gouraud}, {0, 0, 0}, make(), make(), make()};

    return kernel_differs(etch_kernel_gouraud, portable_etch_kernel_gouraud, &paint.paint, shape);
}

/* Pixels that say where they are and which paint they had, however spans are cut. */
static void trace(uint16_t *pixel, int32_t x, uint32_t n, int32_t y, const struct etch_paint *paint)
{
    const struct etch_depth_paint *const p = (const struct etch_depth_paint *)paint;

    for (uint32_t i = 0; i < n; i++)
        pixel[i] = (uint16_t)((uint32_t)x * 31 + i * 31 + (uint32_t)y * 1009 + p->z.dx);
}

#define TRACED(name, rows)                                                                         \
    static void name(const struct etch_surface *surface, int16_t y0, const struct etch_run *runs,  \
                     uint8_t n, const struct etch_paint *paint)                                    \
    {                                                                                              \
        rows(surface, y0, runs, n, paint, trace);                                                  \
    }

TRACED(leaf_less, etch_depth_rows_less)
TRACED(leaf_lequal, etch_depth_rows_lequal)
TRACED(portable_less, portable_etch_depth_rows_less)
TRACED(portable_lequal, portable_etch_depth_rows_lequal)

/* Depths round those of a plane, many of them equal; of planes near 0 the first ones below one. */
static bool depth_differs(etch_kernel *a, etch_kernel *b, bool near)
{
    const int16_t x = (int16_t)below(20), y = (int16_t)below(20);
    const struct etch_rect window = {x, y, (int16_t)(x + 200), (int16_t)(y + 40)};
    const uint8_t n = (uint8_t)(1 + below(ETCH_RUN_BLOCK));
    const int16_t y0 = (int16_t)(y + (int16_t)below(8));
    struct etch_gouraud_paint paint = {{NULL}, {0, 0, 0}, plane(), plane(), plane()};
    struct etch_run runs[ETCH_RUN_BLOCK];
    struct etch_surface s, t;

    paint.z.dx = near ? below(1 << 14) : below(1 << 20) - (1 << 19);
    paint.z.dy = near ? below(1 << 14) : below(1 << 20) - (1 << 19);
    paint.z.origin = (near ? below(1 << 16) : UINT32_C(9000) << 16);
    if (etch_surface_init(&s, (uint16_t *)leaf, window, (uint16_t)(200 + below(3))) != ETCH_OK)
        return true;
    t = s;
    t.pixels = (uint16_t *)portable;
    wipe();
    s.depth = (uint16_t *)leaf + 20000 + below(2);
    t.depth = (uint16_t *)portable + (s.depth - (uint16_t *)leaf);
    for (int16_t row = y; row < y + 40; row++)
        for (int16_t column = x; column < x + 200; column++) {
            const size_t i = etch_surface_index(&s, column, row);
            const uint32_t z = etch_plane_at(&paint.z, column, row) >> 16;

            s.depth[i] = t.depth[i] = (uint16_t)(z + 3 > below(7) ? z + 3 - below(7) : 0);
        }
    for (uint8_t i = 0; i < n; i++) {
        runs[i].x0 = (int16_t)(x + (int16_t)below(90));
        runs[i].x1 = (int16_t)(runs[i].x0 + (int16_t)below(110));
    }
    a(&s, y0, runs, n, &paint.paint);
    b(&t, y0, runs, n, &paint.paint);
    return differ();
}

static bool line_differs(void)
{
    static const int16_t step[4] = {1, -1, 200, -200};
    const uint32_t n = below(60);
    const int32_t du = (int32_t)(n + below(9) + 1), dv = (int32_t)below((uint32_t)du / 2 + 1);
    const int32_t e = -1 - (int32_t)below((uint32_t)du);
    const ptrdiff_t along = step[below(4)], aside = along + step[below(4)];
    const uint16_t color = (uint16_t)wl_next(&seed);

    wipe();
    etch_line_walk((uint16_t *)leaf + WORDS, n, along, aside, e, du, dv, color);
    portable_etch_line_walk((uint16_t *)portable + WORDS, n, along, aside, e, du, dv, color);
    return differ();
}

/* Every radius that fits. */
static bool circle_differs(void)
{
    const int32_t r = 1 + (int32_t)below(80), end = octant_end(r);
    const int32_t steep_end = end - octant_meets_diagonal(r, end);
    const ptrdiff_t row = 2 * r + 1 + (ptrdiff_t)below(9);
    const uint16_t color = (uint16_t)wl_next(&seed);

    wipe();
    etch_circle_whole((uint16_t *)leaf + WORDS, row, r, end, steep_end, color);
    portable_etch_circle_whole((uint16_t *)portable + WORDS, row, r, end, steep_end, color);
    return differ();
}

/* Edges of every slope. */
static bool edge_differs(void)
{
    const uint32_t wide = UINT32_C(1) << below(23), tall = UINT32_C(1) << below(14);
    const struct etch_point_q8 a = {(int32_t)below(1 << 22) - (1 << 21), (int32_t)below(1 << 22)};
    const struct etch_point_q8 b = {a.x + (int32_t)below(2 * wide + 1) - (int32_t)wide,
                                    a.y + 1 + (int32_t)below(tall)};
    const int32_t n = 1 + (int32_t)below(ETCH_RUN_BLOCK);

    wipe();
    return etch_edge_run(a, b, (int16_t *)leaf, n) - (int16_t *)leaf !=
               portable_etch_edge_run(a, b, (int16_t *)portable, n) - (int16_t *)portable ||
           differ();
}

/* Planes of triangles of every size and thickness, in and off the middle of pixels. */
static bool basis_differs(void)
{
    const uint32_t size = UINT32_C(1) << (2 + below(17)), place = 1 + below(1 << 20);
    const uint32_t grid = below(2) == 0 ? 1 : 256;
    struct etch_vertex vertex[3];
    const struct etch_vertex *const v[3] = {&vertex[0], &vertex[1], &vertex[2]};
    struct etch_point_q8 p[3];
    struct etch_triangle t;
    struct etch_basis b;
    struct etch_plane planes[2][3];

    for (uint8_t i = 0; i < 3; i++) {
        p[i].x = (int32_t)((place + below(size)) / grid * grid + 128);
        p[i].y = (int32_t)((place + below(size)) / grid * grid + 128);
        vertex[i].r = (uint8_t)wl_next(&seed);
        vertex[i].g = (uint8_t)wl_next(&seed);
        vertex[i].b = (uint8_t)wl_next(&seed);
    }
    if (!etch_triangle_setup(&t, p) || !etch_basis_setup(&b, &t))
        return false;

    const bool near = etch_basis_color(&b, &t, v, &planes[0][0], &planes[0][1], &planes[0][2]);

    if (near != portable_etch_basis_color(&b, &t, v, &planes[1][0], &planes[1][1], &planes[1][2]))
        return true;
    for (uint8_t i = 0; i < 3; i++)
        if (near && (planes[0][i].origin != planes[1][i].origin ||
                     planes[0][i].dx != planes[1][i].dx || planes[0][i].dy != planes[1][i].dy))
            return true;
    return false;
}

int main(void)
{
    seed = 1;
    for (uint32_t i = 0; i < 300; i++) {
        const struct etch_flat_paint flat = {{etch_kernel_flat}, (uint16_t)wl_next(&seed)};
        const struct shape narrow = {90, 0, 12}, wide = {90, 0, 600}, steep = {4, 26, 36};

        if (fill_differs(i % 2 == 0 ? 40 : 3000))
            return 1;
        if (kernel_differs(etch_kernel_flat, portable_etch_kernel_flat, &flat.paint,
                           i % 2 == 0 ? narrow : wide))
            return 2;
        if (gouraud_differs(plane, narrow) || gouraud_differs(gentle_plane, wide) ||
            gouraud_differs(steep_plane, steep))
            return 3;
        if (line_differs())
            return 4;
        if (circle_differs())
            return 8;
        if (depth_differs(leaf_less, portable_less, i % 2 == 0))
            return 5;
        if (depth_differs(leaf_lequal, portable_lequal, i % 2 == 0))
            return 6;
        if (depth_differs(etch_gouraud_narrow_less, portable_etch_gouraud_narrow_less, i % 2 == 0))
            return 7;
        if (depth_differs(etch_gouraud_narrow_lequal, portable_etch_gouraud_narrow_lequal,
                          i % 2 == 0))
            return 8;
        for (uint32_t k = 0; k < 4; k++)
            if (edge_differs())
                return 9;
        for (uint32_t k = 0; k < 4; k++)
            if (basis_differs())
                return 10;
    }
    return 0;
}
