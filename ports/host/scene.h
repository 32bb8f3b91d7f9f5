/* ports/host/scene.h: scene files, read and drawn.
 *
 * A scene is read whole, checked, and kept as a list of drawing steps; then it is drawn on any
 * surface, as often as the frame loop asks. The format is described in README.md here. */
#ifndef ETCH_HOST_SCENE_H
#define ETCH_HOST_SCENE_H

#include "../../hal/display.h"
#include "text.h"

struct etch_scene_step;
struct etch_scene_mesh;
struct etch_scene_texture;
struct etch_scene_passes;
struct etch_scene_facts;
struct etch_scene_modes;

struct etch_scene {
    int16_t width, height;
    int16_t strip;       /* rows, 0: the whole frame at once */
    uint8_t format;      /* enum etch_format */
    bool uses_depth;     /* something tests or writes depth */
    bool uses_stencil;   /* something tests stencil values */
    size_t count;        /* of steps */
    size_t vertex_bytes; /* RAM for the transformed vertices of its meshes */
    int32_t near, far;   /* 16.16, of the latest perspective; 0 without one */
    char **file;         /* what it reads beside itself: meshes, textures */
    size_t file_count;

    const struct etch_scene_modes *modes; /* the caller's, or NULL */

    /* Private. */
    struct etch_scene_step *step;
    size_t capacity, file_capacity;
    struct etch_scene_mesh **mesh;
    size_t mesh_count, mesh_capacity;
    void **data;
    size_t data_count, data_capacity;
    struct etch_scene_texture **texture;
    size_t texture_count, texture_capacity;
    struct etch_scene_passes *passes; /* over the whole frame, or NULL */
};

/* Reads and checks a scene. False, with the reason in *error, if anything is wrong; there is
 * nothing to close then. */
bool etch_scene_open(struct etch_scene *scene, const char *path, struct etch_error *error);

/* The same in a format (enum etch_format) that the display wants, whatever the scene says; -1: in
 * the scene's. */
bool etch_scene_open_in(struct etch_scene *scene, const char *path, int format,
                        struct etch_error *error);

/* Modes in place of those that the scene's triangles have; precise without any of these. */
struct etch_scene_modes {
    bool exact, dither, inverse; /* one at most; without textures */
    bool perspective;            /* of textures that have it: else affine */
    uint8_t texture;             /* state mode: 0 a divide a pixel, 1 every 16, 3 every 8 */
};

/* The same, the precise ones drawn in other modes where that can be. */
bool etch_scene_open_modes(struct etch_scene *scene, const char *path,
                           const struct etch_scene_modes *modes, struct etch_error *error);

/* Gives the memory back. */
void etch_scene_close(struct etch_scene *scene);

/* What drawing cost. */
struct etch_scene_stats {
    uint64_t triangles;             /* handed to the rasteriser: not culled, not rejected */
    uint64_t runs;                  /* of all fills, clipped, none empty */
    uint64_t pixels;                /* handed to kernels (before any test) and of outlines */
    struct etch_scene_facts *facts; /* filled in too, see scene_facts.h; or NULL */
};

/* Draws the whole scene on a surface: clears first, to black, the farthest depth and stencil 0.
 * Surfaces need a depth plane where scene->uses_depth, a stencil plane where scene->uses_stencil.
 * `stats` NULL: nothing is counted; else the counts are added to it, which makes outlines slow.
 * False if there was no memory for it. */
bool etch_scene_draw(const struct etch_scene *scene, struct etch_surface *surface,
                     struct etch_scene_stats *stats);

#endif
