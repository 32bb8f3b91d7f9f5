/* tests/oracle: two-word integers, schoolbook. See wide.h. */
#include "wide.h"

static uint64_t add_wrap(uint64_t a, uint64_t b)
{
    return a + b;
}

static uint64_t sub_wrap(uint64_t a, uint64_t b)
{
    return a - b;
}

struct wide wide_sum(struct wide a, struct wide b)
{
    const uint64_t lo = add_wrap(a.lo, b.lo);
    const struct wide r = {a.hi + b.hi + (lo < a.lo ? 1 : 0), lo};

    return r;
}

bool wide_at_most(struct wide a, struct wide b)
{
    return a.hi < b.hi || (a.hi == b.hi && a.lo <= b.lo);
}

struct wide wide_distance(struct wide a, struct wide b)
{
    const struct wide less = wide_at_most(a, b) ? a : b;
    const struct wide more = wide_at_most(a, b) ? b : a;
    const struct wide r = {more.hi - less.hi - (more.lo < less.lo ? 1 : 0),
                           sub_wrap(more.lo, less.lo)};

    return r;
}

/* a * 2^32 */
static struct wide up32(uint64_t a)
{
    const struct wide r = {a >> 32, (a & UINT32_MAX) << 32};

    return r;
}

struct wide wide_product(uint64_t a, uint64_t b)
{
    const uint64_t a0 = a & UINT32_MAX, a1 = a >> 32, b0 = b & UINT32_MAX, b1 = b >> 32;
    const struct wide ends = {a1 * b1, a0 * b0};

    return wide_sum(wide_sum(ends, up32(a1 * b0)), up32(a0 * b1));
}

struct wide wide_scale(struct wide a, uint32_t k)
{
    const struct wide low = wide_product(a.lo, k);
    const struct wide r = {a.hi * k + low.hi, low.lo};

    return r;
}
