/* vertex/clip_line_planes.c: Liang-Barsky in homogeneous coordinates. Called by the clippers that
 * clip_line.h describes, which only name their planes.
 *
 * With distances d0 and d1 of the ends from a plane it is met at t = d0 / (d0 - d1), which is the
 * corner of weights |d1| : |d0|. Whether that lies before or beyond another plane's is the sign of
 * |d1| e0 + |d0| e1: whether the corner is inside the other plane. corner.h computes both. */
#include "clip_line_planes.h"

#include "corner.h"

/* One end of what is left: a vertex, or where the line meets a plane. */
struct end {
    bool is_cut;
    struct corner_weights corner;
    struct corner_line plane;
};

/* Distances of the ends from the plane, negative outside, at most 2^41 + 2^31. */
static void set_plane(struct corner_line *plane, const struct etch_clip_vertex v[2], uint8_t axis,
                      uint8_t shift, bool upper)
{
    for (uint8_t i = 0; i < 2; i++) {
        const int64_t c = axis == 0 ? v[i].x : axis == 1 ? v[i].y : v[i].z;

        plane->at[i] = v[i].w * (INT64_C(1) << shift) + (upper ? -c : c);
    }
    plane->at[2] = 0;
}

/* Moves an end to the plane unless it is beyond it already. */
static void move(struct end *end, const struct corner_line *plane)
{
    const struct corner_line edge = {{0, 0, 1}};

    if (end->is_cut && etch_corner_is_inside(&end->corner, plane))
        return;
    end->is_cut = true;
    end->plane = *plane;
    etch_corner_meet(&end->corner, &edge, plane);
}

/* Cuts at one plane. False if the line is outside. */
static bool cut(struct end end[2], const struct corner_line *plane)
{
    const bool out0 = plane->at[0] < 0, out1 = plane->at[1] < 0;

    if (out0 && out1)
        return false;
    if (out0)
        move(&end[0], plane);
    if (out1)
        move(&end[1], plane);
    return true;
}

/* Whether the last entry lies before the first exit, or on it. */
static bool is_ordered(const struct end end[2])
{
    return !end[0].is_cut || !end[1].is_cut || etch_corner_is_inside(&end[0].corner, &end[1].plane);
}

static void resolve(struct etch_clip_vertex *out, const struct end *end, uint8_t i,
                    const struct etch_clip_vertex v[2])
{
    /* the third weighs nothing */
    const struct etch_clip_vertex *const triangle[3] = {&v[0], &v[1], &v[1]};

    if (end->is_cut)
        etch_corner_resolve(out, &end->corner, triangle);
    else
        *out = v[i];
}

bool etch_clip_line_planes(const uint8_t shift[2], const struct etch_clip_vertex v[2],
                           struct etch_clip_vertex out[2])
{
    struct end end[2];

    end[0].is_cut = false;
    end[1].is_cut = false;
    for (uint8_t i = 0; i < 6; i++) {
        const uint8_t axis = i < 2 ? 2 : i < 4 ? 0 : 1;
        struct corner_line plane;

        set_plane(&plane, v, axis, axis == 2 ? 0 : shift[axis], (i & 1) != 0);
        if (!cut(end, &plane))
            return false;
    }
    if (!is_ordered(end))
        return false;
    resolve(&out[0], &end[0], 0, v);
    resolve(&out[1], &end[1], 1, v);
    return out[0].w > 0 && out[1].w > 0; /* else at the eye itself */
}
