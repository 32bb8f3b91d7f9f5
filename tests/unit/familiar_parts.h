/* tests/unit: what the suites of ports/familiar share: a canvas against tests/oracle/gfx.h. */
#ifndef TESTS_UNIT_FAMILIAR_PARTS_H
#define TESTS_UNIT_FAMILIAR_PARTS_H

#include "tests/harness/canvas.h"
#include "tests/oracle/gfx.h"

/* The canvas has exactly the oracle's pixels, and guard words outside its clip; else the case
 * fails. */
static inline bool same_pixels(const struct test_canvas *canvas)
{
    const struct etch_rect c = canvas->surface.clip;

    for (int32_t y = c.y0; y < c.y1; y++)
        for (int32_t x = c.x0; x < c.x1; x++)
            if (!CHECK_EQ(test_canvas_at(canvas, x, y), oracle_gfx_at(x, y))) {
                test_note("at x", x);
                test_note("at y", y);
                return false;
            }
    return CHECK_INSIDE(canvas);
}

#endif
