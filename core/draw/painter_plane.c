/* draw/painter_plane.c: on which side of a plane a vertex lies. Called by painter_test.c and
 * painter_cut.c. See painter.h.
 *
 * Differences in x and y are at most 2^24, in z below 2^32, so nx, ny < 2 2^24 2^32 and a distance
 * takes 84 bits. With n = h 2^28 + l, 0 <= l < 2^28, it is the sum of h d times 2^28 and that of
 * l d, each of which fits 62 bits. */
#include "painter_steps.h"

#define LOW_BITS 28
#define LOW_MASK ((INT64_C(1) << LOW_BITS) - 1)

static int64_t magnitude(int64_t v)
{
    return v < 0 ? -v : v;
}

static int64_t depth_from(const struct etch_vertex *a, const struct etch_vertex *b)
{
    return (int64_t)b->z_q16 - (int64_t)a->z_q16;
}

void etch_painter_plane_setup(struct etch_painter_plane *plane, const struct etch_vertex v[3])
{
    const int64_t x1 = v[1].x_q8 - v[0].x_q8, y1 = v[1].y_q8 - v[0].y_q8;
    const int64_t x2 = v[2].x_q8 - v[0].x_q8, y2 = v[2].y_q8 - v[0].y_q8;
    const int64_t z1 = depth_from(&v[0], &v[1]), z2 = depth_from(&v[0], &v[2]);
    const int64_t nz = x1 * y2 - y1 * x2, sign = nz < 0 ? -1 : 1;

    plane->nx = sign * (y1 * z2 - z1 * y2);
    plane->ny = sign * (z1 * x2 - x1 * z2);
    plane->nz = sign * nz;
    plane->near = 2 * (magnitude(plane->nx) + magnitude(plane->ny)) + 16 * plane->nz;
    plane->at = v[0];
}

struct etch_painter_distance etch_painter_distance(const struct etch_painter_plane *plane,
                                                   const struct etch_vertex *v)
{
    const int64_t nx = plane->nx, ny = plane->ny, nz = plane->nz;
    const int64_t dx = v->x_q8 - plane->at.x_q8, dy = v->y_q8 - plane->at.y_q8;
    const int64_t dz = depth_from(&plane->at, v);
    const int64_t low = (nx & LOW_MASK) * dx + (ny & LOW_MASK) * dy + (nz & LOW_MASK) * dz;
    const int64_t high = (nx >> LOW_BITS) * dx + (ny >> LOW_BITS) * dy + (nz >> LOW_BITS) * dz;
    const struct etch_painter_distance d = {high + (low >> LOW_BITS), (uint32_t)(low & LOW_MASK)};

    return d;
}

int8_t etch_painter_side(const struct etch_painter_plane *plane, const struct etch_vertex *v)
{
    const struct etch_painter_distance d = etch_painter_distance(plane, v);
    const int64_t near = plane->near >> LOW_BITS, minus = (-plane->near) >> LOW_BITS;

    if (d.high > near || (d.high == near && d.low > (plane->near & LOW_MASK)))
        return 1;
    return d.high < minus || (d.high == minus && d.low < (-plane->near & LOW_MASK)) ? -1 : 0;
}
