/* tests/unit: linear functions over a rectangle, against their definition; and a gradient. */
#include "core/raster/evaluate.h"
#include "core/raster/plane.h"
#include "tests/harness/canvas.h"

void suite_evaluate(void);

enum {
    MOST = 5
};

struct watch {
    const struct etch_plane *plane;
    uint8_t count;
    struct etch_rect rect;
    int32_t x, y, calls; /* the pixel that has to come */
};

static void check(void *context, int16_t x, int16_t y, const uint32_t *value)
{
    struct watch *w = (struct watch *)context;
    uint8_t k;

    CHECK(x == w->x && y == w->y);
    for (k = 0; k < w->count; k++)
        CHECK_EQ(value[k], etch_plane_at(&w->plane[k], x, y));
    w->calls++;
    if (++w->x == w->rect.x1)
        w->x = w->rect.x0, w->y++;
}

static void values_are_exact(void)
{
    uint32_t seed = 1;
    int32_t i, calls = 0;

    for (i = 0; i < TEST_COUNT(3000) && !test_failed(); i++) {
        const int16_t x0 = (int16_t)test_range(&seed, INT16_MIN, INT16_MAX - 12);
        const int16_t y0 = (int16_t)test_range(&seed, INT16_MIN, INT16_MAX - 12);
        const struct etch_rect r = {x0, y0, (int16_t)(x0 + test_range(&seed, -1, 12)),
                                    (int16_t)(y0 + test_range(&seed, -1, 12))};
        struct etch_plane plane[MOST];
        uint32_t work[2 * MOST];
        struct watch w = {plane, (uint8_t)test_range(&seed, 0, MOST), r, r.x0, r.y0, 0};
        int k;

        for (k = 0; k < MOST; k++) {
            plane[k].origin = test_random(&seed);
            plane[k].dx = test_random(&seed);
            plane[k].dy = test_random(&seed);
        }
        etch_evaluate_rect(plane, w.count, r, work, check, &w);
        CHECK_EQ(w.calls, etch_rect_is_empty(r) ? 0 : (r.x1 - r.x0) * (r.y1 - r.y0));
        calls += w.calls;
    }
    test_print_count("", calls, " pixels, each value exact modulo 2^32");
}

/* ---- the example: a gradient through three colours ------------------------------------------- */

static void put(void *context, int16_t x, int16_t y, const uint32_t *value)
{
    const struct etch_surface *s = (const struct etch_surface *)context;

    s->pixels[etch_surface_index(s, x, y)] = (uint16_t)((value[0] >> 27 << 6 | value[1] >> 26)
                                                            << 5 |
                                                        value[2] >> 27);
}

/* Red at the top left pixel, green at the top right one, blue at the bottom left one. */
static void a_gradient(void)
{
    const struct etch_point_q8 corner[3] = {{128, 128}, {33 * 256 - 128, 128}, {128, 31 * 256}};
    const struct etch_rect window = {0, 0, 33, 32};
    static struct test_canvas canvas;
    struct etch_triangle t;
    struct etch_plane plane[3];
    uint32_t work[6];
    int32_t x, y;
    int i, k;

    test_canvas_open(&canvas, window);
    CHECK(etch_triangle_setup(&t, corner));
    for (k = 0; k < 3; k++) {
        uint32_t value[3];

        for (i = 0; i < 3; i++)
            value[i] = k == 1 ? etch_channel_q26(i == k ? 255 : 0)
                              : etch_channel_q27(i == k ? 255 : 0);
        etch_plane_setup(&plane[k], &t, value);
    }
    etch_evaluate_rect(plane, 3, window, work, put, &canvas.surface);
    CHECK_EQ(test_canvas_at(&canvas, 0, 0), 0xF800);
    CHECK_EQ(test_canvas_at(&canvas, 32, 0), 0x07E0);
    for (y = 0; y < 32; y++) {
        for (x = 0; x < 32 && 32 * (2 * y + 1) <= 61 * (32 - x); x++) {
            /* inside the triangle: green grows by 63 / 32 a pixel, blue by 31 / 30.5 a row */
            const int32_t green = test_canvas_at(&canvas, x, y) >> 5 & 63;
            const int32_t blue = test_canvas_at(&canvas, x, y) & 31;

            CHECK(64 * green - 126 * x <= 33 && 126 * x - 64 * green <= 33);
            CHECK(61 * 64 * blue - 62 * 64 * y <= 33 * 61 &&
                  62 * 64 * y - 61 * 64 * blue <= 33 * 61);
        }
    }
    CHECK_INSIDE(&canvas);
}

void suite_evaluate(void)
{
    RUN(values_are_exact);
    RUN(a_gradient);
}
