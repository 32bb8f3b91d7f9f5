/* base/texture.h: textures, textured vertices, and what the raster stage works out of them.
 *
 * A texture is RGB565 in the byte order of the surface that it is drawn on (swap it once, not per
 * pixel). Texel (i, j) covers [i, i+1) x [j, j+1); coordinates
 * repeat. Sides are powers of two, so that repeating is a mask and a row a shift.
 */
#ifndef ETCH_BASE_TEXTURE_H
#define ETCH_BASE_TEXTURE_H

#include "paint.h"
#include "sink.h"

struct etch_texture {
    const uint16_t *texels; /* the caller's, row 0 first, rows without a gap */
    uint8_t width_bits;     /* width is 1 << width_bits, 0 .. 12 */
    uint8_t height_bits;    /* height likewise; width_bits + height_bits <= 16 */
};

/* Describes width x height texels, which must stay valid while the texture is used.
 * ETCH_EINVAL if texels is NULL, a side is not a power of two, the width is above 4096, or there
 * are more than 65536 texels; *t is then left as it was. */
enum etch_status etch_texture_init(struct etch_texture *t, const uint16_t *texels, uint16_t width,
                                   uint16_t height);

/* A vertex with texture coordinates. */
struct etch_texture_vertex {
    struct etch_vertex at; /* first, so that it is a vertex for everything else */
    etch_q16 u, v;         /* texels; every value is legal */
    uint32_t w;            /* > 0, distance from the eye in any unit: only ratios count. Read by
                              perspective painters only; 0 counts as 1 */
};

/* ---- images of any size and format, which samplers read (fragment/sampler.h) --------------- */

struct etch_image;

/* Fetches n texels, 1 <= n <= 16: texel i is in column[i] and row[i] of the image, both inside. A
 * format is one such function for its colours, RGB565, and one for its alpha, 0 .. 255. */
typedef void etch_texel_colors(uint16_t *color, const uint16_t *column, const uint16_t *row,
                               uint16_t n, const struct etch_image *image);
typedef void etch_texel_alphas(uint8_t *alpha, const uint16_t *column, const uint16_t *row,
                               uint16_t n, const struct etch_image *image);

/* An image. All memory is the caller's and must stay while the image is used. Colours are
 * etch_rgb565's, whatever the byte order of the surface: they are unpacked, not copied. */
struct etch_image {
    etch_texel_colors *colors; /* the format, as fragment/sampler.h lists them */
    etch_texel_alphas *alphas; /* where alpha comes from; NULL: the image is opaque */
    const void *texels;        /* what `colors` reads, row 0 first */
    const uint16_t *palette;   /* the colours of a palette format */
    const uint8_t *alpha;      /* what `alphas` reads */
    uint16_t width, height;    /* texels, 1 .. 32767 each */
    uint16_t stride;           /* texels from one row to the next, in every plane; >= width */
};

/* False if `colors` or `texels` is NULL, or `alpha` where there are `alphas`, or a side is not
 * 1 .. 32767, or the stride is less than the width. */
bool etch_image_valid(const struct etch_image *image);

/* ---- what raster/texture_plane.h sets up and fragment/texture.h reads -------------------- */

/* Where the texels are: the byte offset of a texel is
 *      (u_q20 >> 19 & columns) + (v >> 15 & rows)
 * with u in 12.20 and v in texels 2^(16 + width_bits), both modulo 2^32. */
struct etch_texel_map {
    const uint16_t *texels;
    uint32_t columns, rows; /* masks of byte offsets */
};

/* One coordinate in perspective: 16.16 texels = middle + numerator / denominator 2^exponent. */
struct etch_perspective_axis {
    struct etch_plane numerator; /* two's complement, |.| <= 2^29 in the triangle */
    uint32_t middle;             /* half way between the least and the greatest vertex */
    int32_t least, most;         /* of the vertices, against middle, 16.16 */
    int32_t least_q12, most_q12; /* the same in 1/4096 texel, rounded inwards;
                                    read where a block of 16 is one line */
    int8_t exponent;             /* -31 .. -1; see raster/texture_perspective.c */
};

struct etch_perspective_planes {
    struct etch_perspective_axis u, v;
    struct etch_plane denominator; /* 1/w, the greatest vertex 2^29 .. 2^30 */
    int32_t least;                 /* what the denominator is never below */
    bool blocks;                   /* coordinates may be linear between every 16th pixel */
};

/* v 2^s modulo 2^32; s = 0 .. 31. */
ETCH_INLINE uint32_t etch_wrap_up(uint32_t v, uint8_t s)
{
    return v << s;
}

/* 2^62 / d for d = 2^31 .. 2^32 - 1, h its upper half, without a division: from the best straight
 * line, 1/17 off, three Newton steps q += q (1 - q h / 2^32), the last with all of d. Each squares
 * the relative error: 2^-4, 2^-8, 2^-15.6, and 2^-27.9 with what the shifts drop. */
ETCH_INLINE int32_t etch_reciprocal_q62(uint32_t d)
{
    const uint32_t h = d >> 16, l = d & 0xFFFF;
    /* 48/17 - 32/17 h, below 2^17.5; 30840 were nearer, but gcc makes three shifts of it */
    int32_t q = 185043 - (int32_t)(h * 30843 >> 14);
    int32_t e = (int32_t)etch_wrap_sub(0, etch_wrap_mul(h, (uint32_t)q));

    q += q * (e >> 15) >> 17; /* |e| < 2^28 */
    e = (int32_t)etch_wrap_sub(0, etch_wrap_mul(h, (uint32_t)q));
    q += q * (e >> 11) >> 21; /* |e| < 2^24 */
    e = (int32_t)etch_wrap_sub(0, etch_wrap_mul(h, (uint32_t)q));
    e -= (int32_t)((l >> 1) * (uint32_t)q >> 15); /* (2^48 - d q) / 2^16, |e| < 2^17 */
    return q * 16384 + (e * (q >> 3) >> 15);
}

#endif
