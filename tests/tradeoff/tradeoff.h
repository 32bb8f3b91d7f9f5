/* tradeoff/tradeoff.h: modes and scenes of the trade-off table.
 *
 * A mode is one way to draw a triangle: a function, what its error is measured in, and the memory
 * that it needs. A scene is a list of triangles. main.c draws every mode over every scene that it
 * is for, between the markers that the QEMU plugin counts by; error.c draws the same on the host,
 * triangle by triangle, and compares with exact rationals; tradeoff.py joins both. */
#ifndef TRADEOFF_TRADEOFF_H
#define TRADEOFF_TRADEOFF_H

#include "../../core/base/surface.h"
#include "../../core/base/texture.h"

#define TRADEOFF_W 320
#define TRADEOFF_H 240
#define TRADEOFF_TEXTURE 256 /* texel (u, v) is the number 256 v + u */

/* What an error is counted in. */
enum tradeoff_unit {
    TRADEOFF_COLOR,    /* steps of a channel, 31 or 63 to full scale */
    TRADEOFF_MEAN,     /* the same, of the mean of an aligned 8 x 8 block inside the triangle */
    TRADEOFF_DEPTH,    /* units of 16-bit depth */
    TRADEOFF_CODE,     /* steps of the floating depth's code */
    TRADEOFF_TEXEL,    /* texels from the centre of the one drawn, the larger of u and v */
    TRADEOFF_COVERAGE, /* share of a pixel */
    TRADEOFF_VERTEX,   /* pixels that a vertex is moved */
    TRADEOFF_VISIBLE   /* pixels that show another triangle than the nearest: 0 or 1 each */
};

enum tradeoff_scene_bit {
    NEAR = 1,    /* large triangles on the screen */
    FAR = 2,     /* vertices up to 32,000 px away */
    FLOOR = 4,   /* a floor to the horizon */
    SLIVERS = 8, /* 300 px long, 1/256 to 1 px thick */
    MESH = 16,   /* a torus of 2048 triangles as it is seen */
    RAMPS = 32,  /* colours that differ by one or two 8-bit steps */
    PLANES = 64  /* pairs of depths 16 units apart, 8, .. 1/256 */
};
#define TRADEOFF_SCENES 7

struct tradeoff_scene {
    const char *name;
    const struct etch_texture_vertex *v; /* three a triangle */
    uint16_t count;
};

typedef void tradeoff_draw(const struct etch_surface *s, const struct tradeoff_scene *scene);

struct tradeoff_mode {
    const char *name;
    const char *kernel; /* the functions that a program names */
    tradeoff_draw *draw;
    const char *program; /* the draw function's name: what flash.c is built with */
    uint8_t bytes;       /* of memory a pixel of a strip, colour included */
    uint8_t triangle;    /* and for each triangle of a frame */
    uint8_t unit;        /* enum tradeoff_unit */
    uint8_t scenes;      /* enum tradeoff_scene_bit */
};

extern const struct tradeoff_mode tradeoff_modes[];
extern const uint8_t tradeoff_mode_count;
extern struct tradeoff_scene tradeoff_scenes[TRADEOFF_SCENES]; /* scene i is bit i */
extern uint16_t tradeoff_texels[TRADEOFF_TEXTURE * TRADEOFF_TEXTURE];

/* Makes the scenes and the texture, the same on every machine. */
void tradeoff_prepare(void);

/* Pointers to the three vertices of triangle i. */
#define TRADEOFF_TRIANGLE(scene, i)                                                                \
    {                                                                                              \
        &(scene)->v[3 * (i)], &(scene)->v[3 * (i) + 1], &(scene)->v[3 * (i) + 2]                   \
    }

/* One function a mode, in modes_*.c. */
#define TRADEOFF_DRAWS(name) tradeoff_draw draw_##name
TRADEOFF_DRAWS(flat);
TRADEOFF_DRAWS(flat_dither);
TRADEOFF_DRAWS(precise);
TRADEOFF_DRAWS(exact);
TRADEOFF_DRAWS(small);
TRADEOFF_DRAWS(dither);
TRADEOFF_DRAWS(barycentric);
TRADEOFF_DRAWS(fast);
TRADEOFF_DRAWS(packed);
TRADEOFF_DRAWS(carried);
TRADEOFF_DRAWS(depth_precise);
TRADEOFF_DRAWS(depth_exact);
TRADEOFF_DRAWS(depth_inverse);
TRADEOFF_DRAWS(ordering);
TRADEOFF_DRAWS(painter);
TRADEOFF_DRAWS(buffer);
TRADEOFF_DRAWS(affine);
TRADEOFF_DRAWS(divide_16);
TRADEOFF_DRAWS(divide_8);
TRADEOFF_DRAWS(divide_1);
TRADEOFF_DRAWS(whole_pixel);
TRADEOFF_DRAWS(subpixel);
TRADEOFF_DRAWS(edges_plain);
TRADEOFF_DRAWS(edges_smooth);
TRADEOFF_DRAWS(multisample);
TRADEOFF_DRAWS(shared);
TRADEOFF_DRAWS(supersample_2);
TRADEOFF_DRAWS(supersample_3);
TRADEOFF_DRAWS(supersample_4);

#endif
