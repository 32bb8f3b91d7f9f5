/* vertex/assembly_line.c: clip-space lines to the sink. Called by draw/mesh_elements and by
 * applications. See assembly_line.h. */
#include "assembly_line.h"
#include "clip_line.h"

void etch_assemble_line(const struct etch_assembly *assembly, const struct etch_clip_vertex v[2])
{
    struct etch_clip_vertex end[2] = {v[0], v[1]};
    struct etch_vertex out[2];
    const struct etch_vertex *const line[2] = {&out[0], &out[1]};
    const uint8_t a = etch_viewport_outcode(&assembly->viewport, &v[0]);
    const uint8_t b = etch_viewport_outcode(&assembly->viewport, &v[1]);

    if ((a & b & ETCH_OUT_REJECT) != 0)
        return;
    if (((a | b) & ETCH_OUT_CLIP) != 0 && !etch_clip_line(&assembly->viewport, v, end))
        return;
    if (assembly->flat) {
        end[0].r = end[1].r = v[0].r;
        end[0].g = end[1].g = v[0].g;
        end[0].b = end[1].b = v[0].b;
        end[0].a = end[1].a = v[0].a;
    }
    etch_viewport_project(&assembly->viewport, &end[0], &out[0]);
    etch_viewport_project(&assembly->viewport, &end[1], &out[1]);
    assembly->sink->line(assembly->sink, line);
}
