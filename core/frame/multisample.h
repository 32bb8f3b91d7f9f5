/* frame/multisample.h: four samples a pixel for coverage and depth, colour once a fragment.
 *
 *      struct etch_multisample m;                                   +-----------+
 *      for every strip:                                             |      2    |
 *          etch_multisample_init(&m, colours, depths, strip->window);  |  0        |
 *          .. etch_surface_clear(&m.sample[i], ..) for each i ..    |           |
 *          .. etch_multisample_gouraud_less(&m, v) ..               |        3  |
 *          etch_multisample_resolve(&m, strip);                     |    1      |
 *                                                                   +-----------+
 *
 * The samples are etch_jitter_4: the rotated grid. Sample i of all pixels is a surface of its own,
 * sample[i], so whatever draws on surfaces can be drawn on all four: 2D shapes as they are, and
 * triangles of other painters with their vertices moved by etch_vertex_jitter and
 * etch_jitter_4[i], which supersamples them and meets multisampled neighbours without a gap.
 *
 * Coverage    sample i is covered iff it is inside the triangle, or on a top or left edge of it:
 *             the rule of raster/triangle.h at the sample instead of the centre. So a mesh covers
 *             each sample once, and no background shines through a shared edge.
 * Depth       per sample, interpolated there, with the bound of a pixel's depth.
 * Colour      once a fragment: at the centre of the pixel if all four samples are covered (then
 *             the centre is inside), else at the first sample that is. It is a point of the
 *             triangle, so no channel leaves the range of the vertices'. Bound as in
 *             draw/triangle.h.
 * Strips      as everywhere: samples do not depend on where strips begin.
 *
 * Memory: 4 pixels of colour (and depth) for one. Stack some 1.2 KB. Colour and depth planes are
 * set up at five points, so a small triangle costs some 4 times what it costs without; inside, a
 * pixel costs one colour, four stores and, if depth is tested, four tests: 13 instructions flat, 31
 * interpolated, 67 with depth.
 *
 * Everything is in rgb565; the resolve called _swapped writes rgb565_swapped.
 */
#ifndef ETCH_FRAME_MULTISAMPLE_H
#define ETCH_FRAME_MULTISAMPLE_H

#include "../base/sink.h"
#include "../base/surface.h"
#include "jitter.h"

#define ETCH_SAMPLES 4

struct etch_multisample {
    struct etch_surface sample[ETCH_SAMPLES]; /* alike but for their memory */
};

/* Makes four surfaces over the caller's memory: `pixels`, and `depth` unless it is NULL, hold
 * ETCH_SAMPLES times the pixels of `window`, without gaps. For the next strip call it again.
 * Returns what etch_surface_init does, and then *m is not to be used unless it is ETCH_OK. */
enum etch_status etch_multisample_init(struct etch_multisample *m, uint16_t *pixels,
                                       uint16_t *depth, struct etch_rect window);

/* Sets the clip of all four, as etch_surface_clip. */
void etch_multisample_clip(struct etch_multisample *m, struct etch_rect clip);

/* Paints one triangle; vertices as in draw/triangle.h. */
typedef void etch_multisample_painter(const struct etch_multisample *m,
                                      const struct etch_vertex *const v[3]);

/* In the colour of v[0]: without depth, and where the depth is less, or less or equal. */
etch_multisample_painter etch_multisample_flat;
etch_multisample_painter etch_multisample_flat_less;
etch_multisample_painter etch_multisample_flat_lequal;

/* Colours interpolated linearly on the screen. */
etch_multisample_painter etch_multisample_gouraud;
etch_multisample_painter etch_multisample_gouraud_less;
etch_multisample_painter etch_multisample_gouraud_lequal;

/* The sink for meshes. */
struct etch_multisample_sink {
    struct etch_sink sink; /* give &m.sink to etch_assembly */
    const struct etch_multisample *samples;
    etch_multisample_painter *painter;
};

void etch_multisample_sink_init(struct etch_multisample_sink *sink,
                                const struct etch_multisample *samples,
                                etch_multisample_painter *painter);

/* Each pixel inside out->clip and the samples' window becomes the average of its four samples,
 * exact and rounded once, half up. 32 instructions a pixel. */
void etch_multisample_resolve(const struct etch_multisample *m, const struct etch_surface *out);
void etch_multisample_resolve_swapped(const struct etch_multisample *m,
                                      const struct etch_surface *out);

#endif
