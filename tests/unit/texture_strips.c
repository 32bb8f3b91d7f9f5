/* tests/unit: textured triangles drawn in parts: strips, clips and the order of the vertices change
 * neither a colour nor a depth, equal w give the affine pixels, and what passes the depth test is
 * what passes it in one colour. */
#include "core/draw/texture.h"
#include "core/draw/texture_small.h"
#include "core/draw/triangle.h"
#include "core/fragment/flat.h"
#include "core/fragment/texture_small.h"
#include "tests/harness/canvas.h"
#include "tests/harness/shapes.h"

void suite_texture_strips(void);

enum {
    WIDTH = 64,
    HEIGHT = 48
};

static const struct etch_rect frame = {0, 0, WIDTH, HEIGHT};
static struct test_canvas whole, part;
static uint16_t texels[1024];
static const struct etch_texture texture = {texels, 5, 5};

/* Two triangles, the second against the depths of the first. */
static struct etch_texture_vertex scene[2][3];

static void make_scene(bool equal_w, uint32_t *seed)
{
    const int32_t most_w = 1 << test_range(seed, 4, 16);
    int i, k;

    for (i = 0; i < 1024; i++)
        texels[i] = (uint16_t)test_random(seed);
    for (i = 0; i < 2; i++) {
        const enum test_triangle_kind shape = (enum test_triangle_kind)test_range(
            seed, 0, TEST_TRIANGLE_KINDS - 1);
        const uint32_t w = (uint32_t)test_range(seed, 1, most_w);
        struct test_triangle t;

        test_triangle_make(&t, shape, frame, seed);
        for (k = 0; k < 3; k++) {
            const struct etch_texture_vertex v = {
                {t.x[k], t.y[k], (uint32_t)test_range(seed, 0, 65535) << 16, 0, 0, 0, 255},
                test_range(seed, -100 * 65536, 100 * 65536),
                test_range(seed, -2, 2) * 65536,
                equal_w ? w : (uint32_t)test_range(seed, 1, most_w)};

            scene[i][k] = v;
        }
    }
}

static void draw_one(const struct etch_surface *s, const struct etch_texture_vertex *const v[3],
                     int painter)
{
    switch (painter) {
    case 0: etch_triangle_texture(s, v, &texture, etch_kernel_texture); break;
    case 1: etch_triangle_texture_depth(s, v, &texture, etch_kernel_texture_less); break;
    case 2: etch_triangle_texture_depth(s, v, &texture, etch_kernel_texture_lequal); break;
    case 3: etch_triangle_perspective(s, v, &texture, &etch_perspective); break;
    case 4: etch_triangle_perspective_depth(s, v, &texture, &etch_perspective_less); break;
    case 5: etch_triangle_perspective_depth(s, v, &texture, &etch_perspective_lequal); break;
    case 6: etch_triangle_perspective(s, v, &texture, &etch_perspective_exact); break;
    case 7: etch_triangle_perspective_depth(s, v, &texture, &etch_perspective_exact_less); break;
    case 9:
        etch_triangle_perspective_depth_small(s, v, &texture, etch_kernel_perspective_less_small);
        break;
    default: etch_triangle_perspective_depth(s, v, &texture, &etch_perspective_exact_lequal); break;
    }
}

static void draw(const struct etch_surface *s, int painter, const uint8_t order[3])
{
    int i;

    for (i = 0; i < 2; i++) {
        const struct etch_texture_vertex *const v[3] = {&scene[i][order[0]], &scene[i][order[1]],
                                                        &scene[i][order[2]]};

        draw_one(s, v, painter);
    }
}

static void same_as_whole(const struct etch_rect *r, int painter)
{
    int32_t x, y, wrong = 0;

    for (y = r->y0; y < r->y1; y++) {
        for (x = r->x0; x < r->x1; x++) {
            const size_t here = etch_surface_index(&part.surface, (int16_t)x, (int16_t)y);
            const size_t there = etch_surface_index(&whole.surface, (int16_t)x, (int16_t)y);

            wrong += part.surface.pixels[here] != whole.surface.pixels[there] ||
                     part.surface.depth[here] != whole.surface.depth[there];
        }
    }
    if (!CHECK_EQ(wrong, 0))
        test_note("painter", painter);
    CHECK_INSIDE(&part);
}

static void strips_and_clips_change_nothing(void)
{
    uint32_t seed = 61;
    int32_t i;

    for (i = 0; i < TEST_COUNT(1800) && !test_failed(); i++) {
        const int painter = i % 10;
        const int16_t rows = (int16_t)test_range(&seed, 1, 20);
        int16_t y;

        make_scene(false, &seed);
        test_canvas_open(&whole, frame);
        draw(&whole.surface, painter, test_orders[0]);
        for (y = 0; y < HEIGHT; y = (int16_t)(y + rows)) {
            const struct etch_rect strip = {0, y, WIDTH,
                                            (int16_t)(y + rows < HEIGHT ? y + rows : HEIGHT)};
            const int16_t x0 = (int16_t)test_range(&seed, 0, WIDTH - 1);
            const struct etch_rect clip = {x0, y, (int16_t)test_range(&seed, x0 + 1, WIDTH),
                                           strip.y1};

            test_canvas_open(&part, strip);
            draw(&part.surface, painter, test_orders[test_range(&seed, 0, 5)]);
            same_as_whole(&strip, painter);
            test_canvas_clip(&part, clip);
            draw(&part.surface, painter, test_orders[0]);
            same_as_whole(&clip, painter);
        }
    }
}

static void equal_w_give_the_affine_pixels(void)
{
    uint32_t seed = 62;
    int32_t i;

    for (i = 0; i < TEST_COUNT(900) && !test_failed(); i++) {
        const int painter = 3 + i % 6;

        make_scene(true, &seed);
        test_canvas_open(&whole, frame);
        draw(&whole.surface, painter % 3, test_orders[0]);
        test_canvas_open(&part, frame);
        draw(&part.surface, painter, test_orders[0]);
        same_as_whole(&frame, painter);
    }
}

/* Texels of one colour leave what etch_triangle_flat_depth leaves. */
static void depth_passes_as_in_one_color(void)
{
    uint32_t seed = 63;
    int32_t i;
    int k;

    for (i = 0; i < TEST_COUNT(900) && !test_failed(); i++) {
        static const int painters[6] = {1, 2, 4, 5, 7, 8};
        const int painter = painters[i % 6];

        make_scene(false, &seed);
        if (i % 4 == 0) /* the same triangle again: LESS does nothing, LEQUAL draws all */
            for (k = 0; k < 3; k++)
                scene[1][k].at = scene[0][k].at;
        for (k = 0; k < 1024; k++)
            texels[k] = 0;
        test_canvas_open(&whole, frame);
        test_canvas_open(&part, frame);
        for (k = 0; k < 2; k++) {
            const struct etch_vertex *const v[3] = {&scene[k][0].at, &scene[k][1].at,
                                                    &scene[k][2].at};

            etch_triangle_flat_depth(&whole.surface, v,
                                     i % 2 == 0 ? etch_kernel_flat_less : etch_kernel_flat_lequal);
        }
        draw(&part.surface, painter, test_orders[0]);
        same_as_whole(&frame, painter);
    }
}

void suite_texture_strips(void)
{
    RUN(strips_and_clips_change_nothing);
    RUN(equal_w_give_the_affine_pixels);
    RUN(depth_passes_as_in_one_color);
}
