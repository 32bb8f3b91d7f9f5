/* fragment/source.h: stages that set the values of a chunk (stage.h) from a triangle's planes.
 *
 *      stage                              sets         set-up (draw/staged.h)
 *      etch_source_flat                   r g b a      etch_varying_flat
 *      etch_source_color                  r g b        etch_varying_color
 *      etch_source_alpha                  a            etch_varying_alpha
 *      etch_source_color_perspective      r g b a      etch_varying_color_perspective
 *      etch_source_depth                  z            etch_varying_depth
 *      etch_source_texture                u v          etch_varying_texture
 *      etch_source_texture_perspective    u v          etch_varying_texture_perspective
 *
 * None reads its data. Each sets its values for all pixels of the chunk, and holds them to their
 * range, whatever the planes do.
 */
#ifndef ETCH_FRAGMENT_SOURCE_H
#define ETCH_FRAGMENT_SOURCE_H

#include "../base/texture.h"
#include "../base/weights.h"
#include "stage.h"

/* Colours in perspective: those of sorted vertex 0 and the differences of the others to it. Red and
 * blue 5.23, green 6.22, alpha 8.20, in that order r g b a; differences in eighths. */
struct etch_perspective_colors {
    struct etch_weights weights;
    int32_t base[4], one_q3[4], two_q3[4];
};

/* Texture coordinates linear on the screen: 16.16 in (value - first) / 2^up + first, modulo 2^32
 * before the division; see source_texture.c. */
struct etch_linear_coordinate {
    struct etch_plane plane;
    int32_t least; /* of the vertices, 16.16 */
    uint8_t up;    /* bits more than 16.16 */
};

/* What shipped sources read. Those of a program that needs more are a struct that begins so. */
struct etch_staged_planes {
    struct etch_staged_paint staged;
    struct etch_plane z; /* 16.16 + 1/2 */
    union {
        uint16_t flat[4]; /* r g b a in the formats of a chunk */
        struct {
            struct etch_plane r, g, b; /* 5.27, 6.26, 5.27, each + 1/2 */
            struct etch_plane a;       /* 8.23 + 1/128 */
        } linear;
        struct etch_perspective_colors perspective;
    } color;
    union {
        struct etch_linear_coordinate linear[2];
        struct etch_perspective_planes perspective;
    } texture;
};

/* The colour and alpha of one vertex. */
etch_stage_function etch_source_flat;

/* Colours linear on the screen, those of the Gouraud kernels bit for bit once they are written. */
etch_stage_function etch_source_color;

/* Alpha linear on the screen, within 1/512 + 1/512 of the exact value: rounded to nearest, so that
 * a value that can be represented is not missed by what the plane errs by. */
etch_stage_function etch_source_alpha;

/* Colours and alpha linear in space: c/w and 1/w are linear on the screen. A divide every pixel.
 * For every triangle and every w, colours are within 2^-11 step of the exact rational before they
 * are rounded, alpha within 1/512 + 2^-16. */
etch_stage_function etch_source_color_perspective;

/* Depth, linear on the screen, that of the kernels with depth. */
etch_stage_function etch_source_depth;

/* Texture coordinates linear on the screen. */
etch_stage_function etch_source_texture;

/* In perspective, those of etch_kernel_perspective_exact bit for bit. */
etch_stage_function etch_source_texture_perspective;

#endif
