/* fragment/write.h: stages between a chunk and the colour plane (stage.h). Those called .._swapped
 * are for surfaces in rgb565_swapped; between read and write a chunk's colours have no byte order.
 */
#ifndef ETCH_FRAGMENT_WRITE_H
#define ETCH_FRAGMENT_WRITE_H

#include "stage.h"

/* The pixels as they are stored, for blending, logic operations and colour masks; no data. Reads
 * all n. */
etch_stage_function etch_stage_read;
etch_stage_function etch_stage_read_swapped;

/* Colours to the nearest step of RGB565, ties upwards, and into the plane where a pixel is alive;
 * no data. */
etch_stage_function etch_stage_write;
etch_stage_function etch_stage_write_swapped;

/* Which bits of a pixel may change: those of the mask become the fragment's, rounded, the others
 * stay as they were read. Data: const struct etch_color_mask. Last before write. */
struct etch_color_mask {
    uint16_t bits; /* as etch_rgb565: 0xF800 red, 0x07E0 green, 0x001F blue */
};
etch_stage_function etch_stage_color_mask;

/* The chunk's colour as a pixel, rounded; and back, to whole steps. */
ETCH_INLINE uint16_t etch_chunk_pixel(const struct etch_chunk *c, uint16_t i)
{
    const uint32_t r = (c->r[i] + UINT32_C(0x400)) >> 11, b = (c->b[i] + UINT32_C(0x400)) >> 11;
    const uint32_t g = (c->g[i] + UINT32_C(0x200)) >> 10;

    return (uint16_t)(r << 11 | g << 5 | b);
}

ETCH_INLINE void etch_chunk_set_pixel(struct etch_chunk *c, uint16_t i, uint16_t pixel)
{
    const uint32_t p = pixel;

    c->r[i] = (uint16_t)(p & 0xF800);
    c->g[i] = (uint16_t)((p & 0x07E0) << 5);
    c->b[i] = (uint16_t)((p & 0x001F) << 11);
}

#endif
