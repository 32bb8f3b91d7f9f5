/* vertex/assembly.c: clip-space triangles to the sink. Called by draw/mesh for triangles that
 * need clipping, and by applications that have clip-space vertices. See assembly.h. */
#include "assembly.h"

static void emit(const struct etch_assembly *assembly, const struct etch_vertex *const v[3])
{
    if (etch_cull_keeps(assembly->cull, v))
        assembly->sink->triangle(assembly->sink, v);
}

/* Triangle i = 1 .. n - 2 of the fan round v[apex]. */
static void fan_triangle(const struct etch_vertex *t[3], const struct etch_vertex *v, uint8_t n,
                         uint8_t apex, uint8_t i)
{
    const uint8_t second = (uint8_t)(apex + i < n ? apex + i : apex + i - n);

    t[0] = &v[apex];
    t[1] = &v[second];
    t[2] = &v[second + 1 < n ? second + 1 : 0];
}

/* The first vertex whose fan has no two triangles of opposite winding, else 0. */
static uint8_t fan_apex(const struct etch_vertex *v, uint8_t n)
{
    for (uint8_t apex = 0; apex < n; apex++) {
        bool left = false, right = false;

        for (uint8_t i = 1; i + 1 < n; i++) {
            const struct etch_vertex *t[3];

            fan_triangle(t, v, n, apex, i);
            const int8_t winding = etch_winding(t);
            left = left || winding < 0;
            right = right || winding > 0;
        }
        if (!left || !right)
            return apex;
    }
    return 0;
}

void etch_assemble_fan(const struct etch_assembly *assembly, const struct etch_clip_vertex *v,
                       uint8_t n)
{
    struct etch_vertex projected[ETCH_CLIP_MAX];

    for (uint8_t i = 0; i < n; i++)
        etch_viewport_project(&assembly->viewport, &v[i], &projected[i]);

    const uint8_t apex = n > 3 ? fan_apex(projected, n) : 0;
    for (uint8_t i = 1; i + 1 < n; i++) {
        const struct etch_vertex *t[3];

        fan_triangle(t, projected, n, apex, i);
        emit(assembly, t);
    }
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
