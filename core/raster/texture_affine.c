/* raster/texture_affine.c: texture coordinates linear on the screen. Called by draw/. See
 * texture_plane.h. */
#include "texture_plane.h"

/* The most that a plane may err, in units, on the visible part of the triangle. */
static uint32_t error_of(const struct etch_triangle *t, uint32_t span)
{
    const int32_t x1 = t->x1 < INT16_MAX ? t->x1 : INT16_MAX;
    const int32_t y1 = t->y1 < INT16_MAX ? t->y1 : INT16_MAX;
    const int32_t exact = (x1 > 0 ? x1 : 0) + (y1 > 0 ? y1 : 0);

    return (uint32_t)((exact >> 1) + (t->x1 - t->x0) + (t->y1 - t->y0)) + 10 + (span >> 26);
}

/* Values are taken against their least and with as many more bits as the span leaves. */
void etch_texture_axis(struct etch_plane *plane, const struct etch_triangle *t,
                       const struct etch_basis *basis, const etch_q16 c[3], uint8_t extra)
{
    etch_q16 least = c[0], most = c[0];
    uint32_t value[3];

    for (uint8_t i = 1; i < 3; i++) {
        least = c[i] < least ? c[i] : least;
        most = c[i] > most ? c[i] : most;
    }
    const uint32_t wide = etch_wrap_sub((uint32_t)most, (uint32_t)least);
    const uint8_t zeros = etch_leading_zeros(wide);
    const uint8_t up = zeros > extra ? extra : (uint8_t)(zeros > 0 ? zeros - 1 : 0);
    const uint32_t span = wide << up, all = error_of(t, span), cap = UINT32_C(512) << up;
    const uint32_t inset = all < cap ? all : cap, half = span >> 1;

    for (uint8_t i = 0; i < 3; i++) {
        const uint32_t v = etch_wrap_sub((uint32_t)c[i], (uint32_t)least) << up;

        value[i] = inset >= half ? half : v < inset ? inset : v > span - inset ? span - inset : v;
    }
    if (span > INT32_MAX)
        etch_plane_setup(plane, t, value);
    else
        etch_texture_plane(plane, t, basis, value);
    plane->origin = etch_wrap_add(plane->origin, etch_wrap_up((uint32_t)least, up));
    plane->origin = etch_wrap_up(plane->origin, (uint8_t)(extra - up));
    plane->dx = etch_wrap_up(plane->dx, (uint8_t)(extra - up));
    plane->dy = etch_wrap_up(plane->dy, (uint8_t)(extra - up));
}

void etch_texture_affine(struct etch_plane *u, struct etch_plane *v, const struct etch_triangle *t,
                         const struct etch_basis *basis,
                         const struct etch_texture_vertex *const vertex[3], uint8_t width_bits)
{
    const etch_q16 us[3] = {vertex[0]->u, vertex[1]->u, vertex[2]->u};
    const etch_q16 vs[3] = {vertex[0]->v, vertex[1]->v, vertex[2]->v};

    etch_texture_axis(u, t, basis, us, 4);
    etch_texture_axis(v, t, basis, vs, width_bits);
}
