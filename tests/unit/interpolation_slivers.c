/* tests/unit: how thin a near triangle may be for the colour planes of one reciprocal
 * (raster/basis_color.c): where etch_basis_color takes a triangle, its planes err by less than
 * 3/2048 step at every pixel, so that no colour leaves the rounded range of its vertices: for 8-bit
 * colours the next place where rounding changes is at least 1/510 step away. */
#include "core/draw/triangle.h"
#include "core/fragment/gouraud.h"
#include "core/raster/basis.h"
#include "tests/harness/canvas.h"
#include "tests/harness/sample.h"

void suite_interpolation_slivers(void);

static struct test_canvas canvas;
static int32_t pixels, planes;
static uint32_t worst; /* error of a plane, in 2^-27 of a step */

/* A sliver round the centre of a pixel of the window, which lies on or just inside the edge of
 * vertices 0 and 1: as long as a near triangle may be, a few units thick. The planes are anchored
 * at the top: the pixel is near one of the ends. */
static void make_sliver(struct test_triangle *t, struct etch_rect w, uint32_t *seed)
{
    const int32_t x = 256 * test_range(seed, w.x0, w.x1 - 1) + 128;
    const int32_t y = 256 * test_range(seed, w.y0, w.y1 - 1) + 128;
    const int32_t reach = INT32_C(1) << test_range(seed, 10, 16);
    const int32_t side = test_range(seed, 0, 1) ? 1 : -1;
    const int32_t dx = side * test_range(seed, reach / 2, reach - 1);
    const int32_t dy = test_range(seed, reach / 2, reach - 1);
    const int32_t at = test_range(seed, 0, 64), thick = 1 << test_range(seed, 0, 3);

    t->x[0] = x - test_range(seed, 0, 1) * side;
    t->y[0] = y - test_range(seed, 0, 1);
    t->x[1] = t->x[0] + dx;
    t->y[1] = t->y[0] + dy;
    if (test_range(seed, 0, 1)) { /* the pixel at the lower end */
        t->x[1] = t->x[0] - dx;
        t->y[1] = t->y[0] - dy;
    }
    t->x[2] = (int32_t)(t->x[0] + (int64_t)(t->x[1] - t->x[0]) * at / 64) +
              test_range(seed, -thick, thick);
    t->y[2] = (int32_t)(t->y[0] + (int64_t)(t->y[1] - t->y[0]) * at / 64) +
              test_range(seed, -thick, thick);
}

/* Pairs of equal colours and a third: 37 and 218 are 4 + 127/255 and 27 - 127/255 steps of red and
 * blue, as near to where rounding changes as 8-bit channels come. */
static void color_pairs(struct etch_vertex v[3], uint32_t *seed)
{
    const uint8_t odd = (uint8_t)test_range(seed, 0, 2);
    uint8_t k;

    for (k = 0; k < 3; k++) {
        v[k].r = k == odd ? 255 : 218;
        v[k].g = k == odd ? 0 : 255;
        v[k].b = k == odd ? 0 : 37;
    }
}

/* |plane - 1/2 - exact| <= 3/2048 step at a covered pixel, for `full` steps in units of 2^-bits.
 * Both times 255 area and 2^32 units more, so that nothing is below 0. */
static bool plane_ok(const struct test_sample *s, int32_t x, int32_t y, const struct etch_plane *p,
                     const uint32_t c[3], uint32_t full, int bits)
{
    const uint32_t step = UINT32_C(1) << bits;
    const uint32_t got = etch_wrap_sub(etch_plane_at(p, (int16_t)x, (int16_t)y), step / 2);
    const uint64_t more = got > full * step + step / 2 ? 0 : UINT64_C(1) << 32; /* below 0 or not */
    const struct wide whole = wide_scale(wide_product((uint64_t)s->exact.area, 1), 255);
    const struct wide mine = wide_scale(wide_product((uint64_t)s->exact.area, got + more), 255);
    const struct wide exact = wide_sum(
        wide_scale(oracle_triangle_value(&s->exact, x, y, c), full * step),
        wide_product(whole.lo, UINT64_C(1) << 32));
    const struct wide error = wide_distance(mine, exact);

    pixels++;
    while (worst < step && !wide_at_most(error, wide_scale(whole, worst >> (27 - bits))))
        worst += 1024;
    return wide_at_most(error, wide_scale(whole, step / 2048 * 3));
}

/* The planes, where the triangle has them, and the drawn colours of every covered pixel. */
static void check_sliver(const struct test_sample *s, const struct etch_plane planes_rgb[3])
{
    const struct etch_rect clip = canvas.surface.clip;
    const struct etch_vertex *v = s->vertex;
    const uint32_t r[3] = {v[0].r, v[1].r, v[2].r}, g[3] = {v[0].g, v[1].g, v[2].g};
    const uint32_t b[3] = {v[0].b, v[1].b, v[2].b};
    int32_t x, y;

    for (y = clip.y0; y < clip.y1; y++) {
        for (x = clip.x0; x < clip.x1; x++) {
            const uint16_t color = test_canvas_at(&canvas, x, y);

            if (!oracle_triangle_covers(&s->exact, x, y))
                continue;
            if (!CHECK(color >> 11 >= 27 && (color & 31) <= 4) ||
                (planes_rgb != NULL && (!CHECK(plane_ok(s, x, y, &planes_rgb[0], r, 31, 27)) ||
                                        !CHECK(plane_ok(s, x, y, &planes_rgb[1], g, 63, 26)) ||
                                        !CHECK(plane_ok(s, x, y, &planes_rgb[2], b, 31, 27)))))
                test_sample_note(s, x, y);
        }
    }
}

static void slivers_stay_in_range(void)
{
    static const struct etch_rect window = {300, 200, 308, 206};
    uint32_t seed = 49;
    int32_t i;

    test_canvas_open(&canvas, window);
    for (i = 0; i < TEST_COUNT(300000) && !test_failed(); i++) {
        struct test_sample s;
        const struct etch_vertex *const v[3] = {&s.vertex[0], &s.vertex[1], &s.vertex[2]};
        struct etch_plane rgb[3];
        struct etch_point_q8 p[3];
        struct etch_triangle t;
        struct etch_basis basis;
        int k;

        make_sliver(&s.shape, window, &seed);
        oracle_triangle_make(&s.exact, s.shape.x, s.shape.y);
        for (k = 0; k < 3; k++) {
            s.vertex[k].x_q8 = p[k].x = s.shape.x[k];
            s.vertex[k].y_q8 = p[k].y = s.shape.y[k];
            s.vertex[k].z_q16 = 0;
            s.vertex[k].a = 255;
        }
        color_pairs(s.vertex, &seed);
        if (!etch_triangle_setup(&t, p) || !etch_triangle_is_visible(&t, &window))
            continue;
        etch_triangle_gouraud(&canvas.surface, v, etch_kernel_gouraud);
        if (etch_basis_setup(&basis, &t) &&
            etch_basis_color(&basis, &t, v, &rgb[0], &rgb[1], &rgb[2]))
            check_sliver(&s, rgb), planes++;
        else
            check_sliver(&s, NULL);
    }
}

void suite_interpolation_slivers(void)
{
    pixels = planes = 0;
    worst = 0;
    RUN(slivers_stay_in_range);
    test_print_count("", planes, " slivers by one reciprocal");
    test_print_count("", pixels, " planes at pixels against exact rationals");
    test_print_count("largest error ", worst / 1024, "/131072 step, allowed 192");
}
