/* ports/host/scene_lines.h: what the statements of lines and points share; no part of the API. */
#ifndef ETCH_HOST_SCENE_LINES_H
#define ETCH_HOST_SCENE_LINES_H

#include "../../core/draw/line.h"
#include "../../core/draw/point.h"
#include "scene_steps.h"

enum etch_scene_line_kind {
    ETCH_SCENE_POINT,
    ETCH_SCENE_LINE,
    ETCH_SCENE_WIDE,
    ETCH_SCENE_VOLUME /* a triangle of cvtri */
};

/* Sets step->pipeline, for the state without texture, and what it needs. False, with an error set,
 * if etch has none. */
bool etch_scene_lines_pipeline(struct etch_scene_reader *reader, struct etch_scene_step *step,
                               enum etch_scene_line_kind kind);

/* A line from v[0] to v[1], a line of a width and a point by the step's pipeline. */
void etch_scene_paint_line(struct etch_scene_run *run, const struct etch_scene_step *step,
                           const struct etch_vertex v[2]);
void etch_scene_paint_wide(struct etch_scene_run *run, const struct etch_scene_step *step,
                           const struct etch_vertex v[2], uint16_t size_q8);
void etch_scene_paint_point(struct etch_scene_run *run, const struct etch_scene_step *step,
                            const struct etch_vertex *v, uint16_t size_q8, etch_point_runs *runs);

/* x y z r g b: on the screen, opaque. */
bool etch_scene_read_line_vertex(struct etch_scene_reader *reader, struct etch_vertex *v);

/* Takes `alpha A ..`, one for each of n vertices, if it follows. */
bool etch_scene_read_alphas(struct etch_scene_reader *reader, uint8_t *const alpha[], int n);

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
