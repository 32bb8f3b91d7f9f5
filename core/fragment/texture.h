/* fragment/texture.h: the nearest texel, repeated.
 *
 *      coordinates     without depth                 with, LESS and LEQUAL
 *      affine          etch_kernel_texture           .._texture_less, .._texture_lequal
 *      a divide every  etch_kernel_perspective       .._perspective_less, .._perspective_lequal
 *      16 pixels
 *      a divide every  etch_kernel_perspective_      .._perspective_exact_less,
 *      pixel           exact                         .._perspective_exact_lequal
 *
 * Texels are in the surface's byte order, so that there is one kernel for both. No kernel reads
 * outside the texture, whatever its planes are.
 */
#ifndef ETCH_FRAGMENT_TEXTURE_H
#define ETCH_FRAGMENT_TEXTURE_H

#include "../base/texture.h"

struct etch_texture_paint {
    struct etch_paint paint; /* .kernel = an affine one */
    struct etch_plane z;     /* 16.16 + 1/2; read by the depth kernels only */
    struct etch_plane u, v;  /* in the formats of the map */
    struct etch_texel_map map;
};

etch_kernel etch_kernel_texture;
etch_kernel etch_kernel_texture_less;
etch_kernel etch_kernel_texture_lequal;

struct etch_perspective_paint {
    struct etch_paint paint; /* .kernel = one of those below */
    struct etch_plane z;
    struct etch_perspective_planes coordinates;
    struct etch_texel_map map;
    uint8_t width_bits;
};

/* Coordinates right where x is a multiple of 16 of the frame, linear between: strips and clips
 * change nothing. For triangles whose set-up says so (raster/texture_plane.h).
 *
 * From the exact coordinate the line errs by at most D (q - 1) / 4, beside what its ends err: D is
 * what the coordinate changes by in the block and q >= 1 the ratio of 1/w at its ends. For with t
 * from 0 to 1 the exact one is from + D t q / (1 + t (q - 1)), which differs from from + D t by
 * D t (1 - t) (q - 1) / (1 + t (q - 1)), D (sqrt(q) - 1) / (sqrt(q) + 1) where it is greatest. So
 * by less than D / 4, since q <= 2 where set-up allows blocks; by 1/80 of D where 1/w changes by a
 * twentieth. */
etch_kernel etch_kernel_perspective;
etch_kernel etch_kernel_perspective_less;
etch_kernel etch_kernel_perspective_lequal;

/* Coordinates right at every pixel, and between those of the vertices. */
etch_kernel etch_kernel_perspective_exact;
etch_kernel etch_kernel_perspective_exact_less;
etch_kernel etch_kernel_perspective_exact_lequal;

#endif
