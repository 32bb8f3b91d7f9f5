/* draw/mesh_varying.c: wide vertices once, then triangles by index. Called by the application. See
 * mesh_varying.h. */
#include "mesh_varying.h"

/* What a vertex function of a varying stage writes to. */
struct wide_vertex {
    struct etch_clip_vertex at;
    int32_t varying[ETCH_VARYINGS];
};

/* An element of the buffer: vertex, count varyings and w, outcode. All of it are 32-bit members. */
static size_t out_at(uint8_t count)
{
    return sizeof(struct etch_vertex) / sizeof(uint32_t) + count + 1;
}

static const uint32_t *element(const void *buffer, uint8_t count, uint16_t index)
{
    return (const uint32_t *)buffer + (out_at(count) + 1) * index;
}

void etch_mesh_transform_varying(const struct etch_mesh_stage *stage,
                                 const struct etch_viewport *viewport, void *buffer, uint8_t count)
{
    uint32_t *to = buffer;

    for (uint16_t i = 0; i < stage->mesh->vertex_count; i++, to += out_at(count) + 1) {
        struct wide_vertex v;
        uint8_t out;

        stage->vertex(stage, i, &v.at);
        out = etch_viewport_outcode(viewport, &v.at);
        if ((out & ETCH_OUT_CLIP) == 0)
            etch_varying_project(viewport, &v.at, count, (struct etch_vertex *)(void *)to);
        to[out_at(count)] = out;
    }
}

/* A triangle that is flat, or crosses near, far or a guard plane, goes the long way round. */
static ETCH_COLD void assemble_again(const struct etch_mesh_stage *stage,
                                     const struct etch_assembly *assembly, uint8_t count,
                                     const uint16_t index[3])
{
    struct wide_vertex v[3];
    const struct etch_clip_vertex *const at[3] = {&v[0].at, &v[1].at, &v[2].at};

    for (int i = 0; i < 3; i++)
        stage->vertex(stage, index[i], &v[i].at);
    etch_assemble_varying(assembly, at, count);
}

void etch_mesh_triangle_varying(const struct etch_mesh_stage *stage,
                                const struct etch_assembly *assembly, const void *buffer,
                                uint8_t count, const uint16_t index[3])
{
    const uint16_t limit = stage->mesh->vertex_count;

    if (index[0] >= limit || index[1] >= limit || index[2] >= limit)
        return;
    const uint32_t *const a = element(buffer, count, index[0]);
    const uint32_t *const b = element(buffer, count, index[1]);
    const uint32_t *const c = element(buffer, count, index[2]);
    const struct etch_vertex *const v[3] = {(const void *)a, (const void *)b, (const void *)c};
    const size_t out = out_at(count);

    if ((a[out] & b[out] & c[out] & ETCH_OUT_REJECT) != 0)
        return;
    if (((a[out] | b[out] | c[out]) & ETCH_OUT_CLIP) != 0)
        assemble_again(stage, assembly, count, index);
    else if (!etch_cull_keeps(assembly->cull, v))
        return;
    else if (assembly->flat)
        assemble_again(stage, assembly, count, index);
    else
        assembly->sink->triangle(assembly->sink, v);
}

void etch_mesh_assemble_varying(const struct etch_mesh_stage *stage,
                                const struct etch_assembly *assembly, const void *buffer,
                                uint8_t count)
{
    for (uint16_t t = 0; t < stage->mesh->triangle_count; t++) {
        uint16_t index[3];

        etch_mesh_triangle(stage->mesh, t, index);
        etch_mesh_triangle_varying(stage, assembly, buffer, count, index);
    }
}
