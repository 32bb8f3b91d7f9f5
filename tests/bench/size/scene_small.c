/* size/scene_small.c: the scene of scene.c by the small names: a mesh with normals, turned and
 * placed before a perspective camera whose matrix is a constant, lit, clipped, culled, Gouraud with
 * depth. */
#include "size.h"

#include "../../../core/draw/mesh_small.h"
#include "../../../core/draw/triangle_small.h"
#include "../../../core/fragment/gouraud_small.h"
#include "../../../core/vertex/light_small.h"
#include "../../../core/vertex/rotate_small.h"

struct etch_mesh size_mesh;
struct etch_lighting size_lighting;
struct etch_light size_light;
volatile uint16_t size_angle;

int main(void)
{
    static const struct etch_surface s = SIZE_SURFACE(size_depth);
    static const struct etch_vector towards = {ETCH_Q16_ONE, 2 * ETCH_Q16_ONE, ETCH_Q16_ONE};
    /* etch_matrix_perspective_focal with focal 2, aspect 4:3, near 1, far 8 */
    static const struct etch_matrix projection = {{{ETCH_Q16(3, 2), 0, 0, 0},
                                                   {0, ETCH_Q16(2, 1), 0, 0},
                                                   {0, 0, -ETCH_Q16(9, 7), -ETCH_Q16(16, 7)},
                                                   {0, 0, -ETCH_Q16_ONE, 0}}};
    struct etch_assembly assembly = {.cull = ETCH_CULL_CLOCKWISE};
    struct etch_matrix model, clip;
    struct etch_mesh_stage stage;
    struct etch_raster_sink raster;

    etch_raster_sink_init(&raster, &s, etch_triangle_gouraud_depth_small,
                          etch_kernel_gouraud_less_small);
    assembly.sink = &raster.sink;
    (void)etch_viewport_init(&assembly.viewport, s.clip);
    etch_matrix_rotate_y_small(&model, size_angle);
    (void)etch_light_aim_small(&size_light, &model, &towards);
    model.m[2][3] = -4 * ETCH_Q16_ONE;
    (void)etch_matrix_multiply(&clip, &projection, &model);
    etch_mesh_stage_init_small(&stage, &size_mesh, &clip, etch_vertex_lit_small, &size_lighting);
    etch_mesh_draw_small(&stage, &assembly);
    return 0;
}
