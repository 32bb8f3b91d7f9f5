/* tests/unit: images through samplers: bilinear against exact weights, opacity, and that what is
 * filtered at the centres of texels is the image. */
#include "core/draw/image.h"
#include "core/fragment/sampler.h"
#include "core/fragment/source_map.h"
#include "core/fragment/write.h"
#include "core/raster/map_runs.h"
#include "tests/harness/canvas.h"

void suite_image_smooth(void);

enum {
    SIDE = 24
};

static struct test_canvas canvas, other;
static uint16_t texels[SIDE * SIDE];
static struct etch_sampler sampler;
static struct etch_map map;
static const struct etch_rect window = {100, 7, 160, 50};

static const struct etch_stage stages[] = {{etch_source_map, &map},
                                           {etch_stage_texture_replace, &sampler},
                                           {etch_stage_write, NULL},
                                           {NULL, NULL}};
static const struct etch_staged_paint paint = {{etch_kernel_staged}, stages};

static void make(uint32_t *seed, etch_texel_filter *filter)
{
    struct etch_image image = {.colors = etch_texels_rgb565,
                               .texels = texels,
                               .width = (uint16_t)test_range(seed, 1, SIDE),
                               .height = (uint16_t)test_range(seed, 1, SIDE)};

    image.stride = (uint16_t)test_range(seed, image.width, SIDE);
    for (int32_t i = 0; i < SIDE * SIDE; i++)
        texels[i] = (uint16_t)test_random(seed);
    CHECK_EQ(etch_sampler_init(&sampler, &image, filter, etch_texels_clamp), ETCH_OK);
}

static void turn(uint32_t *seed)
{
    const int32_t one = 65536;
    const struct etch_map_place place = {test_range(seed, 0, 20 * one),
                                         test_range(seed, 0, 20 * one),
                                         test_range(seed, 100 * one, 160 * one),
                                         test_range(seed, 7 * one, 50 * one),
                                         (uint16_t)test_random(seed),
                                         test_range(seed, one / 3, 9 * one),
                                         test_range(seed, -9 * one, -one / 3)};

    CHECK_EQ(etch_map_rotate(&map, etch_image_whole(&sampler.image), &place), ETCH_OK);
}

static int32_t clamped(int64_t k, int32_t size)
{
    return (int32_t)(k < 0 ? 0 : k >= size ? size - 1 : k);
}

/* The value of a channel at (u, v), 2^32 to a texel, 2^32 times as large. */
static int64_t bilinear(int64_t u, int64_t v, int32_t shift, int32_t most)
{
    const int64_t half = INT64_C(1) << 31;
    const int64_t fu = ((u - half) & UINT32_MAX) >> 16, fv = ((v - half) & UINT32_MAX) >> 16;
    int64_t sum = 0;

    for (int32_t k = 0; k < 4; k++) {
        const int32_t column = clamped(((u - half) >> 32) + k % 2, sampler.image.width);
        const int32_t row = clamped(((v - half) >> 32) + k / 2, sampler.image.height);
        const int64_t weight = (k % 2 == 1 ? fu : 65536 - fu) * (k / 2 == 1 ? fv : 65536 - fv);

        sum += weight * (texels[row * sampler.image.stride + column] >> shift & most);
    }
    return sum;
}

static bool near(uint16_t got, int64_t u, int64_t v)
{
    static const int32_t shift[3] = {11, 5, 0}, most[3] = {31, 63, 31};
    bool ok = true;

    for (int k = 0; k < 3; k++) {
        const int64_t error = ((int64_t)(got >> shift[k] & most[k]) << 32) -
                              bilinear(u, v, shift[k], most[k]);
        /* 1/2 of rounding, 1/1024 of the range, a unit of the chunk's format */
        const int64_t bound = (INT64_C(1) << 31) + ((int64_t)most[k] << 22) + (INT64_C(1) << 22);

        ok = ok && error <= bound && error >= -bound;
    }
    return ok;
}

static void places_are_weighed(void)
{
    uint32_t seed = 1;
    int64_t shown = 0;

    for (int32_t i = 0; i < TEST_COUNT(600) && !test_failed(); i++) {
        make(&seed, i % 2 == 0 ? etch_filter_linear : etch_filter_linear_clamp);
        turn(&seed);
        test_canvas_open(&canvas, window);
        etch_map_runs(&canvas.surface, &map, &paint.paint);
        for (int32_t y = window.y0; y < window.y1; y++) {
            for (int32_t x = window.x0; x < window.x1; x++) {
                const int64_t u = map.u + map.ux * x + map.uy * y;
                const int64_t v = map.v + map.vx * x + map.vy * y;
                const bool in = u >= 0 && u >> 32 < sampler.image.width && v >= 0 &&
                                v >> 32 < sampler.image.height;

                shown += in;
                CHECK(in ? near(test_canvas_at(&canvas, x, y), u, v)
                         : !test_canvas_drawn(&canvas, x, y));
            }
        }
        if (!CHECK_ONCE(&canvas))
            test_note("i", i);
    }
    CHECK(test_failed() || shown > TEST_COUNT(600) * 100);
}

/* Strips and clips cut the same picture. */
static void strips_are_the_whole(void)
{
    uint32_t seed = 2;

    for (int32_t i = 0; i < TEST_COUNT(100) && !test_failed(); i++) {
        int32_t wrong = 0;

        make(&seed, etch_filter_linear);
        turn(&seed);
        test_canvas_open(&canvas, window);
        etch_map_runs(&canvas.surface, &map, &paint.paint);
        test_canvas_open(&other, window);
        for (int16_t y = window.y0; y < window.y1; y = (int16_t)(y + 5)) {
            const int16_t x = (int16_t)test_range(&seed, window.x0, window.x1);
            const struct etch_rect left = {window.x0, y, x, (int16_t)(y + 5)};
            const struct etch_rect right = {x, y, window.x1, (int16_t)(y + 5)};

            etch_surface_clip(&other.surface, left);
            etch_map_runs(&other.surface, &map, &paint.paint);
            etch_surface_clip(&other.surface, right);
            etch_map_runs(&other.surface, &map, &paint.paint);
        }
        etch_surface_clip(&other.surface, window);
        for (int32_t y = window.y0; y < window.y1; y++)
            for (int32_t x = window.x0; x < window.x1; x++)
                wrong += test_canvas_at(&canvas, x, y) != test_canvas_at(&other, x, y);
        if (!CHECK_EQ(wrong, 0))
            test_note("i", i);
    }
}

static void centres_are_texels(void)
{
    uint32_t seed = 3;

    for (int32_t i = 0; i < TEST_COUNT(200) && !test_failed(); i++) {
        int32_t wrong = 0;

        make(&seed, i % 2 == 0 ? etch_filter_linear : etch_filter_linear_clamp);
        etch_map_scale(&map, etch_image_whole(&sampler.image), 110, 12,
                       (int16_t)sampler.image.width, (int16_t)sampler.image.height);
        test_canvas_open(&canvas, window);
        etch_map_runs(&canvas.surface, &map, &paint.paint);
        for (int32_t y = 0; y < sampler.image.height; y++)
            for (int32_t x = 0; x < sampler.image.width; x++)
                wrong += test_canvas_at(&canvas, 110 + x, 12 + y) !=
                         texels[y * sampler.image.stride + x];
        CHECK_EQ(wrong, 0);
    }
}

static void opacity_is_rounded_once(void)
{
    static struct etch_chunk chunk;

    for (uint32_t opacity = 0; opacity < 256; opacity++) {
        const struct etch_blend_constant data = {(uint8_t)opacity};

        for (uint32_t a = 0; a <= 65280; a += 16 * 17) {
            chunk.n = 16;
            for (uint32_t i = 0; i < 16; i++)
                chunk.a[i] = (uint16_t)(a + i * 17 <= 65280 ? a + i * 17 : 65280);
            etch_stage_opacity(&chunk, &data);
            for (uint32_t i = 0; i < 16; i++) {
                const uint32_t from = a + i * 17 <= 65280 ? a + i * 17 : 65280;

                CHECK_EQ(chunk.a[i], (2 * from * opacity + 255) / 510);
            }
        }
    }
}

void suite_image_smooth(void)
{
    RUN(places_are_weighed);
    RUN(strips_are_the_whole);
    RUN(centres_are_texels);
    RUN(opacity_is_rounded_once);
}
