/* tests/unit: making and clipping surfaces. */
#include "core/base/surface.h"
#include "core/draw/shapes.h"
#include "tests/harness/canvas.h"

void suite_surface(void);

static uint16_t memory[64];

static bool same_rect(struct etch_rect a, struct etch_rect b)
{
    return a.x0 == b.x0 && a.y0 == b.y0 && a.x1 == b.x1 && a.y1 == b.y1;
}

static void init_fills_every_field(void)
{
    const struct etch_rect window = {3, 4, 11, 10};
    struct etch_surface s;

    CHECK_EQ(etch_surface_init(&s, memory, window, 9), ETCH_OK);
    CHECK(s.pixels == memory && s.depth == NULL && s.stride == 9);
    CHECK(same_rect(s.window, window) && same_rect(s.clip, window));
    CHECK_EQ(etch_surface_index(&s, 3, 4), 0);
    CHECK_EQ(etch_surface_index(&s, 10, 6), 25);
}

/* Everything refused leaves the surface as it was. */
static void init_refuses(void)
{
    static const struct {
        struct etch_rect window;
        uint16_t stride;
    } wrong[] = {{{0, 0, 0, 5}, 8},
                 {{0, 0, 5, 0}, 8},
                 {{5, 5, 4, 9}, 8},
                 {{-1, 0, 4, 4}, 8},
                 {{0, -1, 4, 4}, 8},
                 {{0, 0, 9, 1}, 8},
                 {{0, 0, INT16_MAX, 1}, INT16_MAX - 1},
                 {{INT16_MIN, 0, INT16_MAX, 1}, 65535}};
    const struct etch_rect good = {0, 0, 8, 8};
    struct etch_surface s;
    size_t i;

    CHECK_EQ(etch_surface_init(&s, memory, good, 8), ETCH_OK);
    for (i = 0; i < sizeof wrong / sizeof wrong[0]; i++)
        CHECK_EQ(etch_surface_init(&s, memory + 1, wrong[i].window, wrong[i].stride), ETCH_EINVAL);
    CHECK_EQ(etch_surface_init(&s, NULL, good, 8), ETCH_EINVAL);
    CHECK(s.pixels == memory && s.stride == 8 && same_rect(s.window, good));
}

/* The largest windows that a surface may have. */
static void init_takes_the_largest(void)
{
    const struct etch_rect wide = {0, 0, INT16_MAX, 1}, high = {0, 0, 1, INT16_MAX};
    struct etch_surface s;

    CHECK_EQ(etch_surface_init(&s, memory, wide, INT16_MAX), ETCH_OK);
    CHECK_EQ(etch_surface_init(&s, memory, wide, UINT16_MAX), ETCH_OK);
    CHECK_EQ(etch_surface_init(&s, memory, high, 1), ETCH_OK);
    CHECK_EQ(etch_surface_index(&s, 0, INT16_MAX - 1), INT16_MAX - 1);
}

/* A pixel is in the clip iff it is in the rectangle asked for and in the window. */
static void clip_is_the_intersection(void)
{
    static const int16_t at[] = {INT16_MIN, -1, 0, 2, 3, 5, 10, 11, 12, INT16_MAX};
    const struct etch_rect window = {3, 4, 11, 10};
    struct etch_surface s;
    int i;
    int32_t x, y;

    CHECK_EQ(etch_surface_init(&s, memory, window, 8), ETCH_OK);
    for (i = 0; i < 10000; i++) {
        const struct etch_rect r = {at[i % 10], at[i / 10 % 10], at[i / 100 % 10], at[i / 1000]};
        int32_t wrong = 0;

        etch_surface_clip(&s, r);
        for (y = 0; y < 15; y++) {
            for (x = 0; x < 15; x++) {
                const bool in = x >= r.x0 && x < r.x1 && y >= r.y0 && y < r.y1 && x >= window.x0 &&
                                x < window.x1 && y >= window.y0 && y < window.y1;

                wrong += in != (x >= s.clip.x0 && x < s.clip.x1 && y >= s.clip.y0 && y < s.clip.y1);
            }
        }
        CHECK_EQ(wrong, 0);
        CHECK(s.clip.x0 >= window.x0 && s.clip.x1 <= window.x1 && s.clip.x0 <= s.clip.x1);
        CHECK(s.clip.y0 >= window.y0 && s.clip.y1 <= window.y1 && s.clip.y0 <= s.clip.y1);
    }
}

/* Rectangles from sizes: far edges beyond int16 saturate, empty ones are empty. */
static void rect_from_size(void)
{
    static const int16_t at[] = {INT16_MIN, -5, -1, 0, 1, 7, INT16_MAX - 1, INT16_MAX};
    int i;

    for (i = 0; i < 8 * 8 * 8 * 8; i++) {
        const int16_t x = at[i & 7], y = at[i >> 3 & 7], w = at[i >> 6 & 7], h = at[i >> 9];
        const struct etch_rect r = etch_rect_from_size(x, y, w, h);
        const int32_t x1 = (int32_t)x + w, y1 = (int32_t)y + h;

        CHECK(r.x0 == x && r.y0 == y);
        if (w > 0)
            CHECK_EQ(r.x1, x1 < INT16_MAX ? x1 : INT16_MAX);
        if (h > 0)
            CHECK_EQ(r.y1, y1 < INT16_MAX ? y1 : INT16_MAX);
        CHECK(etch_rect_is_empty(r) || (w > 0 && h > 0));
    }
}

/* Two surfaces side by side: drawing on one leaves the other alone. */
static void two_surfaces(void)
{
    static struct test_canvas a, b;
    const struct etch_rect window = {0, 0, 4, 2};

    test_canvas_open(&a, window);
    test_canvas_open(&b, window);
    etch_rect_fill(&a.surface, 0, 0, 2, 2, 1);
    etch_rect_fill(&b.surface, 1, 1, 9, 9, 2);
    CHECK_PICTURE(&a, "aa.."
                      "aa..");
    CHECK_PICTURE(&b, "...."
                      ".bbb");
}

void suite_surface(void)
{
    RUN(init_fills_every_field);
    RUN(init_refuses);
    RUN(init_takes_the_largest);
    RUN(clip_is_the_intersection);
    RUN(rect_from_size);
    RUN(two_surfaces);
}
