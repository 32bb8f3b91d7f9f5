/* tests/unit: what the tests of the frame loop share: a display whose transfers take place when
 * they are waited for and which notices every buffer that was touched before. Each test file has
 * its own. */
#ifndef TESTS_FRAME_PARTS_H
#define TESTS_FRAME_PARTS_H

#include "hal/frame.h"
#include "tests/harness/harness.h"

enum {
    MAX_WIDTH = 40,
    MAX_HEIGHT = 40,
    MAX_SIZE = MAX_WIDTH * MAX_HEIGHT
};

/* A panel with its own memory. */
struct panel {
    uint16_t glass[MAX_SIZE], sent[MAX_SIZE]; /* shown; the buffer as flush got it */
    uint8_t writes[MAX_SIZE];                 /* of each pixel, in this frame */
    const uint16_t *pixels;                   /* of the running transfer, or NULL */
    struct etch_rect area;
    uint16_t stride;
    int flushes, waits;        /* calls in this frame */
    int fail_flush, fail_wait; /* number of the call that fails, from 1; 0: none */
    int early;                 /* buffers touched before their transfer had ended */
    int protocol;              /* calls that hal/display.h forbids */
};

static struct panel panel;
static uint16_t buffer[3][MAX_SIZE];
static struct etch_display display;

static inline int flush(const struct etch_display *d, struct etch_rect area, const uint16_t *pixels,
                        uint16_t stride)
{
    struct panel *p = d->context;
    const bool inside = area.x0 >= 0 && area.y0 >= 0 && area.x1 <= d->width && area.y1 <= d->height;

    p->protocol += p->pixels != NULL || etch_rect_is_empty(area) || !inside ||
                   stride < area.x1 - area.x0;
    if (++p->flushes == p->fail_flush)
        return -77;
    p->pixels = pixels;
    p->area = area;
    p->stride = stride;
    for (int16_t y = area.y0; y < area.y1; y++)
        for (int16_t x = area.x0; x < area.x1; x++)
            p->sent[y * MAX_WIDTH + x] = pixels[(y - area.y0) * stride + x - area.x0];
    return 0;
}

/* The transfer takes place now, at the latest moment allowed. */
static inline int wait(const struct etch_display *d)
{
    struct panel *p = d->context;
    const struct etch_rect area = p->area;
    const uint16_t *pixels = p->pixels;
    bool touched = false;

    p->pixels = NULL;
    if (pixels == NULL)
        return 0;
    if (++p->waits == p->fail_wait)
        return -78;
    for (int16_t y = area.y0; y < area.y1; y++) {
        for (int16_t x = area.x0; x < area.x1; x++) {
            const int at = y * MAX_WIDTH + x;

            p->glass[at] = pixels[(y - area.y0) * p->stride + x - area.x0];
            p->writes[at]++;
            touched |= p->glass[at] != p->sent[at];
        }
    }
    p->early += touched;
    return 0;
}

static inline uint16_t *memory(const struct etch_display *d, uint16_t *stride)
{
    struct panel *p = d->context;

    *stride = MAX_WIDTH;
    return p->glass;
}

static inline void open_panel(int16_t width, int16_t height, bool direct)
{
    static const struct panel nothing;
    const struct etch_display d = {.context = &panel,
                                   .width = width,
                                   .height = height,
                                   .flush = flush,
                                   .wait = wait,
                                   .memory = direct ? memory : NULL};

    panel = nothing;
    display = d;
}

static inline uint16_t pattern(int x, int y, int frame_number)
{
    return (uint16_t)(x * 251 + y * 17 + frame_number * 4099 + 1);
}

/* Draws the pattern on a strip, after checking that no running transfer reads from it. */
static inline void draw(const struct etch_surface *s, int frame_number)
{
    const size_t size = (size_t)(s->window.y1 - s->window.y0) * s->stride;

    CHECK(panel.pixels == NULL || panel.pixels + size <= s->pixels ||
          panel.pixels >= s->pixels + size);
    for (int16_t y = s->window.y0; y < s->window.y1; y++)
        for (int16_t x = s->window.x0; x < s->window.x1; x++)
            s->pixels[etch_surface_index(s, x, y)] = pattern(x, y, frame_number);
}

static inline int draw_frame(struct etch_frame *frame, int frame_number, int *strips)
{
    int16_t row = 0;

    *strips = 0;
    for (struct etch_surface *s = etch_frame_begin(frame); s != NULL; s = etch_frame_next(frame)) {
        CHECK(s->window.x0 == 0 && s->window.x1 == display.width && s->window.y0 == row);
        CHECK(s->clip.x1 == s->window.x1 && s->clip.y0 == row && s->clip.y1 == s->window.y1);
        row = s->window.y1;
        draw(s, frame_number);
        ++*strips;
    }
    return etch_frame_end(frame);
}

static inline void check_glass(int frame_number, int writes)
{
    for (int y = 0; y < display.height && !test_failed(); y++) {
        for (int x = 0; x < display.width; x++) {
            const int at = y * MAX_WIDTH + x;

            CHECK_EQ(panel.glass[at], pattern(x, y, frame_number));
            CHECK_EQ(panel.writes[at], writes);
            panel.writes[at] = 0;
        }
    }
    CHECK_EQ(panel.early, 0);
    CHECK_EQ(panel.protocol, 0);
    panel.flushes = panel.waits = 0;
}

static inline struct etch_frame_memory strips_of(int rows, int buffers)
{
    const struct etch_frame_memory m = {
        .pixels = {buffer[0], buffers == 2 ? buffer[1] : NULL},
        .size = (uint32_t)(rows * display.width + (display.width - 1)), /* no whole row more */
    };
    return m;
}

#endif
