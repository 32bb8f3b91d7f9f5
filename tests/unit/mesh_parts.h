/* tests/unit/mesh_parts.h: meshes and cameras that the mesh suites share. */
#ifndef TESTS_UNIT_MESH_PARTS_H
#define TESTS_UNIT_MESH_PARTS_H

#include "core/draw/mesh.h"
#include "tests/harness/harness.h"

/* An octahedron: six vertices on the axes, normals outwards, each face counter-clockwise. */
static const int16_t octa_positions[] = {1000, 0,     0, -1000, 0, 0,    0, 1000, 0,
                                         0,    -1000, 0, 0,     0, 1000, 0, 0,    -1000};
static const int8_t octa_normals[] = {127, 0,    0, -127, 0, 0,   0, 127, 0,
                                      0,   -127, 0, 0,    0, 127, 0, 0,   -127};
static const uint16_t octa_indices[] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4,
                                        2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
static const struct etch_mesh octahedron = {
    octa_positions, octa_normals, NULL, octa_indices, 6, 8, 1000, 10};

#define GRID 17

static int16_t grid_positions[GRID * GRID * 3];
static uint8_t grid_colors[GRID * GRID * 3];
static uint16_t grid_indices[(GRID - 1) * (GRID - 1) * 6];
static const struct etch_mesh grid = {grid_positions, NULL,       grid_colors,
                                      grid_indices,   GRID *GRID, (GRID - 1) * (GRID - 1) * 2,
                                      32767,          0};

/* A square in the plane y = 0, +-size, triangles facing up, in uneven steps, diagonals both ways.
 */
static inline void make_grid(int32_t size, uint32_t *seed)
{
    int32_t i, x, z;

    for (i = 0; i < GRID * GRID; i++) {
        const int32_t shake = size / GRID / 3;
        const bool border = i % GRID == 0 || i % GRID == GRID - 1 || i < GRID ||
                            i >= GRID * (GRID - 1);
        const int32_t dx = border ? 0 : test_range(seed, -shake, shake);
        const int32_t dz = border ? 0 : test_range(seed, -shake, shake);

        grid_positions[3 * i] = (int16_t)(size * 2 * (i % GRID) / (GRID - 1) - size + dx);
        grid_positions[3 * i + 1] = 0;
        grid_positions[3 * i + 2] = (int16_t)(size * 2 * (i / GRID) / (GRID - 1) - size + dz);
        grid_colors[3 * i] = (uint8_t)(i * 7);
        grid_colors[3 * i + 1] = (uint8_t)(i * 31);
        grid_colors[3 * i + 2] = (uint8_t)i;
    }
    for (z = 0; z < GRID - 1; z++) {
        for (x = 0; x < GRID - 1; x++) {
            uint16_t *t = &grid_indices[(z * (GRID - 1) + x) * 6];
            const uint16_t a = (uint16_t)(z * GRID + x), b = (uint16_t)(a + 1);
            const uint16_t c = (uint16_t)(a + GRID), d = (uint16_t)(c + 1);
            const bool turn = test_range(seed, 0, 1) == 0;
            const uint16_t one[6] = {a, c, b, b, c, d}, two[6] = {a, c, d, a, d, b};

            for (i = 0; i < 6; i++)
                t[i] = turn ? one[i] : two[i];
        }
    }
}

static struct etch_mesh_vertex buffer[GRID * GRID];

/* Perspective * camera, which must be possible. */
static inline struct etch_matrix
camera(const struct etch_vector *eye, const struct etch_vector *target, etch_q16 near, etch_q16 far)
{
    static const struct etch_vector up = {0, 65536, 0};
    struct etch_matrix view, m;

    CHECK_EQ(etch_matrix_look_at(&view, eye, target, &up), ETCH_OK);
    CHECK_EQ(etch_matrix_perspective(&m, 0x2800, ETCH_Q16(4, 3), near, far), ETCH_OK);
    CHECK_EQ(etch_matrix_multiply(&m, &m, &view), ETCH_OK);
    return m;
}

static inline struct etch_assembly assembly_for(struct etch_sink *sink, struct etch_rect rect)
{
    struct etch_assembly a = {.cull = ETCH_CULL_NONE, .flat = false, .sink = sink};

    CHECK_EQ(etch_viewport_init(&a.viewport, rect), ETCH_OK);
    return a;
}

static const struct etch_rect screen = {0, 0, 64, 48};

#endif
