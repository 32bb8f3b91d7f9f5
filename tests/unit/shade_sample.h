/* tests/unit: points under a lamp, in numbers of core and in real ones, for shade_real.c. */
#ifndef TESTS_UNIT_SHADE_SAMPLE_H
#define TESTS_UNIT_SHADE_SAMPLE_H

#include "core/base/unit.h"
#include "core/vertex/lamp.h"
#include "tests/harness/harness.h"

struct real {
    double v[3];
};

/* ---- real numbers ------------------------------------------------------------------------------
 */

static inline double root(double v)
{
    double r = v > 1 ? v : 1;

    for (int i = 0; i < 80; i++)
        r = (r + v / r) / 2;
    return r;
}

static inline double power(double x, int n)
{
    double p = 1;

    while (n-- > 0)
        p *= x;
    return p;
}

static inline double dot(const struct real *a, const struct real *b)
{
    return a->v[0] * b->v[0] + a->v[1] * b->v[1] + a->v[2] * b->v[2];
}

/* Makes v a unit vector; returns its length. */
static inline double normalize(struct real *v)
{
    const double length = root(dot(v, v));

    for (int k = 0; k < 3; k++)
        v->v[k] /= length;
    return length;
}

static inline double least(double a, double b)
{
    return a < b ? a : b;
}

static inline struct real away(const struct etch_vector *to, const etch_q16 from[3])
{
    const struct real v = {{(to->x - (double)from[0]) / 65536, (to->y - (double)from[1]) / 65536,
                            (to->z - (double)from[2]) / 65536}};

    return v;
}

/* ---- samples -----------------------------------------------------------------------------------
 */

struct sample {
    struct etch_lamp lamp;
    struct etch_vector towards; /* of a directional lamp */
    struct etch_material material;
    struct etch_lamps lamps;
    struct etch_shade_point point;
    struct real normal;
    uint8_t color[3];
};

static inline void random_colors(uint8_t color[3], uint32_t *seed)
{
    for (int k = 0; k < 3; k++)
        color[k] = (uint8_t)(test_range(seed, 0, 3) == 0 ? 255 : test_range(seed, 0, 255));
}

/* A place 1/2 .. 40 units from the point, towards where its normal is, more or less. */
static inline void random_place(struct etch_vector *place, const struct sample *s, uint32_t *seed)
{
    const int32_t size = test_range(seed, 1, 40) * 32768;
    etch_q16 *const at[3] = {&place->x, &place->y, &place->z};

    for (int k = 0; k < 3; k++) {
        const double side = s->normal.v[k] + test_range(seed, -1000, 1000) / 900.0;

        *at[k] = s->point.position[k] + (etch_q16)(side * size);
    }
}

static inline void random_normal(struct sample *s, uint32_t *seed)
{
    int32_t v[3];

    do
        for (int k = 0; k < 3; k++) {
            v[k] = test_range(seed, -1000000, 1000000);
            s->normal.v[k] = v[k];
            s->point.position[k] = test_range(seed, -1000000, 1000000);
        }
    while (dot(&s->normal, &s->normal) < 1e8);
    (void)normalize(&s->normal);
    (void)etch_unit_q14(s->point.normal, v);
}

static inline void make_sample(struct sample *s, uint32_t *seed)
{
    static etch_lamp_function *const kinds[] = {etch_lamp_directional, etch_lamp_point,
                                                etch_lamp_attenuated};

    *s = (struct sample){.lamp = {.kind = kinds[test_range(seed, 0, 2)]}};
    random_normal(s, seed);
    random_place(&s->lamp.place, s, seed);
    random_place(&s->lamps.eye, s, seed);
    if (s->lamp.kind == etch_lamp_directional) {
        const struct real way = away(&s->lamp.place, s->point.position);

        s->towards = (struct etch_vector){(etch_q16)(way.v[0] * 65536),
                                          (etch_q16)(way.v[1] * 65536),
                                          (etch_q16)(way.v[2] * 65536)};
        (void)etch_lamp_aim(&s->lamp, &s->towards);
    }
    s->lamp.constant = test_range(seed, 0, 65536 * 2);
    s->lamp.linear = test_range(seed, 0, 65536) >> test_range(seed, 0, 8);
    s->lamp.quadratic = test_range(seed, 0, 65536) >> test_range(seed, 0, 12);
    random_colors(s->lamp.diffuse, seed);
    random_colors(s->lamp.specular, seed);
    random_colors(s->material.ambient, seed);
    random_colors(s->material.diffuse, seed);
    random_colors(s->material.specular, seed);
    for (int k = 0; k < 3; k++) {
        s->material.emission[k] = (uint8_t)test_range(seed, 0, 40);
        s->lamps.ambient[k] = (uint8_t)test_range(seed, 0, 80);
    }
    s->material.shininess = (uint8_t)(test_range(seed, 0, 255) >> test_range(seed, 0, 7));
    random_colors(s->color, seed);
    s->lamps.count = 1;
    s->lamps.lamp = &s->lamp;
    s->lamps.material = &s->material;
}

#endif
