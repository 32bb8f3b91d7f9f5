/* vertex/corner_value.c: a varying at the corner of a clipped triangle, exactly. Called by
 * varying.c. See corner.h. */
#include "corner.h"

/* high * 2^60 + low, below 2^96: the weights have 90 bits, their sum 92 and remainders 94. */
struct wide {
    uint64_t high, low;
};

enum {
    LOW_BITS = 60,
    LOW_LIMBS = 4,
    LIMB_BITS = 15
};

static struct wide from_limbs(const uint16_t limb[CORNER_LIMBS])
{
    struct wide w = {(uint64_t)limb[5] << LIMB_BITS | limb[4], 0};

    for (uint8_t i = LOW_LIMBS; i > 0; i--)
        w.low = w.low << LIMB_BITS | limb[i - 1];
    return w;
}

static void add(struct wide *a, const struct wide *b)
{
    a->low += b->low;
    a->high += b->high + (a->low >> LOW_BITS);
    a->low &= (UINT64_C(1) << LOW_BITS) - 1;
}

/* Takes b off a if a is not less. */
static bool take(struct wide *a, const struct wide *b)
{
    const uint64_t borrow = a->low < b->low ? 1 : 0;

    if (a->high < b->high + borrow)
        return false;
    a->high -= b->high + borrow;
    a->low = a->low + (borrow << LOW_BITS) - b->low;
    return true;
}

/* Division of the sum of weight[i] * (value[i] - least) by the sum of the weights, a bit of all the
 * values at a time: the remainder stays below the divisor, so a step adds at most three of it. */
int64_t etch_corner_value(const struct corner_weights *weights, const int32_t value[3],
                          uint8_t fraction_bits)
{
    const int32_t least_two = value[0] < value[1] ? value[0] : value[1];
    const int32_t least = least_two < value[2] ? least_two : value[2];
    struct wide weight[3], all = {0, 0}, rest = {0, 0};
    uint64_t quotient = 0; /* below 2^63 */

    for (uint8_t i = 0; i < 3; i++) {
        weight[i] = from_limbs(weights->weight[i]);
        add(&all, &weight[i]);
    }
    for (int8_t bit = (int8_t)(31 + fraction_bits); bit >= 0; bit--) {
        struct wide same = rest;

        add(&rest, &same);
        quotient *= 2;
        for (uint8_t i = 0; bit >= fraction_bits && i < 3; i++)
            if (((uint32_t)((int64_t)value[i] - least) >> (bit - fraction_bits) & 1) != 0)
                add(&rest, &weight[i]);
        while (take(&rest, &all))
            quotient++;
    }
    const struct wide half = rest;

    add(&rest, &half);
    return (int64_t)quotient + (take(&rest, &all) ? 1 : 0) + least * (INT64_C(1) << fraction_bits);
}
