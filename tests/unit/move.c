/* tests/unit: copies, scrolls, exclusive or and clip stacks against a pixel-by-pixel definition. */
#include "core/frame/move.h"

#include "core/base/clip_stack.h"
#include "tests/harness/canvas.h"

void suite_move(void);

enum {
    W = 40,
    H = 24
};
static const struct etch_rect window = {30, 10, 30 + W, 10 + H};

/* Numbers every pixel of the window, then sets a clip without wiping. */
static struct test_canvas canvas;
static uint16_t before[H][W], expected[H][W];

static void paint(struct test_canvas *c, uint32_t *seed, bool clipped)
{
    test_canvas_open(c, window);
    for (int32_t y = 0; y < H; y++)
        for (int32_t x = 0; x < W; x++)
            c->surface.pixels[y * c->surface.stride + x] = (uint16_t)test_random(seed);
    if (clipped) {
        const struct etch_rect clip = {
            (int16_t)test_range(seed, 25, 60), (int16_t)test_range(seed, 5, 30),
            (int16_t)test_range(seed, 40, 75), (int16_t)test_range(seed, 15, 40)};
        etch_surface_clip(&c->surface, clip);
    }
}

static uint16_t at(const struct test_canvas *c, int32_t x, int32_t y)
{
    return c->surface.pixels[y * c->surface.stride + x];
}

static void keep(void)
{
    for (int32_t y = 0; y < H; y++)
        for (int32_t x = 0; x < W; x++)
            before[y][x] = expected[y][x] = at(&canvas, x, y);
}

static bool holds(struct etch_rect r, int32_t x, int32_t y)
{
    return x >= r.x0 && x < r.x1 && y >= r.y0 && y < r.y1;
}

/* The window, and the guard words round it and between its rows. */
static bool as_expected(void)
{
    const uint16_t *const first = canvas.pixels;
    int32_t wrong = 0;

    for (int32_t i = 0; i < TEST_GUARD_WORDS; i++)
        wrong += first[i] != TEST_GUARD ||
                 first[TEST_GUARD_WORDS + TEST_CANVAS_WORDS + i] != TEST_GUARD;
    for (int32_t y = 0; y < H; y++) {
        for (int32_t x = 0; x < W; x++)
            wrong += at(&canvas, x, y) != expected[y][x];
        for (int32_t x = W; x < canvas.surface.stride; x++)
            wrong += at(&canvas, x, y) != TEST_GUARD;
    }
    return CHECK_EQ(wrong, 0);
}

/* Any rectangle: mostly near the window, sometimes anywhere, sometimes inverted. */
static struct etch_rect some_rect(uint32_t *seed)
{
    const bool far = test_range(seed, 0, 7) == 0;
    const int32_t lo = far ? INT16_MIN : 0, hi = far ? INT16_MAX : 90;
    struct etch_rect r = {(int16_t)test_range(seed, lo, hi), (int16_t)test_range(seed, lo, hi),
                          (int16_t)test_range(seed, lo, hi), (int16_t)test_range(seed, lo, hi)};

    return r;
}

static int16_t some_place(uint32_t *seed)
{
    return (int16_t)(test_range(seed, 0, 7) == 0 ? test_range(seed, INT16_MIN, INT16_MAX)
                                                 : test_range(seed, -10, 70));
}

static void copies_in_one_surface(void)
{
    uint32_t seed = 1;

    for (int32_t i = 0; i < TEST_COUNT(3000) && !test_failed(); i++) {
        const struct etch_rect area = some_rect(&seed);
        const int16_t x = some_place(&seed), y = some_place(&seed);

        paint(&canvas, &seed, i % 2 == 1);
        keep();
        for (int32_t j = window.y0; j < window.y1; j++) {
            for (int32_t k = window.x0; k < window.x1; k++) {
                const int32_t from_x = k - x + area.x0, from_y = j - y + area.y0;

                if (holds(canvas.surface.clip, k, j) && holds(area, from_x, from_y) &&
                    holds(window, from_x, from_y))
                    expected[j - window.y0][k - window.x0] =
                        before[from_y - window.y0][from_x - window.x0];
            }
        }
        etch_surface_copy_rect(&canvas.surface, x, y, &canvas.surface, area);
        if (!as_expected())
            test_note("i", i);
    }
}

static void copies_between_surfaces(void)
{
    static struct test_canvas other;
    uint32_t seed = 2;

    for (int32_t i = 0; i < TEST_COUNT(2000) && !test_failed(); i++) {
        const struct etch_rect area = some_rect(&seed);
        const int16_t x = some_place(&seed), y = some_place(&seed);
        int32_t moved = 0;

        paint(&canvas, &seed, i % 2 == 1);
        keep();
        paint(&other, &seed, true); /* the clip of the source does not matter */
        for (int32_t j = window.y0; j < window.y1; j++) {
            for (int32_t k = window.x0; k < window.x1; k++) {
                const int32_t from_x = k - x + area.x0, from_y = j - y + area.y0;

                if (holds(canvas.surface.clip, k, j) && holds(area, from_x, from_y) &&
                    holds(window, from_x, from_y))
                    expected[j - window.y0][k - window.x0] = at(&other, from_x - window.x0,
                                                                from_y - window.y0),
                                                moved++;
            }
        }
        etch_surface_copy_rect(&canvas.surface, x, y, &other.surface, area);
        if (!as_expected())
            test_note("moved", moved);
    }
}

static void scrolls(void)
{
    uint32_t seed = 3;

    for (int32_t i = 0; i < TEST_COUNT(3000) && !test_failed(); i++) {
        const struct etch_rect area = some_rect(&seed);
        const int16_t dx = (int16_t)(some_place(&seed) - 20),
                      dy = i % 4 == 0 ? 0 : (int16_t)(some_place(&seed) - 20);

        paint(&canvas, &seed, i % 2 == 1);
        keep();
        for (int32_t j = window.y0; j < window.y1; j++) {
            for (int32_t k = window.x0; k < window.x1; k++) {
                const bool there = holds(area, k - dx, j - dy) && holds(window, k - dx, j - dy);

                if (holds(canvas.surface.clip, k, j) && holds(area, k, j))
                    expected[j - window.y0][k - window.x0] =
                        there ? before[j - dy - window.y0][k - dx - window.x0] : 0x1234;
            }
        }
        etch_surface_scroll(&canvas.surface, area, dx, dy, 0x1234);
        if (!as_expected())
            test_note("dx", dx), test_note("dy", dy);
    }
}

static void xor_takes_itself_away(void)
{
    uint32_t seed = 4;

    for (int32_t i = 0; i < TEST_COUNT(500) && !test_failed(); i++) {
        const int16_t x = some_place(&seed), y = some_place(&seed);
        const int16_t w = some_place(&seed), h = some_place(&seed);
        const uint16_t mask = (uint16_t)(test_random(&seed) | 1);

        paint(&canvas, &seed, i % 2 == 1);
        keep();
        for (int32_t j = window.y0; j < window.y1; j++)
            for (int32_t k = window.x0; k < window.x1; k++)
                if (holds(canvas.surface.clip, k, j) && k >= x && k < x + w && j >= y && j < y + h)
                    expected[j - window.y0][k - window.x0] ^= mask;
        etch_rect_xor(&canvas.surface, x, y, w, h, mask);
        as_expected();
        etch_rect_xor(&canvas.surface, x, y, w, h, mask);
        for (int32_t k = 0; k < W * H; k++)
            expected[k / W][k % W] = before[k / W][k % W];
        as_expected();
    }
}

static void clips_nest(void)
{
    const struct etch_rect a = {32, 12, 60, 30}, b = {20, 20, 50, 40}, none = {9, 9, 3, 3};
    struct etch_rect saved[2];
    struct etch_clip_stack stack;
    struct etch_surface s;

    test_canvas_open(&canvas, window);
    s = canvas.surface;
    etch_clip_stack_init(&stack, saved, 2);
    CHECK_EQ(etch_clip_pop(&s, &stack), ETCH_EINVAL);
    CHECK_EQ(etch_clip_push(&s, &stack, a), ETCH_OK);
    CHECK_EQ(etch_clip_push(&s, &stack, b), ETCH_OK);
    CHECK(s.clip.x0 == 32 && s.clip.y0 == 20 && s.clip.x1 == 50 && s.clip.y1 == 30);
    CHECK_EQ(etch_clip_push(&s, &stack, none), ETCH_ENOMEM); /* full: nothing changes */
    CHECK_EQ(etch_clip_push(&s, &stack, none), ETCH_ENOMEM);
    CHECK(s.clip.x0 == 32 && s.clip.y0 == 20 && s.clip.x1 == 50 && s.clip.y1 == 30);
    CHECK_EQ(etch_clip_pop(&s, &stack), ETCH_OK);
    CHECK_EQ(etch_clip_pop(&s, &stack), ETCH_OK);
    CHECK(s.clip.x0 == 32 && s.clip.y0 == 20 && s.clip.x1 == 50 && s.clip.y1 == 30);
    CHECK_EQ(etch_clip_pop(&s, &stack), ETCH_OK);
    CHECK(s.clip.x0 == 32 && s.clip.y0 == 12 && s.clip.x1 == 60 && s.clip.y1 == 30);
    CHECK_EQ(etch_clip_push(&s, &stack, none), ETCH_OK);
    CHECK(etch_rect_is_empty(s.clip));
    CHECK(s.clip.x0 >= window.x0 && s.clip.x1 <= window.x1);
    CHECK_EQ(etch_clip_pop(&s, &stack), ETCH_OK);
    CHECK_EQ(etch_clip_pop(&s, &stack), ETCH_OK);
    CHECK(s.clip.x0 == 30 && s.clip.y0 == 10 && s.clip.x1 == 70 && s.clip.y1 == 34);
    CHECK_EQ(etch_clip_pop(&s, &stack), ETCH_EINVAL);
    CHECK(s.clip.x0 == 30 && s.clip.y0 == 10 && s.clip.x1 == 70 && s.clip.y1 == 34);
}

void suite_move(void)
{
    RUN(copies_in_one_surface);
    RUN(copies_between_surfaces);
    RUN(scrolls);
    RUN(xor_takes_itself_away);
    RUN(clips_nest);
}
