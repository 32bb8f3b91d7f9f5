/* ports/host/scene_passes.h: passes over the whole frame of a scene, and how they draw its steps.
 *
 *      scene_passes.c    antialias motionblur motion filter exchange
 *      scene_exposure.c  what is laid over each other: filter, fxaa, motionblur, accumulate
 *      scene_samples.c   a drawing with one sample a pixel, and msaa
 *      scene_shared.c    shared
 *      scene_large.c     ssaa
 *      scene_place.c     where the triangles of one of several drawings go
 *
 * Everything is drawn in rgb565; the last pass writes the scene's format. */
#ifndef ETCH_HOST_SCENE_PASSES_H
#define ETCH_HOST_SCENE_PASSES_H

#include "../../core/frame/filter.h"
#include "../../core/frame/multisample.h"
#include "../../core/frame/shared.h"
#include "scene_steps.h"

enum etch_scene_antialias {
    ETCH_SCENE_NO_ANTIALIAS,
    ETCH_SCENE_SSAA,
    ETCH_SCENE_MSAA,
    ETCH_SCENE_SHARED,
    ETCH_SCENE_ACCUMULATE,
    ETCH_SCENE_FXAA
};

enum etch_scene_filter {
    ETCH_SCENE_NO_FILTER,
    ETCH_SCENE_AVERAGE,
    ETCH_SCENE_SOBEL,
    ETCH_SCENE_KERNEL
};

/* A pass over neighbours: the source that it reads and the rows that it keeps. */
struct etch_scene_level {
    struct etch_carry carry;
    struct etch_surface source;
    uint16_t *memory, *kept; /* from malloc, NULL before the first strip */
    size_t elements;         /* of each plane in memory */
};

/* What a scene asks for; the memory of its passes. */
struct etch_scene_passes {
    enum etch_scene_antialias antialias;
    int samples; /* of ssaa a side, of accumulate */
    int moments; /* of motionblur, 1: none */
    enum etch_scene_filter filter;
    struct etch_filter_weights weights; /* of ETCH_SCENE_KERNEL */
    struct etch_scene_level fxaa, filtered;
};

/* How one of several drawings places its triangles, and which samples they go to. */
struct etch_scene_pass {
    int32_t scale;                /* of positions, 1 .. 4 */
    struct etch_offset_q8 offset; /* then subtracted */
    int32_t moment, moments;      /* what moves is at (2 moment + 1) / (2 moments) of its way */
    const struct etch_multisample *samples; /* where plain triangles are painted, or .. */
    const struct etch_shared_samples *pairs;
};

/* A frame while it is drawn by its passes. */
struct etch_scene_frame {
    const struct etch_scene *scene; /* in rgb565 and without passes */
    struct etch_scene_passes *passes;
    struct etch_scene_stats *stats;
    int32_t moment; /* of motionblur */
};

/* Gives a surface the planes beside colour that the scene uses: memory has `size` colours, as many
 * depths, and room for as many stencil values. */
void etch_scene_add_planes(const struct etch_scene *scene, struct etch_surface *surface,
                           uint16_t *memory, size_t size);

/* Pixels of a window. */
size_t etch_scene_size_of(struct etch_rect window);

/* Colour, depth and stencil of `samples` surfaces, from malloc; NULL without memory. */
uint16_t *etch_scene_get_planes(struct etch_rect window, size_t samples);

/* Opens runs over n surfaces whose colours stand one after the other in such memory. */
bool etch_scene_open_runs(const struct etch_scene_frame *frame, struct etch_surface *sample,
                          struct etch_scene_run *run, uint16_t *memory, int n);

/* Draws all steps on a surface, placed by `pass`. False without memory. */
bool etch_scene_draw_placed(const struct etch_scene_frame *frame, struct etch_surface *surface,
                            const struct etch_scene_pass *pass);

/* The same by the samples that the scene asks for, in the byte order of the surface. */
bool etch_scene_draw_samples(const struct etch_scene_frame *frame, struct etch_surface *surface,
                             bool swapped);

/* The same drawn n times as large. */
bool etch_scene_draw_large(const struct etch_scene_frame *frame, struct etch_surface *surface,
                           bool swapped);

/* The same with samples that neighbours share. */
bool etch_scene_draw_shared(const struct etch_scene_frame *frame, struct etch_surface *surface,
                            bool swapped);

/* Exchanges the bytes of every pixel in the window. */
void etch_scene_swap(const struct etch_surface *surface);

/* ---- a drawing --------------------------------------------------------------------------- */

struct etch_scene_run etch_scene_make_run(const struct etch_scene_frame *frame,
                                          const struct etch_surface *surface);
struct etch_scene_pass etch_scene_make_pass(const struct etch_scene_frame *frame);
void etch_scene_draw_step(struct etch_scene_run *run, const struct etch_scene_step *step,
                          const struct etch_scene_pass *pass);

/* Whether a step is triangles, which are placed; others name whole pixels. */
bool etch_scene_is_placed(const struct etch_scene_step *step);

/* Whether etch_scene_pass_triangle has a painter of samples for the pipeline. */
bool etch_scene_pass_paints(const struct etch_scene_pipeline *pipeline);

#endif
