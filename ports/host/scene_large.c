/* ports/host/scene_large.c: draws a scene n times as large and averages. scene_samples.c calls it.
 * Triangles are drawn on the large surface with their positions times n. Other steps name whole
 * pixels: they are drawn in place, on two surfaces whose colours differ everywhere; where these
 * agree afterwards the step has written, and n x n samples get its value. What blends is lost so.
 */
#include <stdlib.h>
#include <string.h>

#include "../../core/frame/supersample.h"
#include "scene_passes.h"

/* A scene while it is drawn: large, and twice in place. */
struct large {
    struct etch_scene_run run, zeros, ones;
    uint16_t *memory, *small; /* from malloc, as etch_scene_add_planes has them */
    size_t size;              /* pixels of the strip */
    int n;
};

/* Index of sample k of n x n of a pixel. */
static size_t sample_of(const struct large *l, size_t pixel, size_t k)
{
    const size_t width = l->zeros.surface.stride, n = (size_t)l->n;

    return (pixel / width * n + k / n) * l->run.surface.stride + pixel % width * n + k % n;
}

/* Depth and stencil in place are those of the first samples. */
static void take_planes(struct large *l, const struct etch_surface *to)
{
    const struct etch_surface *large = &l->run.surface;

    for (size_t i = 0; i < l->size; i++) {
        if (to->depth != NULL) {
            to->depth[i] = large->depth[sample_of(l, i, 0)];
        }
        if (to->stencil != NULL) {
            to->stencil[i] = large->stencil[sample_of(l, i, 0)];
        }
    }
}

/* What was written in place goes to all samples: colours that agree, planes that changed. */
static void give_planes(struct large *l)
{
    const struct etch_surface *a = &l->zeros.surface, *large = &l->run.surface;
    const size_t samples = (size_t)l->n * (size_t)l->n;

    for (size_t i = 0; i < l->size; i++) {
        const size_t first = sample_of(l, i, 0);
        const bool colored = a->pixels[i] == l->ones.surface.pixels[i];
        const bool deep = a->depth != NULL && a->depth[i] != large->depth[first];
        const bool marked = a->stencil != NULL && a->stencil[i] != large->stencil[first];

        for (size_t k = 0; k < samples; k++) {
            const size_t at = sample_of(l, i, k);

            if (colored) {
                large->pixels[at] = a->pixels[i];
            }
            if (deep) {
                large->depth[at] = a->depth[i];
            }
            if (marked) {
                large->stencil[at] = a->stencil[i];
            }
        }
    }
}

static void draw_in_place(struct large *l, const struct etch_scene_step *step)
{
    struct etch_scene_run *a = &l->zeros, *b = &l->ones;

    memset(a->surface.pixels, 0, l->size * sizeof(uint16_t));
    memset(b->surface.pixels, 255, l->size * sizeof(uint16_t));
    take_planes(l, &a->surface);
    take_planes(l, &b->surface);
    step->statement->draw(a, step);
    step->statement->draw(b, step);
    give_planes(l);
    l->run.surface.clip = etch_supersample_window(a->surface.clip, (uint8_t)l->n);
    l->run.motion_x_q8 = a->motion_x_q8;
    l->run.motion_y_q8 = a->motion_y_q8;
}

/* A surface of `window` over memory. */
static bool open_run(const struct etch_scene_frame *frame, struct etch_scene_run *run,
                     uint16_t *memory, size_t size, struct etch_rect window)
{
    struct etch_surface surface;

    if (etch_surface_init(&surface, memory, window, (uint16_t)(window.x1 - window.x0)) != ETCH_OK) {
        return false;
    }
    etch_scene_add_planes(frame->scene, &surface, memory, size);
    *run = etch_scene_make_run(frame, &surface);
    return true;
}

static bool open_large(const struct etch_scene_frame *frame, struct large *l,
                       struct etch_rect window)
{
    const size_t n = (size_t)frame->passes->samples;
    const size_t size = (size_t)(window.x1 - window.x0) * (size_t)(window.y1 - window.y0);

    l->n = frame->passes->samples;
    l->size = size;
    l->memory = calloc(3 * n * n * size, sizeof *l->memory);
    l->small = calloc(6 * size, sizeof *l->small);
    return l->memory != NULL && l->small != NULL &&
           open_run(frame, &l->run, l->memory, n * n * size,
                    etch_supersample_window(window, (uint8_t)n)) &&
           open_run(frame, &l->zeros, l->small, size, window) &&
           open_run(frame, &l->ones, l->small + 3 * size, size, window);
}

static void resolve(const struct large *l, const struct etch_surface *surface, bool swapped)
{
    static void (*const functions[3][2])(const struct etch_surface *,
                                         const struct etch_surface *) = {
        {etch_supersample_resolve_2, etch_supersample_resolve_2_swapped},
        {etch_supersample_resolve_3, etch_supersample_resolve_3_swapped},
        {etch_supersample_resolve_4, etch_supersample_resolve_4_swapped}};

    functions[l->n - 2][swapped](&l->run.surface, surface);
}

bool etch_scene_draw_large(const struct etch_scene_frame *frame, struct etch_surface *surface,
                           bool swapped)
{
    struct etch_scene_pass pass = etch_scene_make_pass(frame);
    struct large l = {.memory = NULL};
    bool ok = open_large(frame, &l, surface->window) && etch_scene_run_open(&l.run);

    if (ok) {
        l.ones.stats = NULL;
        ok = etch_scene_run_open(&l.zeros) && etch_scene_run_open(&l.ones);
    }
    pass.scale = frame->passes->samples;
    for (size_t i = 0; ok && i < frame->scene->count; i++) {
        const struct etch_scene_step *step = &frame->scene->step[i];

        if (etch_scene_is_placed(step)) {
            etch_scene_draw_step(&l.run, step, &pass);
        } else {
            draw_in_place(&l, step);
        }
    }
    if (ok) {
        resolve(&l, surface, swapped);
    }
    etch_scene_run_close(&l.run);
    etch_scene_run_close(&l.zeros);
    etch_scene_run_close(&l.ones);
    free(l.memory);
    free(l.small);
    return ok;
}
