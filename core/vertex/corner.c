/* vertex/corner.c: where lines of a triangle meet, exactly. Called by corner_plane.c,
 * corner_clip.c, clip_line_planes.c and varying.c. See corner.h.
 *
 * Widths: a line's numbers have 42 bits, weights are differences of two products of them, 85
 * bits, and a corner's distance or coordinate is a sum of three weights times 42 bits. */
#include "corner.h"

enum {
    LIMB_BITS = 15,
    LOW_BITS = 21
};

#define LIMB INT64_C(0x8000)
#define LIMB_MASK 0x7FFF
#define LOW_MASK ((INT32_C(1) << LOW_BITS) - 1)

/* |v| or |v| - 1: below the same power of two. */
static uint64_t size(int64_t v)
{
    return (uint64_t)(v ^ (v >> 63));
}

/* ---- weights -------------------------------------------------------------------------------- */

/* limb[] = |a b - c d| for factors below 2^41 + 2^32. a and c are taken apart at bit 21, so that
 * the difference is high * 2^21 + low with |high| < 2^62 + 2^55, low below 2^21. */
static void set_weight(uint16_t limb[CORNER_LIMBS], int64_t a, int64_t b, int64_t c, int64_t d)
{
    const int64_t ab = (a & LOW_MASK) * b, cd = (c & LOW_MASK) * d; /* below 2^62 + 2^53 */
    int32_t low = (int32_t)(ab & LOW_MASK) - (int32_t)(cd & LOW_MASK);
    int64_t high = (a >> LOW_BITS) * b - (c >> LOW_BITS) * d + (ab >> LOW_BITS) - (cd >> LOW_BITS) -
                   (low < 0);

    low &= LOW_MASK;
    if (high < 0) {
        high = -high - (low != 0);
        low = low != 0 ? LOW_MASK + 1 - low : 0;
    }
    limb[0] = (uint16_t)(low & LIMB_MASK);
    limb[1] = (uint16_t)(low >> LIMB_BITS | (int32_t)(high & 0x1FF) << 6);
    high >>= 9;
    for (int i = 2; i < CORNER_LIMBS; i++, high >>= LIMB_BITS)
        limb[i] = (uint16_t)(high & LIMB_MASK);
}

/* The cross product of the lines. Where they meet inside the triangle its three numbers have one
 * sign, so magnitudes will do. */
void etch_corner_meet(struct corner_weights *weights, const struct corner_line *a,
                      const struct corner_line *b)
{
    const int64_t *const p = a->at, *const q = b->at;

    set_weight(weights->weight[0], p[1], q[2], p[2], q[1]);
    set_weight(weights->weight[1], p[2], q[0], p[0], q[2]);
    set_weight(weights->weight[2], p[0], q[1], p[1], q[0]);
}

/* ---- weighted sums --------------------------------------------------------------------------- */

/* high * 2^75 + limbs 4 .. 0, each 15 bits. */
struct sum {
    int64_t high;
    uint16_t limb[CORNER_LIMBS - 1];
};

/* The sum of weight i times v[i], |v[i]| < 2^42. */
static void weigh(struct sum *sum, const struct corner_weights *c, const int64_t v[3])
{
    int64_t carry = 0; /* below 3 * 2^57 + 2^45 */

    for (int at = 0; at < CORNER_LIMBS; at++) {
        for (int i = 0; i < 3; i++)
            carry += c->weight[i][at] * v[i];
        if (at < CORNER_LIMBS - 1) {
            sum->limb[at] = (uint16_t)(carry & LIMB_MASK);
            carry >>= LIMB_BITS;
        }
    }
    sum->high = carry;
}

bool etch_corner_is_inside(const struct corner_weights *weights, const struct corner_line *line)
{
    struct sum distance;

    weigh(&distance, weights, line->at);
    return distance.high >= 0;
}

/* v[i] = sums[i] * a common power of two, rounded, the largest of 31 bits (or all of the sums,
 * where they have fewer). |high| < 2^46 for coordinates. */
static void round_sums(int32_t v[4], struct sum sums[4])
{
    uint64_t largest = 0;
    uint8_t down = 0;

    for (int i = 0; i < 4; i++)
        largest |= size(sums[i].high);
    for (int at = CORNER_LIMBS - 2; at >= 0 && largest < UINT64_C(1) << 31; at--) {
        for (int i = 0; i < 4; i++) {
            sums[i].high = sums[i].high * LIMB + sums[i].limb[at];
            largest |= size(sums[i].high);
        }
    }
    for (; largest >> down >= UINT64_C(1) << 31; down++)
        ;
    for (int i = 0; i < 4; i++)
        v[i] = etch_saturate_s32((sums[i].high + ((INT64_C(1) << down) >> 1)) >> down);
}

/* The leading bits of the weights and their sum, below 2^23: enough for 8-bit attributes. */
static void leading_weights(uint32_t leading[4], const struct corner_weights *c)
{
    uint64_t w[3] = {0, 0, 0};
    uint8_t down = 0;

    for (int at = CORNER_LIMBS - 1; at >= 0 && w[0] + w[1] + w[2] < UINT64_C(1) << 22; at--)
        for (int i = 0; i < 3; i++)
            w[i] = w[i] << LIMB_BITS | c->weight[i][at];
    for (; (w[0] + w[1] + w[2]) >> down >= UINT64_C(1) << 23; down++)
        ;
    for (int i = 0; i < 3; i++)
        leading[i] = (uint32_t)(w[i] >> down);
    leading[3] = leading[0] + leading[1] + leading[2];
}

/* One coordinate of the corner from those of the vertices. */
static void coordinate(struct sum *sum, const struct corner_weights *corner, etch_q16 a, etch_q16 b,
                       etch_q16 c)
{
    const int64_t v[3] = {a, b, c};

    weigh(sum, corner, v);
}

/* One channel, k[3] being the sum of the leading weights. It is never 0: the lines meet. */
static uint8_t channel(const uint32_t k[4], uint8_t a, uint8_t b, uint8_t c)
{
    return (uint8_t)((k[0] * a + k[1] * b + k[2] * c + k[3] / 2) / k[3]);
}

void etch_corner_resolve(struct etch_clip_vertex *out, const struct corner_weights *weights,
                         const struct etch_clip_vertex *const v[3])
{
    const struct etch_clip_vertex *const a = v[0], *const b = v[1], *const c = v[2];
    struct sum sums[4];
    int32_t at[4];
    uint32_t k[4];

    coordinate(&sums[0], weights, a->x, b->x, c->x);
    coordinate(&sums[1], weights, a->y, b->y, c->y);
    coordinate(&sums[2], weights, a->z, b->z, c->z);
    coordinate(&sums[3], weights, a->w, b->w, c->w);
    round_sums(at, sums);
    out->x = at[0];
    out->y = at[1];
    out->z = at[2];
    out->w = at[3];

    leading_weights(k, weights);
    out->r = channel(k, a->r, b->r, c->r);
    out->g = channel(k, a->g, b->g, c->g);
    out->b = channel(k, a->b, b->b, c->b);
    out->a = channel(k, a->a, b->a, c->a);
}
