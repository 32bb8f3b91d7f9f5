/* ports/host/scene_lines.h: what the statements of lines and points share; no part of the API. */
#ifndef ETCH_HOST_SCENE_LINES_H
#define ETCH_HOST_SCENE_LINES_H

#include "../../core/draw/line.h"
#include "scene_steps.h"

/* Sets step->pipeline: the state's depth test, without texture. False, with an error set, if the
 * state asks for more. */
bool etch_scene_lines_pipeline(struct etch_scene_reader *reader, struct etch_scene_step *step);

/* A line from v[0] to v[1] by the step's pipeline. */
void etch_scene_lines_paint(struct etch_scene_run *run, const struct etch_scene_step *step,
                            const struct etch_vertex v[2]);

/* A sink that paints the lines of a step. */
struct etch_scene_line_sink {
    struct etch_sink sink; /* first */
    struct etch_scene_run *run;
    const struct etch_scene_step *step;
};
void etch_scene_line_sink_init(struct etch_scene_line_sink *lines, struct etch_scene_run *run,
                               const struct etch_scene_step *step);

/* The kernel of fragment/flat.h, behind the counting one if there are stats. */
etch_kernel *etch_scene_flat(struct etch_scene_run *run);

#endif
