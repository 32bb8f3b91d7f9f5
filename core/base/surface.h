/* base/surface.h: the memory that drawing writes to.
 *
 * Coordinates are always those of the frame. `window` says which rectangle of the frame this
 * memory holds, `clip` which part of it may be written: a strip is a surface whose window is
 * a strip, and drawing code never knows.
 *
 *      frame (0,0) +------------------------------+
 *                  |                              |
 *           window +------------------------------+ <- pixels[0] is (window.x0, window.y0)
 *                  |     +------- clip ------+    |
 *                  +-----+-------------------+----+
 */
#ifndef ETCH_BASE_SURFACE_H
#define ETCH_BASE_SURFACE_H

#include "rect.h"

struct etch_surface {
    uint16_t *pixels;        /* colour plane; the caller's memory, aligned to 2 bytes */
    uint16_t *depth;         /* 16-bit depth plane of the same layout, or NULL */
    uint16_t stride;         /* elements from one row to the next, in every plane */
    struct etch_rect window; /* rectangle of the frame that the planes hold */
    struct etch_rect clip;   /* what may be written; always inside window */
    uint8_t *stencil;        /* 8-bit stencil plane of the same layout, or NULL */
};

/* Makes a surface over the caller's `pixels`, which hold `window` of the frame, rows `stride`
 * elements apart; clip becomes the window, depth and stencil NULL. The memory must stay valid while
 * the surface is used; nothing is allocated or copied.
 * ETCH_EINVAL if pixels is NULL, the window is empty or not within 0 .. 32767, or the stride
 * is less than its width; *s is then left as it was. */
enum etch_status etch_surface_init(struct etch_surface *s, uint16_t *pixels,
                                   struct etch_rect window, uint16_t stride);

/* Sets the clip (scissor) to the part of `clip` inside the window, whatever `clip` is. */
void etch_surface_clip(struct etch_surface *s, struct etch_rect clip);

/* Index into a plane of frame pixel (x, y), which must lie in the window. */
ETCH_INLINE size_t etch_surface_index(const struct etch_surface *s, int16_t x, int16_t y)
{
    return (size_t)(y - s->window.y0) * s->stride + (size_t)(x - s->window.x0);
}

/* Addresses as numbers, modulo the address space: they may pass below a plane on the way to it. */
ETCH_INLINE uintptr_t etch_wrap_address_add(uintptr_t a, uintptr_t b)
{
    return a + b;
}

ETCH_INLINE uintptr_t etch_wrap_address_sub(uintptr_t a, uintptr_t b)
{
    return a - b;
}

/* Address of column 0 of frame row y in a plane, where pixel x stands 2 x bytes further on. The
 * window may begin right of column 0: then this is an address that is never read, and a number
 * rather than a pointer. */
ETCH_INLINE uintptr_t etch_surface_row(const struct etch_surface *s, const uint16_t *plane,
                                       int16_t y)
{
    const size_t down = (size_t)(y - s->window.y0) * s->stride;

    return etch_wrap_address_sub((uintptr_t)(plane + down), (uintptr_t)s->window.x0 * 2);
}

#endif
