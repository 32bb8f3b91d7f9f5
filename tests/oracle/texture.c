/* tests/oracle: texture coordinates as quotients of two-word integers. See texture.h. */
#include "texture.h"

#include <stddef.h>

uint64_t oracle_quotient(struct wide n, struct wide d)
{
    struct wide rest = {0, 0};
    uint64_t q = 0;
    int i;

    for (i = 127; i >= 0; i--) { /* long division; rest < d before and after */
        const uint64_t bit = (i >= 64 ? n.hi >> (i - 64) : n.lo >> i) & 1;

        rest.hi = rest.hi << 1 | rest.lo >> 63;
        rest.lo = (rest.lo & UINT64_MAX >> 1) << 1 | bit;
        q = (q & UINT64_MAX >> 1) << 1;
        if (wide_at_most(d, rest)) {
            rest = wide_distance(rest, d);
            q |= 1;
        }
    }
    return q;
}

/* Weights of either sign: the positive and the negative ones are summed apart. */
struct sum {
    struct wide more, less;
};

static void add(struct sum *s, int64_t weight, struct wide value)
{
    const uint64_t size = (uint64_t)(weight < 0 ? -weight : weight);
    struct wide *const part = weight < 0 ? &s->less : &s->more;
    struct wide product = wide_product(size, value.lo);

    product.hi += size * value.hi;
    *part = wide_sum(*part, product);
}

uint64_t oracle_texture(const struct oracle_triangle *t, int32_t x, int32_t y, const int32_t c[3],
                        const uint32_t w[3], uint8_t bits)
{
    struct sum n = {{0, 0}, {0, 0}}, d = {{0, 0}, {0, 0}};
    int i;

    for (i = 0; i < 3; i++) {
        const int64_t e = oracle_triangle_edge(t, i, x, y);
        const uint8_t k = t->from[i], a = (uint8_t)((k + 1) % 3), b = (uint8_t)((k + 2) % 3);
        /* 1/w, all three times the product of all w */
        const uint64_t inverse = w == NULL ? 1 : (uint64_t)w[a] * w[b];
        const uint64_t biased = (uint64_t)((int64_t)c[k] + (INT64_C(1) << 31));
        const struct wide one = {0, inverse};

        add(&n, e, wide_scale(wide_product(biased, inverse), UINT32_C(1) << bits));
        add(&d, e, one);
    }
    return oracle_quotient(wide_distance(n.more, n.less), wide_distance(d.more, d.less));
}
