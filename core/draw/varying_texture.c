/* draw/varying_texture.c: texture coordinates linear on the screen. Named by pipelines, called by
 * staged.c. See staged.h. */
#include "../raster/texture_plane.h"
#include "staged.h"

/* Four more bits where the span leaves room for them and a sign. */
static void coordinate(struct etch_linear_coordinate *out, const struct etch_varying_input *in,
                       const etch_q16 c[3])
{
    etch_q16 least = c[0], most = c[0];

    for (uint8_t i = 1; i < 3; i++) {
        least = c[i] < least ? c[i] : least;
        most = c[i] > most ? c[i] : most;
    }
    out->up = etch_wrap_sub((uint32_t)most, (uint32_t)least) >> 27 == 0 ? 4 : 0;
    out->least = least;
    etch_texture_axis(&out->plane, in->triangle, in->basis, c, out->up);
    out->plane.origin = etch_wrap_sub(out->plane.origin, etch_wrap_up((uint32_t)least, out->up));
}

void etch_varying_texture(struct etch_staged_planes *planes, const struct etch_varying_input *in)
{
    const struct etch_texture_vertex *v[3];

    for (uint8_t i = 0; i < 3; i++)
        v[i] = (const struct etch_texture_vertex *)in->v[i];
    const etch_q16 us[3] = {v[0]->u, v[1]->u, v[2]->u}, vs[3] = {v[0]->v, v[1]->v, v[2]->v};

    coordinate(&planes->texture.linear[0], in, us);
    coordinate(&planes->texture.linear[1], in, vs);
}
