/* tests/harness/canvas.h: the guarded test surface, ASCII pictures and checked runs.
 *
 * A canvas is a surface whose memory has guard words before, behind and between its rows. What
 * lies outside the clip holds guard words too, so a write outside the clip shows:
 *
 *      guard guard guard guard guard guard guard
 *      +------- window ------------+ gap (guard)
 *      |     +-- clip --+          | gap
 *      +-----+----------+----------+ gap
 *      guard guard guard guard guard guard guard
 *
 * Overdraw is seen in two ways. Runs go to test_kernel_checked, which refuses a pixel it has
 * already got. Primitives that write directly are watched in the build with counted stores
 * (stores.h): there every store that core makes is looked up on the canvas wiped last, which
 * finds a pixel written twice and a write outside the clip even of an equal value.
 */
#ifndef TESTS_HARNESS_CANVAS_H
#define TESTS_HARNESS_CANVAS_H

#include "core/base/paint.h"
#include "harness.h"

/* Elements of one plane, gaps included: 64 x 48 with 3 elements between the rows fits. */
#ifndef TEST_CANVAS_WORDS
#define TEST_CANVAS_WORDS 3264
#endif
#define TEST_GUARD_WORDS 64
#define TEST_GUARD 0xA5C3
#define TEST_GAP 3

#define TEST_BACKGROUND 0x18E3
#define TEST_INK 0xFFFF

struct test_canvas {
    struct etch_surface surface; /* give this to drawing functions; depth plane included */
    uint16_t pixels[TEST_GUARD_WORDS + TEST_CANVAS_WORDS + TEST_GUARD_WORDS];
    uint16_t depth[TEST_GUARD_WORDS + TEST_CANVAS_WORDS + TEST_GUARD_WORDS];
    uint8_t stores[TEST_CANVAS_WORDS]; /* per pixel, in the build with counted stores */
    bool strayed;                      /* a counted store hit what it must not */
};

/* Makes the surface for a window of at most 64 x 48 and wipes it; clip is the window. */
void test_canvas_open(struct test_canvas *c, struct etch_rect window);
/* The same without gaps: the stride is the width. */
void test_canvas_open_tight(struct test_canvas *c, struct etch_rect window);

/* Sets the clip and wipes. */
void test_canvas_clip(struct test_canvas *c, struct etch_rect clip);

/* Background and depth 65535 inside the clip, guard words elsewhere, no stores counted. */
void test_canvas_wipe(struct test_canvas *c);

/* The colour at a frame pixel of the window. */
uint16_t test_canvas_at(const struct test_canvas *c, int32_t x, int32_t y);

/* True where a frame pixel of the window has another colour than the background. */
bool test_canvas_drawn(const struct test_canvas *c, int32_t x, int32_t y);

/* A hash of the colours and depths in the window. */
uint32_t test_canvas_hash(const struct test_canvas *c);

/* Fails the case if something outside the clip was written since the last wipe. */
#define CHECK_INSIDE(canvas) test_canvas_check((canvas), false, __FILE__, __LINE__)
/* .. or if a pixel was written twice (where stores are counted). */
#define CHECK_ONCE(canvas) test_canvas_check((canvas), true, __FILE__, __LINE__)
bool test_canvas_check(const struct test_canvas *c, bool once, const char *file, int line);

/* Compares the window with a picture, row by row, and prints both if they differ. '.' is
 * background or outside the clip, '#' any colour above 26, 'a' .. 'z' the colours 1 .. 26:
 *      CHECK_PICTURE(&canvas, "##...."
 *                             "..##.."
 *                             "....##"); */
#define CHECK_PICTURE(canvas, picture) test_picture((canvas), (picture), __FILE__, __LINE__)
bool test_picture(const struct test_canvas *c, const char *picture, const char *file, int line);

/* A paint that writes `color` and checks the contract of base/paint.h on the way: rows top to
 * bottom, runs ordered and inside the clip, 1 .. ETCH_RUN_BLOCK of them, no pixel twice. */
struct test_run_log {
    int32_t next_row; /* the first row that may come; start at INT32_MIN */
    int64_t pixels;   /* handed over so far */
    int32_t blocks;   /* kernel calls */
    bool broken;      /* the contract was broken */
    uint32_t hash;    /* of all runs that have pixels */
};
struct test_run_paint {
    struct etch_paint paint; /* .kernel = test_kernel_checked */
    uint16_t color;
    bool count; /* add `color` to a pixel instead of refusing to write it again */
    struct test_run_log *log;
};
etch_kernel test_kernel_checked;

/* A paint with a fresh log. */
struct test_run_paint test_run_paint(struct test_run_log *log, uint16_t color);

#endif
