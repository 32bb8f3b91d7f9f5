/* size/scene.c: a whole scene: a mesh with normals, turned and placed, before a perspective
 * camera, lit, clipped, culled, Gouraud with depth. */
#include "size.h"

#include "../../../core/draw/mesh.h"
#include "../../../core/fragment/gouraud.h"

struct etch_mesh size_mesh;
struct etch_mesh_vertex size_buffer[1024];
struct etch_lighting size_lighting;
struct etch_light size_light;
volatile uint16_t size_angle;

int main(void)
{
    static const struct etch_surface s = SIZE_SURFACE(size_depth);
    static const struct etch_vector towards = {ETCH_Q16_ONE, 2 * ETCH_Q16_ONE, ETCH_Q16_ONE};
    struct etch_assembly assembly = {.cull = ETCH_CULL_CLOCKWISE};
    struct etch_matrix model, place, clip;
    struct etch_mesh_stage stage;
    struct etch_raster_sink raster;

    etch_raster_sink_init(&raster, &s, etch_triangle_gouraud_depth, etch_kernel_gouraud_less);
    assembly.sink = &raster.sink;
    (void)etch_viewport_init(&assembly.viewport, s.clip);
    etch_matrix_rotate_y(&model, size_angle);
    etch_matrix_translate(&place, 0, 0, -4 * ETCH_Q16_ONE);
    (void)etch_matrix_perspective_focal(&clip, 2 * ETCH_Q16_ONE, ETCH_Q16(4, 3), ETCH_Q16_ONE,
                                        8 * ETCH_Q16_ONE);
    (void)etch_matrix_multiply(&clip, &clip, &place);
    (void)etch_matrix_multiply(&clip, &clip, &model);
    (void)etch_light_aim(&size_light, &model, &towards);
    etch_mesh_stage_init(&stage, &size_mesh, &clip, etch_vertex_lit, &size_lighting);
    (void)etch_mesh_draw(&stage, &assembly, size_buffer, 1024);
    return 0;
}
