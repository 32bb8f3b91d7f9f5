/* fragment/texture_row.c: the loop over texels. Called by the affine kernels and by those with a
 * divide every 16 pixels, once for each run of pixels that pass. See texture_row.h. */
#include "texture_row.h"

/* Says which values belong in low registers of ARMv6-M; no instruction comes of it. Left alone, gcc
 * 12 puts a mask into a high one, copies it for every pixel, and adds twice the step to the first
 * value: 11.5 instructions a pixel in place of 10.5. */
#if defined(__GNUC__) && defined(__ARM_ARCH_6M__)
#define KEEP_LOW(u, v, columns, rows) __asm__("" : "+l"(u), "+l"(v) : "l"(columns), "l"(rows))
#else
#define KEEP_LOW(u, v, columns, rows) ((void)0)
#endif

#define TEXEL(i)                                                                                   \
    pixel[i] = *(const uint16_t *)((uintptr_t)(u >> 19 & columns) + texels +                       \
                                   (uintptr_t)(v >> 15 & rows));                                   \
    u = etch_wrap_add(u, du);                                                                      \
    v = etch_wrap_add(v, dv);                                                                      \
    KEEP_LOW(u, v, columns, rows)

/* Nine instructions a pixel on ARMv6-M and three for every two: the masks cost one each, but with
 * them every shift is by a constant, which needs no copy. */
void etch_texel_row(uint16_t *pixel, uint32_t n, const struct etch_texel_walk *walk,
                    const struct etch_texel_map *map)
{
    const uintptr_t texels = (uintptr_t)map->texels;
    const uint32_t columns = map->columns, rows = map->rows, du = walk->du, dv = walk->dv;
    const uint16_t *const end = pixel + n;
    uint32_t u = walk->u, v = walk->v;

    if ((n & 1) != 0) {
        TEXEL(0);
        pixel++;
    }
    while (pixel != end) {
        TEXEL(0);
        TEXEL(1);
        pixel += 2;
    }
}
