/* tests/unit: any partition of the frame gives the same pixels and depths: strips of 1, 7, 16 and
 * all rows, tiles, clip rectangles, and a frame drawn part by part through the scissor. */
#include "core/draw/shapes.h"
#include "core/draw/triangle.h"
#include "core/fragment/flat.h"
#include "core/fragment/gouraud.h"
#include "core/raster/circle.h"
#include "core/raster/line.h"
#include "core/raster/rect.h"
#include "tests/harness/canvas.h"
#include "tests/harness/shapes.h"

void suite_strips(void);

enum {
    WIDTH = 64,
    HEIGHT = 48
};

static const struct etch_rect frame = {0, 0, WIDTH, HEIGHT};
static struct test_canvas whole, part;
static int32_t scenes;

static int16_t coordinate(uint32_t *seed)
{
    return (int16_t)(test_range(seed, 0, 9) == 0 ? test_range(seed, INT16_MIN, INT16_MAX)
                                                 : test_range(seed, -20, 84));
}

static uint16_t user_weights(void *context, int16_t x, int16_t y, const uint32_t b_q16[3])
{
    (void)context;
    return (uint16_t)(1 | b_q16[0] >> 12 | (b_q16[1] >> 6 & 0x7E0) | (uint32_t)((x + y) & 6) << 11);
}

static void draw_2d(const struct etch_surface *s, int kind, uint32_t *seed)
{
    const int16_t x0 = coordinate(seed), y0 = coordinate(seed), x1 = coordinate(seed);
    const int16_t y1 = coordinate(seed), x2 = coordinate(seed), y2 = coordinate(seed);
    const uint16_t color = (uint16_t)test_random(seed);
    const struct etch_point p[4] = {{x0, y0}, {x1, y1}, {x2, y2}, {x0, y0}};

    switch (kind) {
    case 0: etch_line_draw(s, x0, y0, x1, y1, color); break;
    case 1: etch_circle_draw(s, x0, y0, x1, color); break;
    case 2: etch_circle_fill(s, x0, y0, (int16_t)(x1 / 4), color); break;
    case 3: etch_rect_draw(s, x0, y0, x1, y1, color); break;
    case 4: etch_rect_fill(s, x0, y0, (int16_t)(x1 / 4), (int16_t)(y1 / 4), color); break;
    case 5: etch_triangle_draw(s, x0, y0, x1, y1, x2, y2, color); break;
    case 6: etch_triangle_fill(s, x0, y0, x1, y1, x2, y2, color); break;
    case 7: etch_polyline_draw(s, p, 4, color); break;
    case 8: etch_hline_draw(s, x0, y0, x1, color); break;
    case 9: etch_vline_draw(s, x0, y0, y1, color); break;
    default: etch_point_draw(s, x0, y0, color); break;
    }
}

static void draw_3d(const struct etch_surface *s, int kind, uint32_t *seed)
{
    const enum test_triangle_kind shape = (enum test_triangle_kind)test_range(
        seed, 0, TEST_TRIANGLE_KINDS - 1);
    struct etch_vertex vertex[3];
    const struct etch_vertex *const v[3] = {&vertex[0], &vertex[1], &vertex[2]};
    struct test_triangle t;
    int i;

    test_triangle_make(&t, shape, frame, seed);
    for (i = 0; i < 3; i++) {
        const uint32_t bits = test_random(seed);

        vertex[i].x_q8 = t.x[i];
        vertex[i].y_q8 = t.y[i];
        vertex[i].z_q16 = test_random(seed) / 65537 * 65536;
        vertex[i].r = (uint8_t)(bits & 255);
        vertex[i].g = (uint8_t)(bits >> 8 & 255);
        vertex[i].b = (uint8_t)(bits >> 16 & 255);
        vertex[i].a = 255;
    }
    switch (kind) {
    case 0: etch_triangle_flat(s, v, etch_kernel_flat); break;
    case 1: etch_triangle_flat_depth(s, v, etch_kernel_flat_less); break;
    case 2: etch_triangle_gouraud(s, v, etch_kernel_gouraud); break;
    case 3: etch_triangle_gouraud_depth(s, v, etch_kernel_gouraud_less); break;
    case 4: etch_triangle_gouraud_depth(s, v, etch_kernel_gouraud_lequal); break;
    default: etch_triangle_barycentric(s, v, user_weights, NULL); break;
    }
}

/* The same primitives for the same seed, whatever surface they go to. */
static void draw_scene(const struct etch_surface *s, uint32_t seed)
{
    int i;

    for (i = 0; i < 24; i++) {
        const int kind = test_range(&seed, 0, 21);

        if (kind < 11)
            draw_2d(s, kind, &seed);
        else
            draw_3d(s, kind % 6, &seed);
    }
}

/* Wherever `part` holds a pixel of the frame, it is that of `whole`. */
static bool part_equals_whole(void)
{
    const struct etch_rect w = part.surface.clip;
    int32_t x, y;

    for (y = w.y0; y < w.y1; y++) {
        for (x = w.x0; x < w.x1; x++) {
            const size_t a = etch_surface_index(&part.surface, (int16_t)x, (int16_t)y);
            const size_t b = etch_surface_index(&whole.surface, (int16_t)x, (int16_t)y);

            if (part.surface.pixels[a] != whole.surface.pixels[b] ||
                part.surface.depth[a] != whole.surface.depth[b])
                return false;
        }
    }
    return true;
}

static void compare_part(struct etch_rect window, struct etch_rect clip, uint32_t seed)
{
    test_canvas_open(&part, window);
    test_canvas_clip(&part, clip);
    draw_scene(&part.surface, seed);
    if (!CHECK(part_equals_whole())) {
        test_note("seed", seed);
        test_note("window y0", window.y0);
        test_note("window y1", window.y1);
    }
    CHECK_INSIDE(&part);
}

static void open_whole(uint32_t seed)
{
    test_canvas_open(&whole, frame);
    draw_scene(&whole.surface, seed);
    CHECK_INSIDE(&whole);
    scenes++;
}

static void strips_of(int16_t rows, uint32_t first)
{
    uint32_t seed;

    for (seed = first; seed < first + (uint32_t)TEST_COUNT(1000) && !test_failed(); seed++) {
        int16_t y;

        open_whole(seed);
        for (y = 0; y < HEIGHT; y = (int16_t)(y + rows)) {
            const struct etch_rect strip = {0, y, WIDTH,
                                            (int16_t)(y + rows < HEIGHT ? y + rows : HEIGHT)};

            compare_part(strip, strip, seed);
        }
    }
}

static void strips_of_1(void)
{
    strips_of(1, 1);
}

static void strips_of_7(void)
{
    strips_of(7, 2001);
}

static void strips_of_16(void)
{
    strips_of(16, 4001);
}

static void strips_of_all_rows(void)
{
    strips_of(HEIGHT, 6001);
}

/* Windows that are tiles of the frame, some with a clip inside. */
static void tiles_and_clips(void)
{
    uint32_t seed, state = 5;

    for (seed = 10000; seed < 10000 + (uint32_t)TEST_COUNT(4000) && !test_failed(); seed++) {
        const int16_t x0 = (int16_t)test_range(&state, 0, WIDTH - 1);
        const int16_t y0 = (int16_t)test_range(&state, 0, HEIGHT - 1);
        const struct etch_rect window = {x0, y0, (int16_t)test_range(&state, x0 + 1, WIDTH),
                                         (int16_t)test_range(&state, y0 + 1, HEIGHT)};
        const struct etch_rect clip = {(int16_t)(window.x0 + test_range(&state, -3, 9)),
                                       (int16_t)(window.y0 + test_range(&state, -3, 9)),
                                       (int16_t)(window.x1 - test_range(&state, -3, 9)), window.y1};

        open_whole(seed);
        compare_part(window, seed % 2 == 0 ? window : clip, seed);
    }
}

/* One surface, the scissor moved over it in four parts: the frame as drawn at once. */
static void scissor_parts(void)
{
    uint32_t seed, state = 6;

    for (seed = 20000; seed < 20000 + (uint32_t)TEST_COUNT(2000) && !test_failed(); seed++) {
        const int16_t x = (int16_t)test_range(&state, 0, WIDTH);
        const int16_t y = (int16_t)test_range(&state, 0, HEIGHT);
        const struct etch_rect parts[4] = {{INT16_MIN, INT16_MIN, x, y},
                                           {x, INT16_MIN, INT16_MAX, y},
                                           {INT16_MIN, y, x, INT16_MAX},
                                           {x, y, INT16_MAX, INT16_MAX}};
        int i;

        open_whole(seed);
        test_canvas_open(&part, frame);
        for (i = 0; i < 4; i++) {
            etch_surface_clip(&part.surface, parts[i]);
            draw_scene(&part.surface, seed);
        }
        etch_surface_clip(&part.surface, frame);
        if (!CHECK(part_equals_whole()))
            test_note("seed", seed);
        CHECK_INSIDE(&part);
    }
}

void suite_strips(void)
{
    scenes = 0;
    RUN(strips_of_1);
    RUN(strips_of_7);
    RUN(strips_of_16);
    RUN(strips_of_all_rows);
    RUN(tiles_and_clips);
    RUN(scissor_parts);
    test_print_count("", scenes, " scenes whole and in parts, the same pixels and depths");
}
