/* draw/mesh_shaded.c: the vertex function of lamps. Called through etch_mesh_stage by draw/mesh.
 * See mesh_shaded.h. */
#include "mesh_shaded_point.h"

enum etch_status etch_mesh_shaded_init(struct etch_mesh_shaded_stage *stage,
                                       const struct etch_mesh *mesh,
                                       const struct etch_matrix *model_to_clip,
                                       const struct etch_matrix *model_to_world,
                                       etch_shade_function *shade, const void *lighting)
{
    etch_mesh_stage_init(&stage->stage, mesh, model_to_clip, etch_vertex_shaded, NULL);
    etch_transform_init(&stage->model, model_to_world, mesh->bits, mesh->extent);
    stage->shade = shade;
    stage->lighting = lighting;
    return etch_normal_matrix_init(&stage->normals, model_to_world);
}

void etch_vertex_shaded(const struct etch_mesh_stage *stage, uint16_t index,
                        struct etch_clip_vertex *out)
{
    /* stage is the first member of a wider one */
    const struct etch_mesh_shaded_stage *const wide = (const void *)stage;
    struct etch_shade_point point;

    etch_vertex_plain(stage, index, out);
    shaded_point(wide, index, &point);
    uint8_t rgb[3] = {out->r, out->g, out->b};
    wide->shade(wide->lighting, &point, rgb);
    out->r = rgb[0];
    out->g = rgb[1];
    out->b = rgb[2];
}
