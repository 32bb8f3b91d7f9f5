/* vertex/viewport.h: clip space to the frame.
 *
 * x = -w .. w maps to the left .. right edge of the viewport's rectangle, y = -w .. w to its
 * bottom .. top edge (y turns round), z = -w .. w to depth 0 .. 65535. Each is rounded once,
 * half up, from the exact quotient: positions to 1/256 px, depth to 1/65536.
 *
 * The rectangle is in frame pixels and may be larger than the surface. What lies beyond it is
 * not promised to be drawn nor to be left out: set the surface's clip where that matters.
 *
 * Positions have a range (+-32768 px), so besides near and far a triangle is clipped against
 * guard planes |x| <= 2^guard_x w and |y| <= 2^guard_y w, which lie outside the rectangle and
 * inside the range. Few triangles reach them.
 */
#ifndef ETCH_VERTEX_VIEWPORT_H
#define ETCH_VERTEX_VIEWPORT_H

#include "../base/rect.h"
#include "../base/sink.h"
#include "transform.h"

struct etch_viewport {
    struct etch_rect rect;
    uint8_t guard_x, guard_y; /* 0 .. 10 */
};

/* ETCH_EINVAL if the rectangle is empty; *v is then left as it was. */
enum etch_status etch_viewport_init(struct etch_viewport *v, struct etch_rect rect);

/* Outcode: which planes a vertex is outside of. Three vertices that share a bit are invisible;
 * if none has a bit of ETCH_OUT_CLIP the triangle needs no clipping. */
enum {
    ETCH_OUT_LEFT = 1 << 0,   /* x < -w */
    ETCH_OUT_RIGHT = 1 << 1,  /* x > w */
    ETCH_OUT_BOTTOM = 1 << 2, /* y < -w */
    ETCH_OUT_TOP = 1 << 3,    /* y > w */
    ETCH_OUT_NEAR = 1 << 4,   /* z < -w, or x = y = z = w = 0, which is the eye */
    ETCH_OUT_FAR = 1 << 5,    /* z > w */
    ETCH_OUT_GUARD = 1 << 6,  /* |x| or |y| beyond the guard planes: clip, do not reject */
    ETCH_OUT_CLIP = ETCH_OUT_NEAR | ETCH_OUT_FAR | ETCH_OUT_GUARD,
    ETCH_OUT_REJECT = 0x3F
};
uint8_t etch_viewport_outcode(const struct etch_viewport *v, const struct etch_clip_vertex *in);

/* Projects a vertex whose outcode has no bit of ETCH_OUT_CLIP (then w > 0 and the result fits);
 * copies the colour. About 360 instructions on ARMv6-M (bench W15), and a 32-bit divide for
 * each of x and y beyond w; from w = 16384.0 on three 64-bit divides instead. */
void etch_viewport_project(const struct etch_viewport *v, const struct etch_clip_vertex *in,
                           struct etch_vertex *out);

#endif
