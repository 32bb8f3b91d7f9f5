/* vertex/assembly.c: clip-space triangles to the sink. Called by draw/mesh for triangles that
 * need clipping, and by applications that have clip-space vertices. See assembly.h. */
#include "assembly.h"
#include "corner.h"
#include "fan.h"

void etch_assemble_projected(const struct etch_assembly *assembly, const struct etch_vertex *v,
                             uint8_t n)
{
    const struct etch_vertex *ring[ETCH_CLIP_MAX];

    for (uint8_t i = 0; i < n; i++)
        ring[i] = &v[i];
    etch_fan_emit(assembly, ring, n);
}

void etch_assemble_fan(const struct etch_assembly *assembly, const struct etch_clip_vertex *v,
                       uint8_t n)
{
    struct etch_vertex projected[ETCH_CLIP_MAX];

    for (uint8_t i = 0; i < n; i++)
        etch_viewport_project(&assembly->viewport, &v[i], &projected[i]);
    etch_assemble_projected(assembly, projected, n);
}

/* A corner of the triangle whose vertex 0 is `first`. */
static void project(const struct etch_assembly *assembly, const struct etch_clip_vertex *corner,
                    const struct etch_clip_vertex *first, struct etch_vertex *out)
{
    etch_viewport_project(&assembly->viewport, corner, out);
    if (assembly->flat) {
        out->r = first->r;
        out->g = first->g;
        out->b = first->b;
        out->a = first->a;
    }
}

static ETCH_COLD uint8_t clip(const struct etch_assembly *assembly,
                              const struct etch_clip_vertex v[3],
                              struct etch_vertex out[ETCH_CLIP_MAX])
{
    const struct corner_triangle t = {
        {&v[0], &v[1], &v[2]}, assembly->viewport.guard_x, assembly->viewport.guard_y};
    struct corner corner[ETCH_CLIP_MAX];
    const uint8_t n = etch_corner_clip(&t, corner);

    for (uint8_t i = 0; i < n; i++) {
        struct etch_clip_vertex at;

        etch_corner_take(&at, &t, &corner[i]);
        if (at.w <= 0) /* the eye itself: the triangle is seen edge-on */
            return 0;
        project(assembly, &at, &v[0], &out[i]);
    }
    return n;
}

uint8_t etch_assemble_polygon(const struct etch_assembly *assembly,
                              const struct etch_clip_vertex v[3],
                              struct etch_vertex out[ETCH_CLIP_MAX])
{
    uint8_t all = ETCH_OUT_REJECT, any = 0;

    for (uint8_t i = 0; i < 3; i++) {
        const uint8_t code = etch_viewport_outcode(&assembly->viewport, &v[i]);

        all &= code;
        any |= code;
    }
    if (all != 0)
        return 0;
    if ((any & ETCH_OUT_CLIP) != 0)
        return clip(assembly, v, out);
    for (uint8_t i = 0; i < 3; i++)
        project(assembly, &v[i], &v[0], &out[i]);
    return 3;
}

void etch_assemble_triangle(const struct etch_assembly *assembly,
                            const struct etch_clip_vertex v[3])
{
    struct etch_vertex polygon[ETCH_CLIP_MAX];
    const uint8_t n = etch_assemble_polygon(assembly, v, polygon);

    etch_assemble_projected(assembly, polygon, n);
}
