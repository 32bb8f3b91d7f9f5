/* ports/host/simulate.h: a scene through the frame loop to a screen. */
#ifndef ETCH_HOST_SIMULATE_H
#define ETCH_HOST_SIMULATE_H

#include "scene.h"
#include "screen.h"

struct etch_simulation {
    const struct etch_scene *scene; /* the caller's */
    const char *port;               /* a name of screen.h */
    struct etch_screen_panel panel; /* read if the port is a panel */
    int16_t rows;                   /* of a strip, 1 .. the scene's height */
    bool keeps_depth;               /* the depth of the whole frame is wanted */
    bool keeps_stencil;             /* likewise */
    bool counts;                    /* fill in stats */

    /* Filled in. */
    struct etch_screen screen;
    struct etch_scene_stats stats;
    uint16_t *depth;   /* of the whole frame, rows without a gap */
    uint16_t *stencil; /* likewise, a word a value */
    /* RAM that the buffers take, or a direct display's memory */
    uint64_t color_bytes, depth_bytes, stencil_bytes;
};

/* Draws one frame. False, with the reason in *error, which names `path`, if the port is unknown
 * or memory cannot be had. Close in both cases. */
bool etch_simulate(struct etch_simulation *simulation, const char *path, struct etch_error *error);

void etch_simulation_close(struct etch_simulation *simulation);

#endif
