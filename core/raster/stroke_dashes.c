/* raster/stroke_dashes.c: thick polylines in dashes. Called by applications. See stroke.h.
 *
 * The line is cut where dashes begin and end; what lies between two cuts or corners is a segment of
 * its own, with a joint to the one before if the dash goes on and caps where it begins and ends. */
#include "stroke_parts.h"

struct dashes {
    const struct etch_outline *o;
    const struct etch_stroke *stroke;
    const int32_t *dash;
    uint8_t count, index; /* even: a dash, odd: a gap */
    int32_t left;         /* of it */
    uint32_t more;        /* dashes that may still begin */
    bool open;            /* a dash goes on from the segment before */
    struct etch_point_q8 across;
};

static void next_dash(struct dashes *d)
{
    d->index = (uint8_t)(d->index + 1 == d->count ? 0 : d->index + 1);
    d->left = d->dash[d->index];
}

/* The point `at` of `length` between a and b. */
static struct etch_point_q8 along(struct etch_point_q8 a, struct etch_point_q8 b, uint32_t at,
                                  uint32_t length)
{
    return stroke_moved(a, etch_divide_round_s64(etch_mul_s32(b.x - a.x, (int32_t)at), length),
                        etch_divide_round_s64(etch_mul_s32(b.y - a.y, (int32_t)at), length));
}

static void dash_part(struct dashes *d, struct etch_point_q8 p, struct etch_point_q8 q,
                      struct etch_point_q8 n, bool ends)
{
    const struct etch_point_q8 back = {-n.x, -n.y};

    if (d->open)
        d->stroke->join(d->o, p, d->across, n, d->stroke);
    else
        d->stroke->cap(d->o, p, back, back, d->stroke);
    etch_stroke_segment(d->o, p, q, n);
    if (ends)
        d->stroke->cap(d->o, q, n, n, d->stroke);
    d->open = !ends;
    d->across = n;
}

static void segment(struct dashes *d, struct etch_point_q8 a, struct etch_point_q8 b, bool last)
{
    const uint32_t length = etch_stroke_length(b.x - a.x, b.y - a.y);
    struct etch_point_q8 n;
    uint32_t at = 0;

    if (length == 0)
        return;
    n = etch_stroke_scaled(-(b.y - a.y), b.x - a.x, d->stroke->width_q8 / 2);
    while (at < length && d->more > 0) {
        const uint32_t rest = length - at;
        const uint32_t take = (uint32_t)d->left < rest ? (uint32_t)d->left : rest;
        const bool ends = take == (uint32_t)d->left || (last && take == rest);

        if (d->index % 2 == 0)
            dash_part(d, along(a, b, at, length), along(a, b, at + take, length), n, ends);
        at += take;
        d->left -= (int32_t)take;
        if (d->left == 0) {
            next_dash(d);
            d->more--;
        }
    }
}

void etch_stroke_dashes(const struct etch_outline *o, const struct etch_point_q8 *v, uint16_t n,
                        const struct etch_stroke *stroke, const int32_t *dash, uint8_t count,
                        int32_t phase)
{
    struct dashes d = {o, stroke, dash, count, 0, 0, UINT32_C(1) << 17, false, {0, 0}};

    if (count < 2 || count % 2 != 0 || phase < 0 || stroke->width_q8 < 2 ||
        stroke->width_q8 > INT32_C(32768))
        return;
    for (uint8_t i = 0; i < count; i++)
        if (dash[i] < 1)
            return;
    for (d.left = dash[0]; phase >= d.left; next_dash(&d))
        phase -= d.left;
    d.left -= phase;
    for (uint16_t i = 1; i < n; i++)
        segment(&d, v[i - 1], v[i], i + 1 == n);
}
