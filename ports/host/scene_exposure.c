/* ports/host/scene_exposure.c: passes that draw the frame several times, or look at neighbours.
 * Calls scene_samples.c for each drawing; scene_draw.c calls it for every strip. */
#include <stdlib.h>

#include "../../core/frame/accumulation.h"
#include "../../core/frame/smooth.h"
#include "scene_passes.h"

enum {
    FXAA_ROWS = 2
};

/* One drawing of the frame on a surface. */
typedef bool drawing(struct etch_scene_frame *frame, struct etch_surface *surface, bool swapped,
                     int32_t index);

/* The average of n drawings. */
static bool accumulate(struct etch_scene_frame *frame, struct etch_surface *surface, bool swapped,
                       int32_t n, drawing *draw)
{
    const struct etch_rect window = surface->window;
    const uint16_t width = (uint16_t)(window.x1 - window.x0);
    uint16_t *sums = calloc((size_t)width * (size_t)(window.y1 - window.y0), 3 * sizeof *sums);
    struct etch_accumulation plane;
    bool ok = etch_accumulation_init(&plane, sums, window, width) == ETCH_OK;

    for (int32_t i = 0; ok && i < n; i++) {
        ok = draw(frame, surface, false, i);
        (i == 0 ? etch_accumulation_load : etch_accumulation_add)(&plane, surface, 1);
    }
    if (ok && swapped) {
        etch_accumulation_return_swapped(&plane, surface, (uint16_t)n);
    } else if (ok) {
        etch_accumulation_return(&plane, surface, (uint16_t)n);
    }
    free(sums);
    return ok;
}

static struct etch_offset_q8 jitter(int samples, int32_t i)
{
    return samples == 2   ? etch_jitter_2[i]
           : samples == 4 ? etch_jitter_4[i]
           : samples == 8 ? etch_jitter_8[i]
                          : etch_jitter_16[i];
}

static bool draw_jittered(struct etch_scene_frame *frame, struct etch_surface *surface,
                          bool swapped, int32_t i)
{
    const struct etch_scene_pass pass = {.scale = 1,
                                         .offset = jitter(frame->passes->samples, i),
                                         .moment = frame->moment,
                                         .moments = frame->passes->moments};

    (void)swapped;
    return etch_scene_draw_placed(frame, surface, &pass);
}

/* One moment of the exposure. */
static bool draw_moment(struct etch_scene_frame *frame, struct etch_surface *surface, bool swapped,
                        int32_t moment)
{
    frame->moment = moment;
    return frame->passes->antialias == ETCH_SCENE_ACCUMULATE
               ? accumulate(frame, surface, swapped, frame->passes->samples, draw_jittered)
               : etch_scene_draw_samples(frame, surface, swapped);
}

static bool draw_exposure(struct etch_scene_frame *frame, struct etch_surface *surface,
                          bool swapped)
{
    return frame->passes->moments > 1
               ? accumulate(frame, surface, swapped, frame->passes->moments, draw_moment)
               : draw_moment(frame, surface, swapped, 0);
}

/* ---- passes over neighbours
 * ---------------------------------------------------------------------- */

/* Room for the source of a strip; the rows kept, at the first. */
static bool level_open(struct etch_scene_level *level, const struct etch_scene *scene,
                       const struct etch_surface *strip, uint8_t rows, uint8_t columns)
{
    const struct etch_rect frame = {0, 0, scene->width, scene->height};
    const size_t height = (size_t)(strip->window.y1 - strip->window.y0) + 2 * rows;
    const size_t elements = height * (uint16_t)scene->width;

    if (level->kept == NULL) {
        level->kept = calloc((size_t)scene->width * 2 * rows, sizeof *level->kept);
        if (etch_carry_init(&level->carry, level->kept, frame, rows, columns) != ETCH_OK) {
            return false;
        }
    }
    if (level->elements < elements) {
        free(level->memory);
        level->memory = calloc(elements, 3 * sizeof *level->memory);
        level->elements = level->memory != NULL ? elements : 0;
    }
    if (level->memory == NULL || etch_surface_init(&level->source, level->memory, frame,
                                                   (uint16_t)scene->width) != ETCH_OK) {
        return false;
    }
    etch_scene_add_planes(scene, &level->source, level->memory, level->elements);
    return true;
}

static bool draw_smoothed(struct etch_scene_frame *frame, struct etch_surface *surface,
                          bool swapped)
{
    struct etch_scene_level *level = &frame->passes->fxaa;

    if (frame->passes->antialias != ETCH_SCENE_FXAA) {
        return draw_exposure(frame, surface, swapped);
    }
    if (!level_open(level, frame->scene, surface, FXAA_ROWS, ETCH_SMOOTH_COLUMNS) ||
        (etch_carry_begin(&level->carry, surface, &level->source) &&
         !draw_exposure(frame, &level->source, false))) {
        return false;
    }
    (swapped ? etch_smooth_draw_swapped : etch_smooth_draw)(&level->carry, &level->source, surface);
    return true;
}

static void filter(const struct etch_scene_passes *p, struct etch_carry *carry,
                   const struct etch_surface *source, const struct etch_surface *strip,
                   bool swapped)
{
    if (p->filter == ETCH_SCENE_AVERAGE) {
        (swapped ? etch_filter_average_swapped : etch_filter_average)(carry, source, strip);
    } else if (p->filter == ETCH_SCENE_SOBEL) {
        (swapped ? etch_filter_sobel_swapped : etch_filter_sobel)(carry, source, strip);
    } else {
        (swapped ? etch_filter_draw_swapped : etch_filter_draw)(carry, source, strip, &p->weights);
    }
}

static bool draw_filtered(struct etch_scene_frame *frame, struct etch_surface *surface,
                          bool swapped)
{
    struct etch_scene_level *level = &frame->passes->filtered;

    if (frame->passes->filter == ETCH_SCENE_NO_FILTER) {
        return draw_smoothed(frame, surface, swapped);
    }
    if (!level_open(level, frame->scene, surface, 1, 1) ||
        (etch_carry_begin(&level->carry, surface, &level->source) &&
         !draw_smoothed(frame, &level->source, false))) {
        return false;
    }
    filter(frame->passes, &level->carry, &level->source, surface, swapped);
    return true;
}

void etch_scene_swap(const struct etch_surface *surface)
{
    const struct etch_rect w = surface->window;

    for (int16_t y = w.y0; y < w.y1; y++) {
        for (int16_t x = w.x0; x < w.x1; x++) {
            uint16_t *pixel = &surface->pixels[etch_surface_index(surface, x, y)];

            *pixel = etch_rgb565_swap(*pixel);
        }
    }
}

/* ---- from and to the scene
 * ------------------------------------------------------------------------ */

bool etch_scene_passes_draw(const struct etch_scene *scene, struct etch_surface *surface,
                            struct etch_scene_stats *stats)
{
    struct etch_scene native = *scene;
    struct etch_scene_frame frame = {&native, scene->passes, stats, 0};
    const size_t rows = (size_t)(surface->window.y1 - surface->window.y0);
    struct etch_surface plain = *surface;
    bool ok;

    native.passes = NULL;
    native.format = ETCH_FORMAT_RGB565;
    ok = draw_filtered(&frame, surface, scene->format == ETCH_FORMAT_RGB565_SWAPPED);
    if (!ok || (surface->depth == NULL && surface->stencil == NULL)) {
        return ok;
    }
    /* what --depth and --stencil show: the planes of the pixels, drawn once more without passes */
    plain.pixels = calloc(rows * plain.stride, sizeof *plain.pixels);
    ok = plain.pixels != NULL && etch_scene_draw(&native, &plain, NULL);
    free(plain.pixels);
    return ok;
}

static void level_free(struct etch_scene_level *level)
{
    free(level->memory);
    free(level->kept);
}

void etch_scene_passes_free(struct etch_scene_passes *passes)
{
    if (passes != NULL) {
        level_free(&passes->fxaa);
        level_free(&passes->filtered);
    }
}
