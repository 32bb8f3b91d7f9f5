/* ports/host/scene_pipeline.h: from drawing state to the painter and kernel that do it. */
#ifndef ETCH_HOST_SCENE_PIPELINE_H
#define ETCH_HOST_SCENE_PIPELINE_H

#include "../../core/draw/texture.h"
#include "../../core/draw/triangle.h"

/* The state of a scene; members count the words of their statement (see scene_state.c), so 0
 * is always the first; scene.c has the values that are not 0 at the start. */
struct etch_scene_state {
    uint8_t shade; /* smooth flat */
    uint8_t persp; /* 0 1 */
    uint8_t ztest; /* off never less equal lequal greater notequal gequal always */
    uint8_t zwrite;
    uint8_t blend; /* off alpha add mul addalpha constant */
    uint8_t blend_alpha;
    uint8_t cull;    /* off back front */
    uint8_t front;   /* ccw cw */
    uint8_t stencil; /* off, or a function, then .. */
    uint8_t stencil_reference, stencil_mask, stencil_operation[3];
    uint8_t stencil_write; /* mask; 255 at the start */
    uint8_t tex;           /* off replace modulate decal */
    uint8_t filter;        /* nearest linear */
    uint8_t wrap;          /* repeat clamp mirror */
    uint8_t wrap_v;        /* same, or 1 + as wrap */
    uint8_t mipmap;        /* off on */
    uint8_t atest;         /* off on */
    uint8_t atest_reference;
    uint8_t mode;   /* precise fast exact fast8 */
    uint8_t dither; /* off on */
    uint8_t depth;  /* linear inverse */
    uint8_t fog;    /* off linear exp */
    uint8_t fog_color[3];
    uint8_t logic; /* off clear and .. */
    uint16_t fog_start, fog_end;
    uint16_t color_mask; /* bits that may change; 0xFFFF at the start */
    int32_t fog_density; /* 16.16 */
};

struct etch_scene_staged;

/* What draws a state, [1] in rgb565_swapped: a row of the table of fused kernels, or stages. */
struct etch_scene_pipeline {
    uint8_t shade, ztest, zwrite;
    etch_triangle_painter *painter[2];
    etch_kernel *kernel[2];
    const char *name[2];         /* of the kernels */
    const char *painter_name[2]; /* of the painters */

    struct etch_scene_staged *staged; /* instead of all of the others; else NULL */

    /* With a texture, instead of painter and kernel. */
    const struct etch_perspective_kernels *texture; /* else NULL */
    bool perspective;                               /* else its affine kernel is used */
};

/* The row that draws with this state, NULL if no fused kernel does. */
const struct etch_scene_pipeline *etch_scene_pipeline_find(const struct etch_scene_state *state);

/* Whether the state asks for what only stages do. */
bool etch_scene_pipeline_needs_stages(const struct etch_scene_state *state);

/* Whether the state asks for exact values, dithering or inverse depth, and the row for that, NULL
 * if there is none: they have no textures, no stages, and of the depth tests off, less and lequal
 * that write. */
bool etch_scene_mode_is_special(const struct etch_scene_state *state);
const struct etch_scene_pipeline *
etch_scene_pipeline_find_mode(const struct etch_scene_state *state);

/* The same for triangles alone, blended by alpha without depth. */
const struct etch_scene_pipeline *
etch_scene_pipeline_find_blend(const struct etch_scene_state *state);

/* The same for states with `tex` on. */
const struct etch_scene_pipeline *
etch_scene_pipeline_find_texture(const struct etch_scene_state *state);

#endif
