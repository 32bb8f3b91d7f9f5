/* frame/multisample_rows.h: the pixel loop of the painters of samples; no part of the API.
 *
 * As in fragment/template.h shader, depth test and kind of samples are constants of an inlined
 * function. `shared`: which two of the four samples a cell has depends on its column, and they go
 * to two surfaces (shared.h); else all four, to four. */
#ifndef ETCH_FRAME_MULTISAMPLE_ROWS_H
#define ETCH_FRAME_MULTISAMPLE_ROWS_H

#include "../fragment/gouraud_shader.h"
#include "multisample_setup.h"

/* A triangle while it is painted. */
struct sample_work {
    const struct etch_surface *surface; /* of the samples, 4 or 2 */
    const struct etch_gouraud_paint *paint;
    uint16_t color; /* of all fragments, where it is flat */
};

/* Bit k: sample k of column x. */
ETCH_INLINE uint8_t sample_all(int16_t x, const bool shared)
{
    return !shared ? 15 : (x & 1) != 0 ? 12 : 3;
}

ETCH_INLINE uint8_t sample_covered(const struct etch_run *const run[ETCH_SAMPLES], int16_t x)
{
    uint8_t mask = 0;

    for (uint8_t k = 0; k < ETCH_SAMPLES; k++)
        if (x >= run[k]->x0 && x < run[k]->x1)
            mask = (uint8_t)(mask | 1 << k);
    return mask;
}

/* The samples of the mask whose depth passes; their stored depths are replaced. */
ETCH_INLINE uint8_t sample_test(const struct sample_work *w, int16_t x, int16_t y, size_t at,
                                uint8_t mask, etch_depth_test *passes, const bool shared)
{
    for (uint8_t k = 0; k < ETCH_SAMPLES; k++) {
        if ((mask >> k & 1) == 0)
            continue;
        uint16_t *stored = w->surface[shared ? k & 1 : k].depth + at;
        const uint16_t depth = (uint16_t)(etch_plane_at(&w->paint[k].z, x, y) >> 16);

        if (passes(depth, *stored))
            *stored = depth;
        else
            mask = (uint8_t)(mask & ~(1 << k));
    }
    return mask;
}

/* At the centre if all samples are covered, else at the first that is. */
ETCH_INLINE uint16_t sample_shade(const struct sample_work *w, int16_t x, int16_t y,
                                  uint8_t covered, const bool smooth, const bool shared)
{
    struct etch_fragment f = {{0, 0, 0, 0}, x, y};
    uint8_t k = SAMPLE_CENTRE;

    if (!smooth)
        return w->color;
    if (covered == sample_all(x, shared))
        k = (uint8_t)(k + (shared ? x & 1 : 0));
    else
        for (k = 0; (covered >> k & 1) == 0;)
            k++;
    etch_gouraud_start(&f, &w->paint[k].paint);
    return etch_gouraud_color(&f, &w->paint[k].paint);
}

/* The fragment of one pixel or cell; `at` is its index in every plane. */
ETCH_INLINE void sample_fragment(const struct sample_work *w, int16_t x, int16_t y, size_t at,
                                 uint8_t covered, const bool smooth, etch_depth_test *passes,
                                 const bool shared)
{
    uint8_t mask = covered;

    if (passes != NULL)
        mask = sample_test(w, x, y, at, mask, passes, shared);
    if (mask == 0)
        return;
    const uint16_t color = sample_shade(w, x, y, covered, smooth, shared);

    for (uint8_t k = 0; k < ETCH_SAMPLES; k++)
        if ((mask >> k & 1) != 0)
            w->surface[shared ? k & 1 : k].pixels[at] = color;
}

/* Pixels x .. x1 - 1, of which all four samples are covered: colour and depths step. */
ETCH_INLINE void sample_inner(const struct sample_work *w, int16_t x, int16_t x1, int16_t y,
                              size_t at, const bool smooth, etch_depth_test *passes)
{
    const struct etch_paint *const centre = &w->paint[SAMPLE_CENTRE].paint;
    struct etch_fragment f = {{w->color, 0, 0, 0}, x, y};
    uint32_t z[ETCH_SAMPLES] = {0, 0, 0, 0};

    if (smooth)
        etch_gouraud_start(&f, centre);
    for (uint8_t k = 0; passes != NULL && k < ETCH_SAMPLES; k++)
        z[k] = etch_plane_at(&w->paint[k].z, x, y);
    for (; x < x1; x++, at++) {
        const uint16_t color = smooth ? etch_gouraud_color(&f, centre) : w->color;

        ETCH_UNROLL(4)
        for (uint8_t k = 0; k < ETCH_SAMPLES; k++) {
            const struct etch_surface *s = &w->surface[k];

            if (passes == NULL || passes((uint16_t)(z[k] >> 16), s->depth[at])) {
                s->pixels[at] = color;
                if (passes != NULL)
                    s->depth[at] = (uint16_t)(z[k] >> 16);
            }
            if (passes != NULL)
                z[k] = etch_wrap_add(z[k], w->paint[k].z.dx);
        }
        if (smooth)
            etch_gouraud_step(&f, centre);
    }
}

/* Pixels x .. x1 - 1, whatever is covered of them. */
ETCH_INLINE void sample_border(const struct sample_work *w, const struct etch_run *const run[],
                               int16_t x, int16_t x1, int16_t y, size_t at, const bool smooth,
                               etch_depth_test *passes, const bool shared)
{
    for (; x < x1; x++, at++) {
        const uint8_t covered = (uint8_t)(sample_covered(run, x) & sample_all(x, shared));

        if (covered != 0)
            sample_fragment(w, x, y, at, covered, smooth, passes, shared);
    }
}

/* One row, from the first covered sample to the last, with the part between that is all covered. */
ETCH_INLINE void sample_row(const struct sample_work *w, const struct etch_run *const run[],
                            int16_t y, const bool smooth, etch_depth_test *passes,
                            const bool shared)
{
    int16_t x0 = INT16_MAX, x1 = INT16_MIN, in0 = INT16_MIN, in1 = INT16_MAX;

    for (uint8_t k = 0; k < ETCH_SAMPLES; k++) {
        in0 = run[k]->x0 > in0 ? run[k]->x0 : in0;
        in1 = run[k]->x1 < in1 ? run[k]->x1 : in1;
        if (run[k]->x0 == run[k]->x1)
            continue;
        x0 = run[k]->x0 < x0 ? run[k]->x0 : x0;
        x1 = run[k]->x1 > x1 ? run[k]->x1 : x1;
    }
    if (x0 >= x1)
        return;
    const size_t at = etch_surface_index(w->surface, x0, y);

    if (shared || in0 >= in1) {
        sample_border(w, run, x0, x1, y, at, smooth, passes, shared);
        return;
    }
    sample_border(w, run, x0, in0, y, at, smooth, passes, shared);
    sample_inner(w, in0, in1, y, at + (size_t)(in0 - x0), smooth, passes);
    sample_border(w, run, in1, x1, y, at + (size_t)(in1 - x0), smooth, passes, shared);
}

/* A whole triangle. `passes` NULL: no depth plane is read or written. */
ETCH_INLINE void sample_paint(const struct etch_surface *surface,
                              const struct etch_vertex *const v[3],
                              const struct etch_offset_q8 *offset, const bool smooth,
                              etch_depth_test *passes, const bool shared)
{
    const uint8_t points = shared ? 6 : 5;
    struct etch_gouraud_paint paint[SAMPLE_POINTS];
    const struct sample_work w = {surface, paint, etch_rgb565(v[0]->r, v[0]->g, v[0]->b)};
    struct sample_shape shape;
    struct sample_band band;

    ETCH_ASSERT(passes == NULL || surface->depth != NULL);
    if (!etch_sample_setup(&shape, &surface->clip, v, offset, smooth ? points : ETCH_SAMPLES))
        return;
    if (passes != NULL)
        etch_sample_depth(&shape, v, paint);
    if (smooth)
        etch_sample_color(&shape, v, paint);
    for (int16_t y = shape.y0; y < shape.y1;) {
        const uint8_t n = (uint8_t)(shape.y1 - y < SAMPLE_ROWS ? shape.y1 - y : SAMPLE_ROWS);

        etch_sample_walk(&shape, surface, y, n, &band);
        for (uint8_t i = 0; i < n; i++, y++) {
            const struct etch_run *const run[ETCH_SAMPLES] = {&band.run[0][i], &band.run[1][i],
                                                              &band.run[2][i], &band.run[3][i]};

            sample_row(&w, run, y, smooth, passes, shared);
        }
    }
}

/* The points of four samples and the centre; of two times two samples and halfway between: those
 * of jitter.h and shared.h, as constants. */
static const struct etch_offset_q8 sample_grid[5] = {
    {-96, -32}, {-32, 96}, {32, -96}, {96, 32}, {0, 0}};
static const struct etch_offset_q8 sample_pairs[6] = {{-192, -96}, {-64, 32},   {-192, 96},
                                                      {-64, -32},  {-128, -32}, {-128, 32}};

#endif
