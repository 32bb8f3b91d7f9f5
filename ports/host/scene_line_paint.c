/* ports/host/scene_line_paint.c: draws lines and points with the state: by a fused kernel if there
 * is one, else by stages. The statements of lines, lists and wireframes call it. */
#include "../../core/draw/line_staged.h"
#include "../../core/fragment/flat.h"
#include "scene_lines.h"
#include "scene_staged.h"

bool etch_scene_lines_pipeline(struct etch_scene_reader *reader, struct etch_scene_step *step,
                               enum etch_scene_line_kind kind)
{
    static const char *const needs[][3] = {
        {"etch_point_paint", "etch_point_paint", "etch_point_staged"},
        {"etch_line_gouraud", "etch_line_gouraud_depth", "etch_line_staged"},
        {"etch_line_wide", "etch_line_wide", "etch_line_wide_staged"},
        {NULL, NULL, NULL},
    };
    const struct etch_scene_pipeline *pipeline = etch_scene_read_line_pipeline(reader);

    if (pipeline == NULL) {
        return false;
    }
    step->pipeline = pipeline;
    step->needs = needs[kind][pipeline->staged != NULL ? 2 : pipeline->ztest != 0];
    return true;
}

/* The lists that a line or point of a step is drawn with, in the scene's format. */
static struct etch_line_pipeline take_stages(struct etch_scene_run *run,
                                             const struct etch_scene_staged *staged)
{
    const struct etch_line_pipeline pipeline = {
        staged->line_varyings, staged->stages[run->scene->format],
        run->stats != NULL ? etch_scene_count : etch_kernel_staged};

    run->kernel = etch_kernel_staged;
    return pipeline;
}

void etch_scene_paint_line(struct etch_scene_run *run, const struct etch_scene_step *step,
                           const struct etch_vertex v[2])
{
    const struct etch_vertex *const ends[2] = {&v[0], &v[1]};
    struct etch_staged_planes planes;

    if (step->pipeline->staged != NULL) {
        const struct etch_line_pipeline stages = take_stages(run, step->pipeline->staged);

        etch_line_staged(&run->surface, ends, &stages, &planes);
        return;
    }
    (step->pipeline->ztest != 0 ? etch_line_gouraud_depth : etch_line_gouraud)(
        &run->surface, ends, etch_scene_kernel(run, step->pipeline));
}

void etch_scene_paint_wide(struct etch_scene_run *run, const struct etch_scene_step *step,
                           const struct etch_vertex v[2], uint16_t size_q8)
{
    const struct etch_vertex *const ends[2] = {&v[0], &v[1]};
    const struct etch_scene_staged *staged = step->pipeline->staged;
    struct etch_staged_planes planes;

    if (run->stats != NULL) {
        run->stats->triangles += 2;
    }
    if (staged != NULL) {
        const struct etch_line_pipeline lists = take_stages(run, staged);
        const struct etch_pipeline stages = {staged->varyings, lists.stages, lists.kernel};

        etch_line_wide_staged(&run->surface, ends, size_q8, &stages, &planes);
        return;
    }
    etch_line_wide(&run->surface, ends, size_q8, etch_scene_painter(run, step->pipeline),
                   etch_scene_kernel(run, step->pipeline));
}

void etch_scene_paint_point(struct etch_scene_run *run, const struct etch_scene_step *step,
                            const struct etch_vertex *v, uint16_t size_q8, etch_point_runs *runs)
{
    struct etch_staged_planes planes;

    if (step->pipeline->staged != NULL) {
        const struct etch_line_pipeline stages = take_stages(run, step->pipeline->staged);

        etch_point_staged(&run->surface, v, size_q8, runs, &stages, &planes);
        return;
    }
    etch_point_paint(&run->surface, v, size_q8, runs, etch_scene_kernel(run, step->pipeline));
}

static void take_line(struct etch_sink *sink, const struct etch_vertex *const v[2])
{
    const struct etch_scene_line_sink *lines = (const void *)sink;
    const struct etch_vertex ends[2] = {*v[0], *v[1]};

    etch_scene_paint_line(lines->run, lines->step, ends);
}

void etch_scene_line_sink_init(struct etch_scene_line_sink *lines, struct etch_scene_run *run,
                               const struct etch_scene_step *step)
{
    lines->sink = (struct etch_sink){.line = take_line};
    lines->run = run;
    lines->step = step;
}

etch_kernel *etch_scene_flat(struct etch_scene_run *run)
{
    run->kernel = etch_kernel_flat;
    return run->stats != NULL ? etch_scene_count : etch_kernel_flat;
}
