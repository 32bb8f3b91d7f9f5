/* frame/accumulation.h: the accumulation plane, weighted sums of frames that are divided once.
 *
 *      for every strip:
 *          for (i = 0; i < 16; i++) {
 *              .. draw the scene on the strip's surface, moved, in rgb565 ..
 *              i == 0 ? etch_accumulation_load(&a, s, 1) : etch_accumulation_add(&a, s, 1);
 *          }
 *          etch_accumulation_return(&a, s, 16);
 *
 * Moved by the offsets of jitter.h it is anti-aliasing; with what moves at 16 moments of the
 * exposure, motion blur; with a light at 16 places of its area, soft shadows; by the eye about a
 * point, depth of field.
 *
 * A sum counts output steps of its channel in 16 bits and saturates at 65535. While the weights sum
 * to 1040 or less nothing saturates (63 * 1040 = 65520), and what returns is the exact weighted
 * average, rounded once, half up. Memory: 6 bytes a pixel, of a strip if the frame is drawn in
 * strips. Everything works on the pixels that the surface's clip and the plane's window share; sums
 * and pixels do not depend on where strips begin.
 */
#ifndef ETCH_FRAME_ACCUMULATION_H
#define ETCH_FRAME_ACCUMULATION_H

#include "../base/surface.h"

struct etch_accumulation {
    uint16_t *sums;          /* red, green, blue of each pixel; the caller's, 3 stride a row */
    uint16_t stride;         /* pixels from one row to the next */
    struct etch_rect window; /* rectangle of the frame that the plane holds */
};

/* Makes a plane over the caller's `sums`, which hold `window`, 3 elements a pixel, rows `stride`
 * pixels apart. The sums are whatever they were: load first. For the next strip call it again.
 * ETCH_EINVAL if sums is NULL, the window is empty or not within 0 .. 32767, or the stride is less
 * than its width; *a is then left as it was. */
enum etch_status etch_accumulation_init(struct etch_accumulation *a, uint16_t *sums,
                                        struct etch_rect window, uint16_t stride);

/* sum = weight * pixel, for a surface in rgb565. Costs 26 instructions a pixel on x86-64, where
 * all figures of this folder are from; add 32. */
void etch_accumulation_load(const struct etch_accumulation *a, const struct etch_surface *s,
                            uint16_t weight);

/* sum += weight * pixel. */
void etch_accumulation_add(const struct etch_accumulation *a, const struct etch_surface *s,
                           uint16_t weight);

/* sum = sum * numerator / denominator, rounded half up, inside `area`: old frames fade so. Nothing
 * happens if the denominator is 0. Three 32-bit divisions a pixel. */
void etch_accumulation_multiply(const struct etch_accumulation *a, struct etch_rect area,
                                uint16_t numerator, uint16_t denominator);

/* pixel = sum / divisor, rounded half up, at most 31 or 63. The divisor is usually the sum of the
 * weights; 0 returns nothing. 27 instructions a pixel, no division. */
void etch_accumulation_return(const struct etch_accumulation *a, const struct etch_surface *s,
                              uint16_t divisor);

/* The same to a surface in rgb565_swapped. */
void etch_accumulation_return_swapped(const struct etch_accumulation *a,
                                      const struct etch_surface *s, uint16_t divisor);

#endif
