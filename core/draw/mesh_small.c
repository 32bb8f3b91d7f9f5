/* draw/mesh_small.c: meshes in few bytes. Called by the application. See mesh_small.h. */
#include "mesh_small.h"
#include "../vertex/assembly_small.h"

void etch_mesh_stage_init_small(struct etch_mesh_stage *stage, const struct etch_mesh *mesh,
                                const struct etch_matrix *model_to_clip,
                                etch_vertex_function *vertex, const struct etch_lighting *lighting)
{
    stage->mesh = mesh;
    stage->vertex = vertex;
    stage->transform.matrix = *model_to_clip;
    stage->transform.bits = mesh->bits < 15 ? mesh->bits : 15;
    stage->transform.narrow = false;
    stage->lighting = lighting;
    for (uint8_t i = 0; i < 4; i++)
        stage->color[i] = 255;
}

/* round(a * b / 255). */
static uint8_t modulate(uint8_t a, uint8_t b)
{
    const uint32_t product = (uint32_t)a * b + 128;

    return (uint8_t)((product + (product >> 8)) >> 8);
}

void etch_vertex_plain_small(const struct etch_mesh_stage *stage, uint16_t index,
                             struct etch_clip_vertex *out)
{
    const uint8_t bits = stage->transform.bits;
    etch_q16 *const coordinate = (void *)out; /* x, y, z, w */
    int16_t p[3];
    uint8_t rgb[3];

    etch_mesh_position(stage->mesh, index, p);
    for (uint8_t i = 0; i < 4; i++) { /* as vertex/transform.c; |sum| < 3 * 2^46 + 2^46 */
        const etch_q16 *const row = stage->transform.matrix.m[i];
        int64_t sum = etch_mul_s32(row[3], INT32_C(1) << bits) + (INT32_C(1) << bits >> 1);

        for (uint8_t k = 0; k < 3; k++)
            sum += etch_mul_s32(row[k], p[k]);
        coordinate[i] = etch_saturate_s32(sum >> bits);
    }
    etch_mesh_color(stage->mesh, index, rgb);
    out->r = modulate(rgb[0], stage->color[0]);
    out->g = modulate(rgb[1], stage->color[1]);
    out->b = modulate(rgb[2], stage->color[2]);
    out->a = stage->color[3];
}

void etch_mesh_draw_small(const struct etch_mesh_stage *stage, const struct etch_assembly *assembly)
{
    const uint16_t count = stage->mesh->vertex_count;

    for (uint16_t t = 0; t < stage->mesh->triangle_count; t++) {
        struct etch_clip_vertex v[3];
        uint16_t index[3];
        uint8_t i = 0;

        etch_mesh_triangle(stage->mesh, t, index);
        for (; i < 3 && index[i] < count; i++)
            stage->vertex(stage, index[i], &v[i]);
        if (i == 3)
            etch_assemble_triangle_small(assembly, v);
    }
}
