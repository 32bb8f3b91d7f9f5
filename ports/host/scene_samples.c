/* ports/host/scene_samples.c: draws the steps of a scene, with four samples a pixel or one. The
 * passes of scene_exposure.c call it for each drawing. Triangles and meshes are placed by sample;
 * other steps name whole pixels, so they are drawn as they are and fill all samples of a pixel. */
#include <stdlib.h>
#include <string.h>

#include "scene_passes.h"

bool etch_scene_is_placed(const struct etch_scene_step *step)
{
    static const char *const names[] = {"tri", "ctri", "mesh"};
    bool is = false;

    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        is |= strcmp(step->statement->name, names[i]) == 0;
    }
    return is;
}

struct etch_scene_run etch_scene_make_run(const struct etch_scene_frame *frame,
                                          const struct etch_surface *surface)
{
    const struct etch_scene_run run = {
        .surface = *surface, .clip = surface->clip, .scene = frame->scene, .stats = frame->stats};

    return run;
}

struct etch_scene_pass etch_scene_make_pass(const struct etch_scene_frame *frame)
{
    const struct etch_scene_pass pass = {
        .scale = 1, .moment = frame->moment, .moments = frame->passes->moments};

    return pass;
}

void etch_scene_draw_step(struct etch_scene_run *run, const struct etch_scene_step *step,
                          const struct etch_scene_pass *pass)
{
    run->pass = pass;
    step->statement->draw(run, step);
    run->pass = NULL;
}

bool etch_scene_draw_placed(const struct etch_scene_frame *frame, struct etch_surface *surface,
                            const struct etch_scene_pass *pass)
{
    struct etch_scene_run run = etch_scene_make_run(frame, surface);

    if (!etch_scene_run_open(&run)) {
        return false;
    }
    for (size_t i = 0; i < frame->scene->count; i++) {
        etch_scene_draw_step(&run, &frame->scene->step[i], pass);
    }
    etch_scene_run_close(&run);
    return true;
}

size_t etch_scene_size_of(struct etch_rect window)
{
    return (size_t)(window.x1 - window.x0) * (size_t)(window.y1 - window.y0);
}

uint16_t *etch_scene_get_planes(const struct etch_rect window, size_t samples)
{
    return calloc(samples * etch_scene_size_of(window), 3 * sizeof(uint16_t));
}

void etch_scene_add_planes(const struct etch_scene *scene, struct etch_surface *surface,
                           uint16_t *memory, size_t size)
{
    surface->depth = scene->uses_depth ? memory + size : NULL;
    surface->stencil = scene->uses_stencil ? (uint8_t *)(memory + 2 * size) : NULL;
}

bool etch_scene_open_runs(const struct etch_scene_frame *frame, struct etch_surface *sample,
                          struct etch_scene_run *run, uint16_t *memory, int n)
{
    const size_t size = etch_scene_size_of(sample[0].window);
    bool ok = true;

    for (int i = 0; ok && i < n; i++) {
        uint16_t *rest = memory + (size_t)n * size + 2 * (size_t)i * size;

        etch_scene_add_planes(frame->scene, &sample[i], rest - size, size);
        run[i] = etch_scene_make_run(frame, &sample[i]);
        run[i].stats = i == 0 ? frame->stats : NULL;
        ok = etch_scene_run_open(&run[i]);
    }
    return ok;
}

/* ---- msaa
 * ---------------------------------------------------------------------------------------- */

static void multisample_step(struct etch_scene_run run[ETCH_SAMPLES],
                             const struct etch_scene_step *step, struct etch_multisample *m,
                             struct etch_scene_pass *pass)
{
    const bool together = etch_scene_is_placed(step) && etch_scene_pass_paints(step->pipeline);

    for (int i = 0; i < ETCH_SAMPLES; i++) {
        m->sample[i] = run[i].surface;
    }
    pass->samples = together ? m : NULL;
    for (int i = 0; i < (together ? 1 : ETCH_SAMPLES); i++) {
        pass->offset = together ? (struct etch_offset_q8){0, 0} : etch_jitter_4[i];
        etch_scene_draw_step(&run[i], step, pass);
    }
}

static bool draw_multisampled(const struct etch_scene_frame *frame, struct etch_surface *surface,
                              bool swapped)
{
    const struct etch_rect window = surface->window;
    uint16_t *memory = etch_scene_get_planes(window, ETCH_SAMPLES);
    struct etch_scene_pass pass = etch_scene_make_pass(frame);
    struct etch_scene_run run[ETCH_SAMPLES];
    struct etch_multisample m;
    bool ok = etch_multisample_init(&m, memory, NULL, window) == ETCH_OK &&
              etch_scene_open_runs(frame, m.sample, run, memory, ETCH_SAMPLES);

    for (size_t i = 0; ok && i < frame->scene->count; i++) {
        multisample_step(run, &frame->scene->step[i], &m, &pass);
    }
    if (ok) {
        etch_scene_run_close(&run[0]);
        etch_multisample_clip(&m, window);
        (swapped ? etch_multisample_resolve_swapped : etch_multisample_resolve)(&m, surface);
    }
    free(memory);
    return ok;
}

bool etch_scene_draw_samples(const struct etch_scene_frame *frame, struct etch_surface *surface,
                             bool swapped)
{
    const struct etch_scene_pass pass = etch_scene_make_pass(frame);

    switch (frame->passes->antialias) {
    case ETCH_SCENE_SSAA: return etch_scene_draw_large(frame, surface, swapped);
    case ETCH_SCENE_MSAA: return draw_multisampled(frame, surface, swapped);
    case ETCH_SCENE_SHARED: return etch_scene_draw_shared(frame, surface, swapped);
    default: break;
    }
    if (!etch_scene_draw_placed(frame, surface, &pass)) {
        return false;
    }
    if (swapped) {
        etch_scene_swap(surface);
    }
    return true;
}
