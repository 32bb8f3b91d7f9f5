/* raster/line_clip_liang_barsky.c: lines cut by parameters. Called by applications. See
 * line_clip.h. */
#include "line_clip.h"
#include "line_cut.h"

/* The line meets a side at t = n / d, 0 <= n <= d. */
struct meeting {
    uint32_t n, d; /* d = 0: none yet */
    uint8_t axis;
    int32_t at;
};

/* The sign of a's t less b's, whose products stay below 2^64. */
static int8_t compare(const struct meeting *a, const struct meeting *b)
{
    const uint64_t x = (uint64_t)a->n * b->d, y = (uint64_t)b->n * a->d;

    return (int8_t)((x > y) - (x < y));
}

/* Takes the side `at`, outside of which lie ends for which out0 and out1 say so; false if both. */
static bool take_side(struct meeting found[2], const int32_t p[2][2], uint8_t axis, int32_t at,
                      bool out0, bool out1)
{
    const struct meeting m = {etch_line_cut_distance(p[0][axis], at),
                              etch_line_cut_distance(p[0][axis], p[1][axis]), axis, at};

    if (out0 && out1)
        return false;
    if (out0 && (found[0].d == 0 || compare(&m, &found[0]) > 0))
        found[0] = m;
    if (out1 && (found[1].d == 0 || compare(&m, &found[1]) < 0))
        found[1] = m;
    return true;
}

static struct etch_point_s32 resolve(const struct meeting *m, const int32_t p[2][2])
{
    const int32_t other = etch_line_cut_round(p[0], p[1], m->axis, m->at);
    const struct etch_point_s32 cut = {m->axis == 0 ? m->at : other, m->axis == 0 ? other : m->at};

    return cut;
}

bool etch_line_clip_liang_barsky(const struct etch_bounds *bounds, struct etch_point_s32 p[2])
{
    const int32_t line[2][2] = {{p[0].x, p[0].y}, {p[1].x, p[1].y}};
    const int32_t lo[2] = {bounds->x0, bounds->y0}, hi[2] = {bounds->x1, bounds->y1};
    struct meeting found[2] = {{0, 0, 0, 0}, {0, 0, 0, 0}}; /* last entry, first exit */

    for (uint8_t i = 0; i < 2; i++) {
        const int32_t a = line[0][i], b = line[1][i];

        if (!take_side(found, line, i, lo[i], a < lo[i], b < lo[i]) ||
            !take_side(found, line, i, hi[i], a > hi[i], b > hi[i]))
            return false;
    }
    if (found[0].d != 0 && found[1].d != 0 && compare(&found[0], &found[1]) > 0)
        return false;
    if (found[0].d != 0)
        p[0] = resolve(&found[0], line);
    if (found[1].d != 0)
        p[1] = resolve(&found[1], line);
    return true;
}
