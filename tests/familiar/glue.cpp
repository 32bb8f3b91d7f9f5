/* tests/familiar: a sketch, and how run.c reaches it. */
#include "glue.h"

#include SKETCH

void sketch_draw(const struct etch_surface *surface, void (*turn)(struct gfx *), void *context)
{
    tft.rotation = 0;
    tft.turn = turn;
    tft.context = context;
    tft.surface = *surface;
    setup();
    loop();
}
