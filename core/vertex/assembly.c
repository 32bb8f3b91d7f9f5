/* vertex/assembly.c: clip-space triangles to the sink. Called by draw/mesh for triangles that
 * need clipping, and by applications that have clip-space vertices. See assembly.h. */
#include "assembly.h"
#include "fan.h"

void etch_assemble_fan(const struct etch_assembly *assembly, const struct etch_clip_vertex *v,
                       uint8_t n)
{
    struct etch_vertex projected[ETCH_CLIP_MAX];
    const struct etch_vertex *ring[ETCH_CLIP_MAX];

    for (uint8_t i = 0; i < n; i++) {
        etch_viewport_project(&assembly->viewport, &v[i], &projected[i]);
        ring[i] = &projected[i];
    }
    etch_fan_emit(assembly, ring, n);
}

static void copy_color(struct etch_clip_vertex *to, const struct etch_clip_vertex *from)
{
    to->r = from->r;
    to->g = from->g;
    to->b = from->b;
    to->a = from->a;
}

void etch_assemble_triangle(const struct etch_assembly *assembly,
                            const struct etch_clip_vertex v[3])
{
    struct etch_clip_vertex polygon[ETCH_CLIP_MAX] = {v[0], v[1], v[2]};
    uint8_t all = ETCH_OUT_REJECT, any = 0, n = 3;

    for (int i = 0; i < 3; i++) {
        const uint8_t out = etch_viewport_outcode(&assembly->viewport, &v[i]);

        all &= out;
        any |= out;
    }
    if (all != 0)
        return;
    if (assembly->flat) {
        copy_color(&polygon[1], &polygon[0]);
        copy_color(&polygon[2], &polygon[0]);
    }
    if ((any & ETCH_OUT_CLIP) != 0) {
        const struct etch_clip_vertex t[3] = {polygon[0], polygon[1], polygon[2]};

        n = etch_clip_triangle(&assembly->viewport, t, polygon);
    }
    etch_assemble_fan(assembly, polygon, n);
}
