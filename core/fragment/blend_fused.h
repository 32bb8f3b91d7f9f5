/* fragment/blend_fused.h: blending by alpha in one loop, without tests: glass and fades. The pixels
 * are those of the stages (blend.h) bit for bit.
 *
 *      kernel                        painter (draw/blend.h)
 *      etch_kernel_flat_blend        etch_triangle_flat_blend
 *      etch_kernel_gouraud_blend     etch_triangle_gouraud_blend
 *      etch_kernel_gouraud_fade      etch_triangle_gouraud_fade
 *
 * On ARMv6-M they take 31, 120 and 110 instructions a pixel, counted in the loops that gcc 12 makes
 * at -O2: a blended channel has two products and a division by 255 that is a third. Those called
 * .._swapped are for surfaces in rgb565_swapped.
 */
#ifndef ETCH_FRAGMENT_BLEND_FUSED_H
#define ETCH_FRAGMENT_BLEND_FUSED_H

#include "gouraud.h"

/* One colour and one alpha: a channel becomes (least + d keep) / 255. */
struct etch_flat_blend_paint {
    struct etch_paint paint;
    uint32_t red_blue; /* least + 1 of red, and of blue 2^16 */
    uint16_t green;    /* least + 1 */
    uint8_t keep;      /* 255 - alpha */
};
etch_kernel etch_kernel_flat_blend;
etch_kernel etch_kernel_flat_blend_swapped;

/* For any shape's runs: a channel becomes (s a + d (255 - a)) / 255, rounded to nearest (there are
 * no ties), s of `color` (etch_rgb565, for both byte orders) and a the opacity: 255 makes it s, 0
 * leaves it as it was. kernel: one of the two above. */
void etch_flat_blend_init(struct etch_flat_blend_paint *p, etch_kernel *kernel, uint16_t color,
                          uint8_t opacity);

/* Colours linear on the screen, and alpha: a plane (blend), or one for all (fade). */
struct etch_gouraud_blend_paint {
    struct etch_gouraud_paint gouraud; /* .z is not read */
    struct etch_plane a;               /* 8.23 + 1/128; read by blend */
    uint16_t alpha;                    /* 8.8; read by fade */
};
etch_kernel etch_kernel_gouraud_blend;
etch_kernel etch_kernel_gouraud_blend_swapped;
etch_kernel etch_kernel_gouraud_fade;
etch_kernel etch_kernel_gouraud_fade_swapped;

#endif
