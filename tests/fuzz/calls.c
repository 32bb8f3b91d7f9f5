/* tests/fuzz: sequences of calls on a small surface. The planes are allocated to the byte, so that
 * the sanitizer sees what leaves them; what lies in them but outside the clip is compared after
 * every call. */
#include "calls.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CALL_BYTES 64
#define MOST_CALLS 16
#define MOST_ROWS 512

static const struct fuzz_row *const tables[] = {
    fuzz_shape_rows, fuzz_run_rows,   fuzz_triangle_rows, fuzz_texture_rows, fuzz_image_rows,
    fuzz_stage_rows, fuzz_frame_rows, fuzz_smooth_rows,   fuzz_mesh_rows,
};
static const struct fuzz_row *rows[MOST_ROWS];
static uint32_t called[MOST_ROWS];
static uint16_t row_count;

static void list_rows(void)
{
    for (size_t t = 0; t < sizeof tables / sizeof tables[0]; t++) {
        for (const struct fuzz_row *r = tables[t]; r->name != NULL; r++) {
            if (row_count == MOST_ROWS) {
                fuzz_fail("too many rows");
            }
            rows[row_count++] = r;
        }
    }
}

/* ---- memory ---------------------------------------------------------------------------------- */

#define MOST_BLOCKS 24

static void *block[MOST_BLOCKS];
static int blocks;

void *fuzz_memory(size_t bytes)
{
    if (blocks == MOST_BLOCKS) {
        fuzz_fail("too many blocks");
    }
    block[blocks] = malloc(bytes == 0 ? 1 : bytes);
    if (block[blocks] == NULL) {
        fuzz_fail("out of memory");
    }
    memset(block[blocks], 0x6D, bytes == 0 ? 1 : bytes);
    return block[blocks++];
}

static void free_blocks(void)
{
    while (blocks > 0) {
        free(block[--blocks]);
    }
}

/* ---- the surface ----------------------------------------------------------------------------- */

static size_t elements(const struct etch_surface *s)
{
    const struct etch_rect *w = &s->window;

    return (size_t)(w->y1 - w->y0 - 1) * s->stride + (size_t)(w->x1 - w->x0);
}

static bool is_inside(const struct etch_surface *s, size_t i)
{
    const int32_t x = s->window.x0 + (int32_t)(i % s->stride);
    const int32_t y = s->window.y0 + (int32_t)(i / s->stride);

    return x >= s->clip.x0 && x < s->clip.x1 && y >= s->clip.y0 && y < s->clip.y1;
}

/* Nothing outside the clip differs. */
static void compare(const struct etch_surface *s, const struct fuzz_planes *before)
{
    const size_t n = elements(s);

    if (memcmp(s->pixels, before->pixels, n * 2) == 0 &&
        memcmp(s->depth, before->depth, n * 2) == 0 &&
        memcmp(s->stencil, before->stencil, n) == 0) {
        return;
    }
    for (size_t i = 0; i < n; i++) {
        if (!is_inside(s, i) &&
            (s->pixels[i] != before->pixels[i] || s->depth[i] != before->depth[i] ||
             s->stencil[i] != before->stencil[i])) {
            fuzz_fail("a store outside the clip");
        }
    }
}

static void keep(const struct etch_surface *s, struct fuzz_planes *before)
{
    const size_t n = elements(s);

    memcpy(before->pixels, s->pixels, n * 2);
    memcpy(before->depth, s->depth, n * 2);
    memcpy(before->stencil, s->stencil, n);
}

static void draw(struct fuzz_calls *c, struct fuzz_planes *before)
{
    const uint16_t row = fuzz_below(c, row_count);
    const struct etch_surface s = c->s;

    keep(&s, before);
    called[row]++;
    rows[row]->call(c, rows[row]->function);
    c->s = s; /* a call may have set a clip of its own within this one */
    free_blocks();
    compare(&s, before);
}

int fuzz_one(const uint8_t *data, size_t size)
{
    static const int16_t corner[][2] = {{0, 0}, {0, 0}, {17, 5}, {32727, 32735}};
    struct fuzz_calls c = {.at = data, .end = data + (size < 12 ? size : 12)};
    const uint8_t at = fuzz_byte(&c), gap = fuzz_byte(&c);
    const int16_t x = corner[at % 4][0], y = corner[at % 4][1];
    const int16_t width = (int16_t)(1 + fuzz_below(&c, 40)),
                  height = (int16_t)(1 + fuzz_below(&c, 32));
    const struct etch_rect window = {x, y, (int16_t)(x + width), (int16_t)(y + height)};
    const uint16_t stride = (uint16_t)(width + gap % 4);
    struct fuzz_planes planes, before;

    if (row_count == 0) {
        list_rows();
    }
    planes = fuzz_planes_open((size_t)(height - 1) * stride + (size_t)width);
    before = fuzz_planes_open((size_t)(height - 1) * stride + (size_t)width);
    if (etch_surface_init(&c.s, planes.pixels, window, stride) != ETCH_OK) {
        fuzz_fail("no surface");
    }
    c.s.depth = planes.depth;
    c.s.stencil = planes.stencil;
    if (at >= 64) {
        etch_surface_clip(&c.s, fuzz_rect(&c));
    }
    for (size_t i = 12; i < size && i < 12 + CALL_BYTES * MOST_CALLS; i += CALL_BYTES) {
        c.at = data + i;
        c.end = data + (i + CALL_BYTES < size ? i + CALL_BYTES : size);
        draw(&c, &before);
    }
    fuzz_planes_close(&planes);
    fuzz_planes_close(&before);
    return 0;
}

const char *fuzz_missing(void)
{
    for (uint16_t i = 0; i < row_count; i++) {
        if (called[i] == 0) {
            return rows[i]->name;
        }
    }
    return row_count == 0 ? "any call" : NULL;
}
