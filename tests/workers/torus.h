/* tests/workers: a lit torus of 50,000 triangles, or fewer, and how several workers draw it. */
#ifndef TESTS_WORKERS_TORUS_H
#define TESTS_WORKERS_TORUS_H

#include "core/draw/mesh.h"
#include "core/draw/retained_rows.h"
#include "hal/workers.h"

/* Vertices round the ring and round the tube. */
#ifndef TORUS_AROUND
#define TORUS_AROUND 250
#define TORUS_ALONG 100
#endif

enum {
    TORUS_VERTICES = TORUS_AROUND * TORUS_ALONG,
    TORUS_TRIANGLES = 2 * TORUS_VERTICES,
    TORUS_PARTS = 10 /* shares of vertices and of triangles */
};

/* What the workers share: the mesh and its transformed vertices; of each share of the triangles
 * those that are visible. */
struct torus {
    int16_t positions[TORUS_VERTICES * 3];
    int8_t normals[TORUS_VERTICES * 3];
    uint16_t indices[TORUS_TRIANGLES * 3];
    struct etch_mesh mesh;
    struct etch_mesh_vertex vertex[TORUS_VERTICES];
    struct etch_mesh_row_range list[TORUS_TRIANGLES];
    uint16_t visible[TORUS_PARTS];
    struct etch_light light;
    struct etch_lighting lighting;
    struct etch_mesh_stage stage;
    struct etch_assembly assembly; /* without a sink */
    bool swapped;                  /* colours have their high byte first; set it */
};

/* Makes the mesh. */
void torus_make(struct torus *torus);

/* Sets matrices and light for a frame of this size, seen from `turn` (65536 is a whole one). */
void torus_turn(struct torus *torus, uint16_t turn, int16_t width, int16_t height);

/* One worker's share of the frame: vertices, lists, strips. */
void torus_draw_share(struct torus *torus, struct etch_worker *worker);

/* The frame by one thread on one surface, without lists. */
void torus_draw_alone(struct torus *torus, const struct etch_surface *surface);

#endif
