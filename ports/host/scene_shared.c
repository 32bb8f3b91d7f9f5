/* ports/host/scene_shared.c: draws the steps of a scene with samples that neighbours share.
 * scene_samples.c calls it for each drawing. */
#include <stdlib.h>

#include "scene_passes.h"

/* Copies the even or odd columns of all planes. */
static void copy_columns(const struct etch_surface *to, const struct etch_surface *from, size_t odd)
{
    const size_t size = etch_scene_size_of(to->window);

    for (size_t i = 0; i < size; i++) {
        if (((i % to->stride + (uint16_t)to->window.x0) & 1) == odd) {
            to->pixels[i] = from->pixels[i];
            if (to->depth != NULL) {
                to->depth[i] = from->depth[i];
            }
            if (to->stencil != NULL) {
                to->stencil[i] = from->stencil[i];
            }
        }
    }
}

/* Two samples of every cell, by turns of the columns: what is drawn as even cells see it in one
 * plane is replaced in odd columns by what odd cells see. */
static void shared_one_by_one(struct etch_scene_run *run, int sample,
                              const struct etch_scene_step *step, struct etch_scene_pass *pass,
                              uint16_t *spare)
{
    const struct etch_surface *s = &run->surface;
    const size_t size = etch_scene_size_of(s->window);
    struct etch_scene_run odd = *run;

    odd.stats = NULL;
    odd.surface.pixels = spare;
    etch_scene_add_planes(run->scene, &odd.surface, spare, size);
    copy_columns(&odd.surface, s, 1);
    copy_columns(&odd.surface, s, 0);
    pass->offset = etch_shared_offsets[sample];
    etch_scene_draw_step(run, step, pass);
    pass->offset = etch_shared_offsets[sample + 2];
    etch_scene_draw_step(&odd, step, pass);
    copy_columns(s, &odd.surface, 1);
}

/* Whole pixels fill the cells on both sides of them: pixel x is drawn to cell x + 1, then to x. */
static void shared_pixels(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    struct etch_scene_run left = *run;

    left.stats = NULL;
    left.surface.pixels++; /* memory that begins a cell further on */
    if (left.surface.depth != NULL)
        left.surface.depth++;
    if (left.surface.stencil != NULL)
        left.surface.stencil++;
    left.surface.window.x1--;
    left.surface.clip = etch_rect_intersect(left.surface.clip, left.surface.window);
    left.clip = etch_rect_intersect(left.clip, left.surface.window);
    step->statement->draw(&left, step);
    step->statement->draw(run, step);
}

static void shared_step(struct etch_scene_run run[ETCH_SHARED_SAMPLES],
                        const struct etch_scene_step *step, struct etch_shared_samples *m,
                        struct etch_scene_pass *pass, uint16_t *spare)
{
    const bool together = etch_scene_is_placed(step) && etch_scene_pass_paints(step->pipeline);

    for (int i = 0; i < ETCH_SHARED_SAMPLES; i++) {
        struct etch_rect clip = run[i].surface.clip;

        clip.x1 = (int16_t)(clip.x1 + (clip.x1 < run[i].surface.window.x1 ? 1 : 0));
        m->sample[i] = run[i].surface;
        m->sample[i].clip = clip;
    }
    pass->pairs = together ? m : NULL;
    pass->offset = (struct etch_offset_q8){0, 0};
    for (int i = 0; i < (together ? 1 : ETCH_SHARED_SAMPLES); i++) {
        if (!etch_scene_is_placed(step)) {
            shared_pixels(&run[i], step);
        } else if (together) {
            etch_scene_draw_step(&run[i], step, pass);
        } else {
            struct etch_rect pixels = run[i].surface.clip;

            run[i].surface.clip = m->sample[i].clip;
            shared_one_by_one(&run[i], i, step, pass, spare);
            run[i].surface.clip = pixels;
        }
    }
}

bool etch_scene_draw_shared(const struct etch_scene_frame *frame, struct etch_surface *surface,
                            bool swapped)
{
    struct etch_rect cells = surface->window;
    struct etch_scene_pass pass = etch_scene_make_pass(frame);
    struct etch_scene_run run[ETCH_SHARED_SAMPLES];
    struct etch_shared_samples m;
    uint16_t *memory, *spare;
    bool ok;

    cells.x1++;
    memory = etch_scene_get_planes(cells, ETCH_SHARED_SAMPLES);
    spare = etch_scene_get_planes(cells, 1);
    ok = spare != NULL && etch_shared_init(&m, memory, NULL, surface->window) == ETCH_OK &&
         etch_scene_open_runs(frame, m.sample, run, memory, ETCH_SHARED_SAMPLES);
    for (size_t i = 0; ok && i < frame->scene->count; i++) {
        shared_step(run, &frame->scene->step[i], &m, &pass, spare);
    }
    if (ok) {
        etch_scene_run_close(&run[0]);
        (swapped ? etch_shared_resolve_swapped : etch_shared_resolve)(&m, surface);
    }
    free(memory);
    free(spare);
    return ok;
}
