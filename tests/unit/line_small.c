/* tests/unit: the small line against the fast one and the oracle: the same pixels, each once. */
#include "core/raster/line_small.h"
#include "tests/harness/canvas.h"
#include "tests/oracle/line.h"

void suite_line_small(void);

static struct test_canvas canvas;

static const struct etch_rect windows[] = {
    {0, 0, 48, 36}, {0, 0, 33, 25}, {150, 100, 190, 141}, {32727, 32731, 32767, 32767}};

static int16_t near(uint32_t *seed, int32_t lo, int32_t hi, int32_t margin)
{
    const int32_t v = test_range(seed, lo - margin, hi + margin);

    return (int16_t)(v > INT16_MAX ? INT16_MAX : v);
}

/* Ends in the window, round it, anywhere, and at the ends of the range. */
static void make(int16_t p[4], int32_t i, uint32_t *seed)
{
    static const int16_t hostile[] = {INT16_MIN, INT16_MIN + 1, -1, 0, 1, INT16_MAX - 1, INT16_MAX};
    const struct etch_rect w = windows[i % 4];
    int k;

    for (k = 0; k < 4; k++) {
        const int32_t lo = k % 2 == 0 ? w.x0 : w.y0, hi = k % 2 == 0 ? w.x1 : w.y1;
        const int32_t kind = test_range(seed, 0, 5) + (i & 1);

        p[k] = kind < 3    ? near(seed, lo, hi, 0)
               : kind == 3 ? near(seed, lo, hi, 40)
               : kind == 4 ? (int16_t)test_range(seed, INT16_MIN, INT16_MAX)
                           : hostile[test_range(seed, 0, 6)];
    }
    if (i % 16 == 15) /* parallel to an axis */
        p[2 + i / 16 % 2] = p[i / 16 % 2];
}

static void open_window(int32_t i, uint32_t *seed)
{
    const struct etch_rect w = windows[i % 4];
    struct etch_rect clip = w;

    test_canvas_open(&canvas, w);
    if (i % 8 >= 4) {
        clip.x0 = (int16_t)test_range(seed, w.x0, w.x1);
        clip.y0 = (int16_t)test_range(seed, w.y0, w.y1);
        clip.x1 = (int16_t)test_range(seed, clip.x0, w.x1);
        clip.y1 = (int16_t)test_range(seed, clip.y0, w.y1);
        test_canvas_clip(&canvas, clip);
    }
}

static void pixels_are_those_of_the_fast_line(void)
{
    uint32_t seed = 96;
    int32_t i, x, y;

    for (i = 0; i < TEST_COUNT(120000) && !test_failed(); i++) {
        const struct etch_rect *clip = &canvas.surface.clip;
        int32_t wrong = 0;
        uint32_t hash;
        int16_t p[4];

        open_window(i, &seed);
        make(p, i, &seed);
        etch_line_draw(&canvas.surface, p[0], p[1], p[2], p[3], TEST_INK);
        hash = test_canvas_hash(&canvas);
        test_canvas_wipe(&canvas);
        etch_line_draw_small(&canvas.surface, p[0], p[1], p[2], p[3], TEST_INK);
        CHECK_ONCE(&canvas);
        if (i % 8 == 0) /* the oracle is slow, and the fast line is compared with it elsewhere */
            for (y = clip->y0; y < clip->y1; y++)
                for (x = clip->x0; x < clip->x1; x++)
                    wrong += oracle_line_covers(p[0], p[1], p[2], p[3], x, y) !=
                             test_canvas_drawn(&canvas, x, y);
        CHECK_EQ(wrong, 0);
        if (!CHECK_EQ(test_canvas_hash(&canvas), hash)) {
            test_note("x0", p[0]);
            test_note("y0", p[1]);
            test_note("x1", p[2]);
            test_note("y1", p[3]);
        }
    }
}

void suite_line_small(void)
{
    RUN(pixels_are_those_of_the_fast_line);
    test_print_count("", TEST_COUNT(120000), " lines, no differing pixel");
}
