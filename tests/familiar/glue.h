/* tests/familiar: what run.c calls. */
#ifndef TESTS_FAMILIAR_GLUE_H
#define TESTS_FAMILIAR_GLUE_H

#include "ports/familiar/gfx.h"

#ifdef __cplusplus
extern "C"
#endif
    /* The sketch's setup and loop, once, on this surface. `turn` and `context` become the
     * display's. */
    void
    sketch_draw(const struct etch_surface *surface, void (*turn)(struct gfx *), void *context);

#endif
