/* vertex/clip_volume_assembly.c: triangles through the six-plane clip to a sink. Called by
 * applications. See clip_volume.h. */
#include "clip_volume.h"

static void copy_color(struct etch_clip_vertex *to, const struct etch_clip_vertex *from)
{
    to->r = from->r;
    to->g = from->g;
    to->b = from->b;
    to->a = from->a;
}

void etch_assemble_triangle_volume(const struct etch_assembly *assembly,
                                   const struct etch_clip_vertex v[3])
{
    struct etch_clip_vertex t[3] = {v[0], v[1], v[2]}, polygon[ETCH_CLIP_MAX];

    if (assembly->flat) {
        copy_color(&t[1], &t[0]);
        copy_color(&t[2], &t[0]);
    }
    etch_assemble_fan(assembly, polygon, etch_clip_triangle_volume(t, polygon));
}
