/* vertex/assembly_point.c: clip-space points to the sink. Called by draw/mesh_elements and by
 * applications. See assembly_line.h. */
#include "assembly_line.h"

void etch_assemble_point(const struct etch_assembly *assembly, const struct etch_clip_vertex *v)
{
    struct etch_vertex out;

    if ((etch_viewport_outcode(&assembly->viewport, v) & ETCH_OUT_CLIP) != 0)
        return;
    etch_viewport_project(&assembly->viewport, v, &out);
    assembly->sink->point(assembly->sink, &out);
}
