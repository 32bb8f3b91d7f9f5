/* ports/host/scene_facts.h: what a scene's triangles are like, noted while it is drawn once over
 * the whole frame: what a program for this scene alone could do without. report_needs.c prints it.
 */
#ifndef ETCH_HOST_SCENE_FACTS_H
#define ETCH_HOST_SCENE_FACTS_H

#include "scene_steps.h"

struct etch_scene_facts {
    int16_t width;
    uint8_t *times; /* of each pixel, how often fills with a depth test had it, up to 255; the
                       caller's, 0 */

    uint64_t triangles; /* handed to the rasteriser */
    uint64_t of_one_color;
    uint64_t at_centres;           /* with all vertices at centres of pixels */
    uint64_t textured, of_equal_w; /* textured, and with one w for all three vertices */
    uint64_t tested;               /* with a depth test */
    bool testing;                  /* so is the one that is being drawn */
};

/* Notes one, before it is drawn; nothing if run->stats has no facts. */
void etch_scene_facts_triangle(const struct etch_scene_run *run,
                               const struct etch_scene_pipeline *pipeline,
                               const struct etch_vertex *const v[3]);
void etch_scene_facts_texture(const struct etch_scene_run *run,
                              const struct etch_scene_pipeline *pipeline,
                              const struct etch_texture_vertex *const v[3]);

/* Notes the runs of a fill. */
void etch_scene_facts_runs(struct etch_scene_facts *facts, int16_t y0, const struct etch_run *runs,
                           uint8_t n);

#endif
