/* raster/sector.c: rows of sectors. Called by arcs and pies. See sector.h.
 *
 * For a ray u the half turn [u, u + 1/2) is { p : u x p > 0 } and the ray itself. On row b, with
 * u_y > 0, these are the columns
 *
 *      x < b u_x / u_y       and x == b u_x / u_y too if b > 0, where the ray is
 *
 * that is x < cut(b) with cut = floor + 1 below the centre and ceil at and above it; the opposite
 * ray has the rest. The least u_y > 0 is 102,943 2^-30, so |u_x / u_y| < 10,431. A sector of up to
 * half a turn is what the half turn of its first ray has and that of its last ray has not; a larger
 * one is all but the sector that is left. */
#include "sector.h"
#include "../base/trig.h"

#define FAR (INT32_C(1) << 28) /* beyond every column, from every centre */

/* floor(dx b / dy) and the remainder. */
static int64_t ray_at(const struct etch_sector_ray *r, int32_t dx, int32_t b, int32_t *e)
{
    const int64_t n = etch_mul_s32(dx, b);
    const struct etch_quotient q = etch_divide_u64((uint64_t)(n < 0 ? -n : n), (uint64_t)r->dy);
    const int32_t rest = (int32_t)q.remainder;

    *e = n < 0 && rest != 0 ? r->dy - rest : rest;
    return n < 0 ? -(int64_t)q.quotient - (rest != 0) : (int64_t)q.quotient;
}

/* True if what is clockwise of it is on the left. */
static bool ray_init(struct etch_sector_ray *r, uint16_t angle, int32_t first, uint8_t stride)
{
    const uint32_t a = angle;
    const bool up = a == 0 || a > 32768;
    const uint16_t down = (uint16_t)((up ? a + 32768 : a) & 65535); /* above 0, up to half a turn */
    const int32_t dx = etch_cos_q30(down);

    r->dy = etch_sin_q30(down);
    if (r->dy != 0) {
        r->quotient = (int32_t)ray_at(r, dx, stride, &r->remainder);
        r->x = ray_at(r, dx, first, &r->e);
    }
    return !up;
}

static void ray_step(struct etch_sector_ray *r)
{
    if (r->dy == 0)
        return;
    r->x += r->quotient;
    r->e += r->remainder; /* both below 2^30 */
    if (r->e >= r->dy) {
        r->e -= r->dy;
        r->x++;
    }
}

/* A level ray points to the left (half a turn). */
static int32_t ray_cut(const struct etch_sector_ray *r, int32_t b)
{
    if (r->dy == 0)
        return b == 0 ? 0 : b > 0 ? -FAR : FAR;
    const int64_t cut = r->x + (b > 0 || r->e != 0);

    return cut < -FAR ? -FAR : cut > FAR ? FAR : (int32_t)cut;
}

void etch_sector_init(struct etch_sector *s, uint16_t from, uint32_t sweep, int32_t first,
                      uint8_t stride)
{
    const uint32_t turn = sweep < 65536 ? sweep : 65536; /* more is all, not the rest */
    const uint16_t to = (uint16_t)((from + (turn & 65535)) & 65535);

    s->inverted = turn > 32768;
    s->first_is_left = ray_init(&s->first, s->inverted ? to : from, first, stride);
    s->last_is_left = ray_init(&s->last, s->inverted ? from : to, first, stride);
    s->b = first;
    s->stride = stride;
}

void etch_sector_move(struct etch_sector *s, int32_t cx, int32_t b)
{
    int32_t low = -FAR, high = FAR, cut;

    for (; s->b < b; s->b += s->stride) {
        ray_step(&s->first);
        ray_step(&s->last);
    }
    cut = ray_cut(&s->first, b);
    if (s->first_is_left)
        high = cut;
    else
        low = cut;
    cut = ray_cut(&s->last, b);
    if (s->last_is_left)
        low = cut > low ? cut : low;
    else
        high = cut < high ? cut : high;
    s->low = low + cx;
    s->high = high + cx;
}

void etch_sector_add(const struct etch_sector *s, struct etch_row *row, int32_t x0, int32_t x1)
{
    if (!s->inverted) {
        etch_row_add(row, s->low > x0 ? s->low : x0, s->high < x1 ? s->high : x1);
    } else if (s->low < s->high) {
        etch_row_add(row, x0, s->low < x1 ? s->low : x1);
        etch_row_add(row, s->high > x0 ? s->high : x0, x1);
    } else {
        etch_row_add(row, x0, x1);
    }
}
