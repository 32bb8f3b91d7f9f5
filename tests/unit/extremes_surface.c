/* tests/unit: surfaces and clip rectangles at the extremes: one pixel, one row or column as long as
 * the frame, rows further apart than they are wide; clips that are empty, inverted, beside the
 * frame or larger than it. What is drawn is what the definitions say, inside the clip and nowhere
 * else. tests/EXTREMES.md lists what is where. */
#include "core/draw/round.h"
#include "core/draw/shapes.h"
#include "core/raster/circle.h"
#include "core/raster/line.h"
#include "core/raster/rect.h"
#include "tests/harness/canvas.h"
#include "tests/oracle/circle.h"
#include "tests/oracle/line.h"
#include "tests/oracle/round.h"
#include "tests/oracle/triangle.h"

#include <string.h>

void suite_extremes_surface(void);

#define UNTOUCHED 0xA5A5

#define LENGTH 32767

static uint16_t memory[2 + LENGTH + 2]; /* with guards before and behind */
static uint8_t stencil[LENGTH];

/* ---- the shapes, each beside its definition -------------------------------------------------- */

enum {
    CLEAR,
    POINT,
    LINE,
    OUTLINE,
    RECT,
    CIRCLE,
    DISC,
    ELLIPSE,
    ROUND,
    TRIANGLE,
    SHAPES
};

/* Of a size and place that reach over the surface: (cx, cy) on it. */
static void draw_shape(const struct etch_surface *s, int shape, int16_t cx, int16_t cy)
{
    switch (shape) {
    case CLEAR: etch_surface_clear(s, TEST_INK); break;
    case POINT: etch_point_draw(s, cx, cy, TEST_INK); break;
    case LINE: etch_line_draw(s, INT16_MIN, INT16_MIN, cx, cy, TEST_INK); break;
    case OUTLINE: etch_rect_draw(s, cx, cy, INT16_MAX, INT16_MAX, TEST_INK); break;
    case RECT: etch_rect_fill(s, cx, INT16_MIN, INT16_MAX, INT16_MAX, TEST_INK); break;
    case CIRCLE: etch_circle_draw(s, cx, cy, 7, TEST_INK); break;
    case DISC: etch_circle_fill(s, cx, cy, INT16_MAX, TEST_INK); break;
    case ELLIPSE: etch_ellipse_fill(s, cx, cy, INT16_MAX, 3, TEST_INK); break;
    case ROUND: etch_round_rect_fill(s, cx, cy, 9, INT16_MAX, 4, TEST_INK); break;
    default: etch_triangle_fill(s, cx, cy, INT16_MAX, INT16_MIN, INT16_MIN, INT16_MAX, TEST_INK);
    }
}

static bool expected(int shape, int32_t cx, int32_t cy, int32_t x, int32_t y)
{
    const int32_t tx[3] = {cx * 256 + 128, (int32_t)INT16_MAX * 256 + 128,
                           (int32_t)INT16_MIN * 256 + 128};
    const int32_t ty[3] = {cy * 256 + 128, (int32_t)INT16_MIN * 256 + 128,
                           (int32_t)INT16_MAX * 256 + 128};
    struct oracle_triangle t;

    switch (shape) {
    case CLEAR: return true;
    case POINT: return x == cx && y == cy;
    case LINE: return oracle_line_covers(INT16_MIN, INT16_MIN, cx, cy, x, y);
    case OUTLINE: return (x == cx && y >= cy) || (y == cy && x >= cx); /* the others are outside */
    case RECT: return x >= cx && y < -1;
    case CIRCLE: return oracle_circle_covers(7, x - cx, y - cy);
    case DISC: return oracle_disc_covers(INT16_MAX, x - cx, y - cy);
    case ELLIPSE: return oracle_ellipse_covers(INT16_MAX, 3, x - cx, y - cy);
    case ROUND:
        return x >= cx && y >= cy && oracle_round_rect_covers(9, INT16_MAX, 4, x - cx, y - cy);
    default: oracle_triangle_make(&t, tx, ty); return oracle_triangle_covers(&t, x, y);
    }
}

/* Draws every shape round (cx, cy) and compares all pixels of the window, and that the guards hold.
 * */
static void compare(const struct etch_surface *s, int16_t cx, int16_t cy)
{
    const struct etch_rect *w = &s->window;

    for (int shape = 0; shape < SHAPES; shape++) {
        memset(memory, 0xA5, sizeof(memory));
        draw_shape(s, shape, cx, cy);
        for (int32_t y = w->y0; y < w->y1; y++)
            for (int32_t x = w->x0; x < w->x1; x++) {
                const bool inside = x >= s->clip.x0 && x < s->clip.x1 && y >= s->clip.y0 &&
                                    y < s->clip.y1;
                const uint16_t got = s->pixels[etch_surface_index(s, (int16_t)x, (int16_t)y)];

                if (!CHECK_EQ(got == TEST_INK, inside && expected(shape, cx, cy, x, y))) {
                    test_note("shape", shape);
                    test_note("x", x);
                    test_note("y", y);
                    return;
                }
            }
        CHECK(memory[0] == UNTOUCHED && memory[1] == UNTOUCHED);
        CHECK(memory[LENGTH + 2] == UNTOUCHED && memory[LENGTH + 3] == UNTOUCHED);
    }
}

/* ---- sizes ----------------------------------------------------------------------------------- */

static void surfaces_1x1(void)
{
    static const struct etch_rect at[] = {{0, 0, 1, 1}, {32766, 32766, 32767, 32767}};

    for (int i = 0; i < 2; i++) {
        struct etch_surface s;

        CHECK_EQ(etch_surface_init(&s, memory + 2, at[i], 1), ETCH_OK);
        for (int16_t y = -1; y < 2; y++)
            for (int16_t x = -1; x < 2; x++)
                compare(&s, (int16_t)(at[i].x0 + x), (int16_t)(at[i].y0 + y));
        CHECK_EQ(memory[3], UNTOUCHED);
    }
}

static void surfaces_32767x1(void)
{
    struct etch_surface s;

    CHECK_EQ(etch_surface_init(&s, memory + 2, (struct etch_rect){0, 0, LENGTH, 1}, LENGTH),
             ETCH_OK);
    compare(&s, 0, 0);
    compare(&s, LENGTH - 1, 0);
    compare(&s, 16000, 2);
    etch_surface_clip(&s, (struct etch_rect){LENGTH - 5, 0, INT16_MAX, INT16_MAX});
    compare(&s, LENGTH - 3, 0);
}

static void surfaces_1x32767(void)
{
    struct etch_surface s;

    CHECK_EQ(etch_surface_init(&s, memory + 2, (struct etch_rect){0, 0, 1, LENGTH}, 1), ETCH_OK);
    compare(&s, 0, 0);
    compare(&s, 0, LENGTH - 1);
    compare(&s, 2, 16000);
    etch_surface_clip(&s, (struct etch_rect){0, LENGTH - 5, INT16_MAX, INT16_MAX});
    compare(&s, 0, LENGTH - 3);
}

/* Rows as far apart as they can be: what lies between them stays; depth and stencil have the layout
 * of the colours. 3 x 2 pixels, 16,384 elements from row to row. */
static void strides_larger_than_the_width(void)
{
    static uint16_t depth[LENGTH];
    struct etch_surface s;

    CHECK_EQ(etch_surface_init(&s, memory + 2, (struct etch_rect){4, 5, 7, 7}, 16384), ETCH_OK);
    compare(&s, 5, 6);
    for (int32_t i = 0; i < LENGTH; i++)
        memory[2 + i] = depth[i] = UNTOUCHED, stencil[i] = 0xA5;
    s.depth = depth, s.stencil = stencil;
    etch_surface_clear(&s, TEST_INK);
    etch_depth_clear(&s, 7);
    etch_stencil_clear(&s, 9);
    for (int32_t i = 0; i < LENGTH; i++) {
        const bool inside = i < 3 || (i >= 16384 && i < 16387);

        CHECK_EQ(memory[2 + i], inside ? TEST_INK : UNTOUCHED);
        CHECK_EQ(depth[i], inside ? 7 : UNTOUCHED);
        CHECK_EQ(stencil[i], inside ? 9 : 0xA5);
    }
    /* the largest stride there is, over one row */
    CHECK_EQ(etch_surface_init(&s, memory + 2, (struct etch_rect){0, 0, 3, 1}, UINT16_MAX),
             ETCH_OK);
    compare(&s, 1, 0);
}

/* ---- clips ----------------------------------------------------------------------------------- */

/* All shapes under the clip; `left` pixels remain of the window 16 x 12. */
static void clip(struct etch_rect r, int32_t left)
{
    struct etch_surface s;

    CHECK_EQ(etch_surface_init(&s, memory + 2, (struct etch_rect){8, 9, 24, 21}, 19), ETCH_OK);
    etch_surface_clip(&s, r);
    compare(&s, 13, 14);
    memset(memory, 0xA5, sizeof(memory));
    etch_surface_clear(&s, TEST_INK);
    for (int32_t i = 0; i < LENGTH + 4; i++)
        left -= memory[i] == TEST_INK;
    CHECK_EQ(left, 0);
}

static void clips_that_are_empty(void)
{
    clip((struct etch_rect){0, 0, 0, 0}, 0);
    clip((struct etch_rect){12, 9, 12, 21}, 0);
    clip((struct etch_rect){8, 15, 24, 15}, 0);
    clip((struct etch_rect){24, 21, 24, 21}, 0);
}

static void clips_that_are_inverted(void)
{
    clip((struct etch_rect){24, 21, 8, 9}, 0);
    clip((struct etch_rect){20, 9, 10, 21}, 0);
    clip((struct etch_rect){8, 20, 24, 10}, 0);
    clip((struct etch_rect){INT16_MAX, INT16_MAX, INT16_MIN, INT16_MIN}, 0);
}

static void clips_off_the_screen(void)
{
    clip((struct etch_rect){0, 9, 8, 21}, 0);
    clip((struct etch_rect){24, 9, 40, 21}, 0);
    clip((struct etch_rect){8, 0, 24, 9}, 0);
    clip((struct etch_rect){8, 21, 24, 30}, 0);
    clip((struct etch_rect){INT16_MIN, INT16_MIN, -1, -1}, 0);
    clip((struct etch_rect){INT16_MAX - 1, INT16_MAX - 1, INT16_MAX, INT16_MAX}, 0);
}

static void clips_that_overflow(void)
{
    clip((struct etch_rect){INT16_MIN, INT16_MIN, INT16_MAX, INT16_MAX}, 16 * 12);
    clip((struct etch_rect){INT16_MIN, INT16_MIN, 9, 10}, 1);
    clip((struct etch_rect){23, 20, INT16_MAX, INT16_MAX}, 1);
    clip((struct etch_rect){INT16_MIN, 12, INT16_MAX, 14}, 2 * 16);
    clip(etch_rect_from_size(20, 18, INT16_MAX, INT16_MAX), 4 * 3);
}

void suite_extremes_surface(void)
{
    RUN(surfaces_1x1);
    RUN(surfaces_32767x1);
    RUN(surfaces_1x32767);
    RUN(strides_larger_than_the_width);
    RUN(clips_that_are_empty);
    RUN(clips_that_are_inverted);
    RUN(clips_off_the_screen);
    RUN(clips_that_overflow);
}
