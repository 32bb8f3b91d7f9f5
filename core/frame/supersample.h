/* frame/supersample.h: n x n supersampling. What is drawn n times as large is averaged.
 *
 *      struct etch_surface large;
 *      for every strip:
 *          etch_surface_init(&large, memory, etch_supersample_window(strip->window, 2), 2 * width);
 *          .. draw the scene n times as large on it, in rgb565 ..
 *          etch_supersample_resolve_2(&large, strip);
 *
 * `n times as large`: a viewport (vertex/viewport.h) n times as large for what comes from clip
 * space, positions times n for one's own vertices. Everything that draws can be used: every sample
 * has its own colour, depth and texture coordinate. The large frame must lie within 32767 px.
 *
 * A resolve takes the pixels inside out->clip whose samples the large surface holds. Each is the
 * exact average of its n^2 samples, rounded once, half up. Memory: n^2 times a strip (and as much
 * again for its depth). Cost: 7 to 9 instructions a sample.
 */
#ifndef ETCH_FRAME_SUPERSAMPLE_H
#define ETCH_FRAME_SUPERSAMPLE_H

#include "../base/surface.h"

/* The pixels of the large frame that `r` becomes; r within 0 .. 32767 / n. */
ETCH_INLINE struct etch_rect etch_supersample_window(struct etch_rect r, uint8_t n)
{
    const struct etch_rect large = {(int16_t)(r.x0 * n), (int16_t)(r.y0 * n), (int16_t)(r.x1 * n),
                                    (int16_t)(r.y1 * n)};

    return large;
}

void etch_supersample_resolve_2(const struct etch_surface *large, const struct etch_surface *out);
void etch_supersample_resolve_3(const struct etch_surface *large, const struct etch_surface *out);
void etch_supersample_resolve_4(const struct etch_surface *large, const struct etch_surface *out);

/* The same to a surface in rgb565_swapped. */
void etch_supersample_resolve_2_swapped(const struct etch_surface *large,
                                        const struct etch_surface *out);
void etch_supersample_resolve_3_swapped(const struct etch_surface *large,
                                        const struct etch_surface *out);
void etch_supersample_resolve_4_swapped(const struct etch_surface *large,
                                        const struct etch_surface *out);

#endif
