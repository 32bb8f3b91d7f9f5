/* frame/multisample_setup.h: one triangle as several samples see it; no part of the API.
 *
 * A sample beside the centre is the centre of a triangle moved the other way. So coverage by sample
 * is the edge walk of moved triangles, and a value at the sample a plane of them: no rule and no
 * bound is new. */
#ifndef ETCH_FRAME_MULTISAMPLE_SETUP_H
#define ETCH_FRAME_MULTISAMPLE_SETUP_H

#include "../fragment/gouraud.h"
#include "../raster/triangle.h"
#include "multisample.h"

/* The points where a triangle is looked at: four samples, then the places of the colour of whole
 * fragments, one or, for shared samples, two. */
#define SAMPLE_POINTS 6
#define SAMPLE_CENTRE 4

/* Rows that are walked at once: 4 * 16 runs, 256 bytes of stack. */
#define SAMPLE_ROWS 16

struct sample_shape {
    struct etch_triangle at[SAMPLE_POINTS];
    uint8_t points;
    int16_t y0, y1; /* rows inside the clip where a sample may be covered */
};

/* The runs of SAMPLE_ROWS rows, by sample. */
struct sample_band {
    struct etch_run run[ETCH_SAMPLES][SAMPLE_ROWS];
};

/* False if no sample can be visible. */
bool etch_sample_setup(struct sample_shape *shape, const struct etch_rect *clip,
                       const struct etch_vertex *const v[3], const struct etch_offset_q8 *offset,
                       uint8_t points);

/* Fills in the runs of rows y .. y + n - 1, n <= SAMPLE_ROWS; an empty one is {0, 0}. */
void etch_sample_walk(const struct sample_shape *shape, const struct etch_surface *surface,
                      int16_t y, uint8_t n, struct sample_band *band);

/* The planes of the shape's points: depth at the samples, colour at all. */
void etch_sample_depth(const struct sample_shape *shape, const struct etch_vertex *const v[3],
                       struct etch_gouraud_paint *paint);
void etch_sample_color(const struct sample_shape *shape, const struct etch_vertex *const v[3],
                       struct etch_gouraud_paint *paint);

#endif
