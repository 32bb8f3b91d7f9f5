/* ports/host/scene_draw.c: walks a scene's steps on one surface. The frame loop in simulate.c
 * calls it for every strip. */
#include <stdlib.h>

#include "../../core/draw/shapes.h"
#include "scene_facts.h"
#include "scene_staged.h"
#include "scene_steps.h"

uint16_t etch_scene_color(const struct etch_scene_run *run, const uint8_t rgb[3])
{
    const uint16_t color = etch_rgb565(rgb[0], rgb[1], rgb[2]);
    return run->scene->format == ETCH_FORMAT_RGB565_SWAPPED ? etch_rgb565_swap(color) : color;
}

/* Returns the run that the surface belongs to. */
static const struct etch_scene_run *count(const struct etch_surface *surface, int16_t y0,
                                          const struct etch_run *runs, uint8_t n)
{
    const struct etch_scene_run *run = (const struct etch_scene_run *)(const void *)surface;

    if (run->stats->facts != NULL) {
        etch_scene_facts_runs(run->stats->facts, y0, runs, n);
    }
    for (uint8_t i = 0; i < n; i++) {
        run->stats->runs += runs[i].x1 > runs[i].x0;
        run->stats->pixels += (uint64_t)(runs[i].x1 - runs[i].x0);
    }
    return run;
}

void etch_scene_count(const struct etch_surface *surface, int16_t y0, const struct etch_run *runs,
                      uint8_t n, const struct etch_paint *paint)
{
    const struct etch_scene_run *run = count(surface, y0, runs, n);

    if (run->kernel != NULL) {
        run->kernel(surface, y0, runs, n, paint);
    }
}

/* The counting kernels of a texture: which one is called says which is counted. */

static void count_affine(const struct etch_surface *surface, int16_t y0,
                         const struct etch_run *runs, uint8_t n, const struct etch_paint *paint)
{
    count(surface, y0, runs, n)->texture->affine(surface, y0, runs, n, paint);
}

static void count_blocks(const struct etch_surface *surface, int16_t y0,
                         const struct etch_run *runs, uint8_t n, const struct etch_paint *paint)
{
    count(surface, y0, runs, n)->texture->blocks(surface, y0, runs, n, paint);
}

static void count_exact(const struct etch_surface *surface, int16_t y0, const struct etch_run *runs,
                        uint8_t n, const struct etch_paint *paint)
{
    count(surface, y0, runs, n)->texture->exact(surface, y0, runs, n, paint);
}

void etch_scene_paint_texture(struct etch_scene_run *run,
                              const struct etch_scene_pipeline *pipeline,
                              const struct etch_texture_vertex *const v[3],
                              const struct etch_texture *texture)
{
    static const struct etch_perspective_kernels counting = {count_affine, count_blocks,
                                                             count_exact};
    const struct etch_perspective_kernels *kernels = run->stats != NULL ? &counting
                                                                        : pipeline->texture;
    const bool depth = pipeline->ztest != 0;

    etch_scene_facts_texture(run, pipeline, v);
    if (run->pass != NULL) {
        etch_scene_pass_texture(run, pipeline, v, texture);
        return;
    }
    if (pipeline->staged != NULL) {
        const struct etch_vertex *const corners[3] = {&v[0]->at, &v[1]->at, &v[2]->at};

        etch_scene_staged_draw(run, pipeline->staged, corners);
        return;
    }
    run->texture = pipeline->texture;
    if (!pipeline->perspective) {
        (depth ? etch_triangle_texture_depth : etch_triangle_texture)(&run->surface, v, texture,
                                                                      kernels->affine);
    } else {
        (depth ? etch_triangle_perspective_depth : etch_triangle_perspective)(&run->surface, v,
                                                                              texture, kernels);
    }
}

etch_kernel *etch_scene_kernel(struct etch_scene_run *run,
                               const struct etch_scene_pipeline *pipeline)
{
    run->kernel = pipeline->kernel[run->scene->format];
    return run->stats != NULL ? etch_scene_count : run->kernel;
}

etch_triangle_painter *etch_scene_painter(const struct etch_scene_run *run,
                                          const struct etch_scene_pipeline *pipeline)
{
    return pipeline->painter[run->scene->format];
}

/* The painter is called by the raster sink; this one counts before. */
static void count_triangle(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    struct etch_scene_sink *counting = (struct etch_scene_sink *)(void *)sink;
    const struct etch_raster_sink *raster = &counting->raster;

    etch_scene_facts_triangle(counting->run, counting->pipeline, v);
    counting->run->stats->triangles++;
    raster->painter(raster->surface, v, raster->kernel);
}

static void take_staged(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    struct etch_scene_sink *staged = (struct etch_scene_sink *)(void *)sink;

    if (staged->run->stats != NULL) {
        etch_scene_facts_triangle(staged->run, staged->pipeline, v);
        staged->run->stats->triangles++;
    }
    etch_scene_staged_draw(staged->run, staged->pipeline->staged, v);
}

/* Places before. */
static void pass_triangle(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    struct etch_scene_sink *placing = (struct etch_scene_sink *)(void *)sink;

    if (placing->run->stats != NULL) {
        placing->run->stats->triangles++;
    }
    etch_scene_pass_triangle(placing->run, placing->pipeline, v);
}

void etch_scene_sink_init(struct etch_scene_sink *sink, struct etch_scene_run *run,
                          const struct etch_scene_pipeline *pipeline)
{
    sink->run = run;
    sink->pipeline = pipeline;
    etch_raster_sink_init(&sink->raster, &run->surface, etch_scene_painter(run, pipeline),
                          etch_scene_kernel(run, pipeline));
    if (run->stats != NULL) {
        sink->raster.sink.triangle = count_triangle;
    }
    if (pipeline->staged != NULL) {
        sink->raster.sink.triangle = take_staged;
    }
    if (run->pass != NULL) {
        sink->raster.sink.triangle = pass_triangle;
    }
}

/* A plane of zeros to count outlines on, of the surface's layout. */
static bool make_scratch(struct etch_scene_run *run)
{
    const size_t rows = (size_t)(run->surface.window.y1 - run->surface.window.y0);

    if (run->stats != NULL) {
        run->scratch = calloc(rows * run->surface.stride, sizeof *run->scratch);
    }
    return run->stats == NULL || run->scratch != NULL;
}

bool etch_scene_run_open(struct etch_scene_run *run)
{
    if (!make_scratch(run)) {
        return false;
    }
    etch_surface_clear(&run->surface, 0);
    if (run->surface.depth != NULL) {
        etch_depth_clear(&run->surface, UINT16_MAX);
    }
    if (run->surface.stencil != NULL) {
        etch_stencil_clear(&run->surface, 0);
    }
    return true;
}

void etch_scene_run_close(struct etch_scene_run *run)
{
    free(run->scratch);
}

bool etch_scene_draw(const struct etch_scene *scene, struct etch_surface *surface,
                     struct etch_scene_stats *stats)
{
    struct etch_scene_run run = {
        .surface = *surface, .clip = surface->clip, .scene = scene, .stats = stats};

    if (scene->passes != NULL) {
        return etch_scene_passes_draw(scene, surface, stats);
    }
    if (!etch_scene_run_open(&run)) {
        return false;
    }
    for (size_t i = 0; i < scene->count; i++) {
        if (stats != NULL && stats->facts != NULL) {
            stats->facts->testing = false;
        }
        scene->step[i].statement->draw(&run, &scene->step[i]);
    }
    etch_scene_run_close(&run);
    return true;
}
