/* tests/unit: vertices in clip space, shared by the suites of clippers. */
#ifndef TESTS_UNIT_CLIP_PARTS_H
#define TESTS_UNIT_CLIP_PARTS_H

#include "core/vertex/transform.h"
#include "tests/harness/harness.h"

/* kind 0: anything; 1: small numbers; 2: ends and units; 3: a usual scene; 4: any size. */
static inline int32_t clip_coordinate(int kind, uint32_t *seed)
{
    static const int32_t ends[] = {INT32_MIN, INT32_MAX, -INT32_MAX, 0, 1, -1, 65536, -65536};
    const int32_t any = (int32_t)test_random(seed);

    switch (kind) {
    case 0: return any;
    case 1: return test_range(seed, -8, 8);
    case 2: return ends[test_range(seed, 0, 7)];
    case 3: return test_range(seed, -(INT32_C(1) << 18), INT32_C(1) << 18);
    default: return any >> test_range(seed, 0, 31);
    }
}

static inline void random_vertex(struct etch_clip_vertex *v, int kind, uint32_t *seed)
{
    const uint32_t color = test_random(seed);

    v->x = clip_coordinate(kind, seed);
    v->y = clip_coordinate(kind, seed);
    v->z = clip_coordinate(kind, seed);
    v->w = clip_coordinate(kind, seed);
    if (v->w < 0 && v->w > INT32_MIN && test_range(seed, 0, 2) != 0)
        v->w = -v->w;
    v->r = (uint8_t)color;
    v->g = (uint8_t)(color >> 8);
    v->b = (uint8_t)(color >> 16);
    v->a = (uint8_t)(color >> 24);
}

static inline bool same_vertex(const struct etch_clip_vertex *a, const struct etch_clip_vertex *b)
{
    return a->x == b->x && a->y == b->y && a->z == b->z && a->w == b->w && a->r == b->r &&
           a->g == b->g && a->b == b->b && a->a == b->a;
}

#endif
