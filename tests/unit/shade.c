/* tests/unit: the light of lamps on materials, against the formula of lamp.h in 60-bit fractions.
 */
#include "core/vertex/lamp.h"
#include "core/base/unit.h"
#include "tests/harness/harness.h"
#include "tests/oracle/wide.h"

void suite_shade(void);

#define LAMPS 3

/* a b in 1.60, both 0 .. 1. */
static uint64_t mul_q60(uint64_t a, uint64_t b)
{
    const struct wide p = wide_product(a, b);

    return p.hi << 4 | p.lo >> 60;
}

static uint64_t power_q60(int64_t x_q56, int n)
{
    const uint64_t one = UINT64_C(1) << 60;
    const uint64_t x = x_q56 >= INT64_C(1) << 56 ? one : (uint64_t)x_q56 << 4;
    uint64_t power = one;

    while (n-- > 0)
        power = mul_q60(power, x);
    return power;
}

static int64_t dot(const int16_t a[3], const int16_t b[3])
{
    return (int64_t)a[0] * b[0] + (int64_t)a[1] * b[1] + (int64_t)a[2] * b[2];
}

enum model {
    DIFFUSE,
    PHONG,
    BLINN
};

/* The cosine of the highlight in .56, from the vectors as they are. */
static int64_t highlight_q56(enum model model, const int16_t normal[3], const int16_t towards[3],
                             const int16_t view[3])
{
    const int32_t sum[3] = {towards[0] + view[0], towards[1] + view[1], towards[2] + view[2]};
    int16_t half[3];

    if (model == PHONG)
        return 2 * dot(normal, towards) * dot(normal, view) - dot(towards, view) * (1 << 28);
    (void)etch_unit_q14(half, sum);
    return dot(normal, half) * (1 << 28);
}

/* One channel times 65025 in 32 fraction bits. */
static int64_t exact_q32(enum model model, const struct etch_lamps *lamps,
                         const struct etch_shade_point *p, const int16_t view[3], uint8_t color,
                         int k)
{
    const struct etch_material *m = lamps->material;
    int64_t diffuse = (int64_t)lamps->ambient[k] * m->ambient[k] * color * (INT64_C(1) << 32);
    int64_t specular = 0;

    for (int i = 0; i < lamps->count; i++) {
        const struct etch_lamp *lamp = &lamps->lamp[i];
        struct etch_incidence in;
        int64_t n_l, cosine;

        lamp->kind(lamp, p->position, &in);
        n_l = dot(p->normal, in.towards);
        if (n_l <= 0)
            continue;
        diffuse += (n_l * in.intensity_q16 >> 12) * lamp->diffuse[k] * m->diffuse[k] * color;
        cosine = highlight_q56(model, p->normal, in.towards, view);
        if (model != DIFFUSE && cosine > 0)
            specular += ((int64_t)(power_q60(cosine, m->shininess) >> 30) * in.intensity_q16 >>
                         14) *
                        lamp->specular[k] * m->specular[k];
    }
    return diffuse + specular * 255 + (int64_t)m->emission[k] * 65025 * (INT64_C(1) << 32);
}

static void random_colors(uint8_t color[3], uint32_t *seed)
{
    for (int k = 0; k < 3; k++)
        color[k] = (uint8_t)test_range(seed, 0, 255);
}

/* A direction that is often near `like`. */
static void random_unit(int16_t unit[3], const int16_t like[3], uint32_t *seed)
{
    const int32_t near = test_range(seed, 0, 2) * 20000;
    int32_t v[3];

    for (int k = 0; k < 3; k++)
        v[k] = test_range(seed, -16384, 16384) + (like[k] >> 2) * (near >> 12);
    (void)etch_unit_q14(unit, v);
}

static void random_lamps(struct etch_lamps *lamps, struct etch_lamp lamp[LAMPS],
                         struct etch_material *material, const struct etch_shade_point *p,
                         uint32_t *seed)
{
    lamps->count = (uint8_t)test_range(seed, 0, LAMPS);
    lamps->lamp = lamp;
    lamps->material = material;
    random_colors(lamps->ambient, seed);
    for (int i = 0; i < LAMPS; i++) {
        int16_t unit[3];

        random_unit(unit, p->normal, seed);
        lamp[i] = (struct etch_lamp){.kind = etch_lamp_directional,
                                     .place = {unit[0], unit[1], unit[2]}};
        random_colors(lamp[i].diffuse, seed);
        random_colors(lamp[i].specular, seed);
        if (test_range(seed, 0, 1) == 0) {
            lamp[i].kind = test_range(seed, 0, 1) == 0 ? etch_lamp_point : etch_lamp_attenuated;
            lamp[i].place.x = p->position[0] + unit[0] * 16;
            lamp[i].place.y = p->position[1] + unit[1] * 16;
            lamp[i].place.z = p->position[2] + unit[2] * 16;
            lamp[i].constant = test_range(seed, 0, 65536);
            lamp[i].linear = test_range(seed, 0, 65536) / 8;
            lamp[i].quadratic = test_range(seed, 0, 65536) / 64;
        }
    }
    random_colors(material->ambient, seed);
    random_colors(material->diffuse, seed);
    random_colors(material->specular, seed);
    random_colors(material->emission, seed);
    for (int k = 0; k < 3; k++)
        material->emission[k] /= 8;
    material->shininess = (uint8_t)(test_random(seed) >> test_range(seed, 24, 31));
}

static void compare(enum model model, etch_shade_function *shade, uint32_t seed)
{
    int32_t inside = 0;

    for (int32_t n = 0; n < TEST_COUNT(30000) && !test_failed(); n++) {
        static const int16_t none[3] = {0, 0, 0};
        struct etch_material material;
        struct etch_lamp lamp[LAMPS];
        struct etch_lamps lamps = {.eye_is_far = true};
        struct etch_shade_point p;
        uint8_t color[3], rgb[3];
        int16_t view[3];
        int64_t most = 0;

        for (int k = 0; k < 3; k++)
            p.position[k] = test_range(&seed, -1000000, 1000000);
        random_unit(p.normal, none, &seed);
        random_unit(view, p.normal, &seed);
        lamps.eye = (struct etch_vector){view[0], view[1], view[2]};
        random_lamps(&lamps, lamp, &material, &p, &seed);
        random_colors(color, &seed);
        for (int k = 0; k < 3; k++)
            rgb[k] = color[k];
        shade(&lamps, &p, rgb);
        /* 1/2 + 1/32, and for each lamp 1/16 (1/8 where F is above 1), with specular light twice */
        most = 34;
        for (int i = 0; i < lamps.count; i++) {
            struct etch_incidence in;

            lamp[i].kind(&lamp[i], p.position, &in);
            most += (in.intensity_q16 > 65536 ? 8 : 4) * (model == DIFFUSE ? 1 : 2);
        }
        for (int k = 0; k < 3; k++) {
            const int64_t exact = exact_q32(model, &lamps, &p, view, color[k], k);
            const int64_t full = INT64_C(255) * 65025 * (INT64_C(1) << 32);
            const int64_t error = rgb[k] * INT64_C(65025) * (INT64_C(1) << 32) -
                                  (exact < full ? exact : full);

            CHECK((error < 0 ? -error : error) / 1016 <= most * (INT64_C(1) << 32));
            inside += exact < full;
        }
        if (test_failed())
            test_note("n", n);
    }
    test_print_count("", inside, " channels below 255, each within its bound");
}

static void diffuse_light(void)
{
    compare(DIFFUSE, etch_shade_diffuse, 1);
}

static void phong_light(void)
{
    compare(PHONG, etch_shade_phong, 2);
}

static void blinn_light(void)
{
    compare(BLINN, etch_shade_blinn, 3);
}

/* Distances that are whole numbers: 1 / (constant + linear d + quadratic d^2) within 2^-12 of it
 * and 2^-15, at most 4. */
static void light_becomes_less_with_distance(void)
{
    uint32_t seed = 4;

    for (int32_t n = 0; n < TEST_COUNT(20000) && !test_failed(); n++) {
        static const uint8_t legs[][4] = {{1, 0, 0, 1}, {3, 4, 0, 5}, {2, 3, 6, 7}, {4, 4, 7, 9}};
        const uint8_t *leg = legs[n % 4];
        const int32_t unit = test_range(&seed, 1, 1 << test_range(&seed, 1, 20));
        const etch_q16 position[3] = {-1000, 1000, n};
        const struct etch_lamp lamp = {
            .kind = etch_lamp_attenuated,
            .place = {leg[0] * unit - 1000, leg[1] * unit + 1000, leg[2] * unit + n},
            .constant = test_range(&seed, 0, 1 << test_range(&seed, 0, 17)),
            .linear = test_range(&seed, 0, 1 << test_range(&seed, 0, 17)),
            .quadratic = test_range(&seed, 0, 1 << test_range(&seed, 0, 17))};
        const int64_t d = (int64_t)leg[3] * unit; /* below 2^24 */
        /* F = 2^48 / divisor, in .16 2^64 / divisor / 2^.. ; the divisor below 2^58 */
        const uint64_t divisor = (uint64_t)lamp.constant * 65536 +
                                 (uint64_t)lamp.linear * (uint64_t)d +
                                 ((uint64_t)(d * d >> 8) * (uint64_t)lamp.quadratic >> 8);
        struct etch_incidence in;
        uint64_t f_q24; /* F in .24, below 2^28, within a unit */

        lamp.kind(&lamp, position, &in);
        CHECK(in.intensity_q16 <= 1 << 18);
        if (divisor < UINT64_C(1) << 30) { /* F above 4 */
            CHECK(in.intensity_q16 >= (1 << 18) - (1 << 8));
            continue;
        }
        f_q24 = (UINT64_C(1) << 56) / divisor;

        const int64_t error = (int64_t)in.intensity_q16 * 256 - (int64_t)f_q24;
        const int64_t most = (int64_t)(f_q24 >> 12) + (1 << 9) + 2;

        if (!CHECK((error < 0 ? -error : error) <= most)) {
            test_note("distance", d);
            test_note("constant", lamp.constant);
            test_note("linear", lamp.linear);
            test_note("quadratic", lamp.quadratic);
            test_note("got", in.intensity_q16);
            test_note("exact", (int64_t)f_q24 / 256);
        }
    }
}

static void aim_is_a_unit_vector(void)
{
    const struct etch_vector none = {0, 0, 0}, along = {0, -3, 4};
    struct etch_lamp lamp = {.constant = 77};

    CHECK_EQ(etch_lamp_aim(&lamp, &none), ETCH_EINVAL);
    CHECK(lamp.kind == NULL);
    CHECK_EQ(etch_lamp_aim(&lamp, &along), ETCH_OK);
    CHECK(lamp.kind == etch_lamp_directional);
    CHECK_EQ(lamp.place.x, 0);
    CHECK_EQ(lamp.place.y, -9830);
    CHECK_EQ(lamp.place.z, 13107);
}

/* The eye at a place sees what a far eye in that direction sees. */
static void near_eye_has_a_direction(void)
{
    struct etch_material material;
    struct etch_lamp lamp = {.diffuse = {10, 20, 30}, .specular = {255, 200, 100}};
    const struct etch_vector up = {3000, 65536, 100};
    struct etch_lamps near = {.count = 1, .lamp = &lamp, .material = &material};
    struct etch_lamps far = near;
    const struct etch_shade_point p = {{0, 16384, 0}, {65536, 2 * 65536, -65536}};
    uint8_t a[3] = {255, 255, 255}, b[3] = {255, 255, 255};

    etch_material_init(&material);
    material.specular[0] = material.specular[1] = material.specular[2] = 255;
    material.shininess = 4;
    CHECK_EQ(etch_lamp_aim(&lamp, &up), ETCH_OK);
    near.eye = (struct etch_vector){65536 + 3 * 6553, 2 * 65536 + 4 * 6553, -65536};
    far.eye_is_far = true;
    far.eye = (struct etch_vector){9830, 13107, 0};
    etch_shade_phong(&near, &p, a);
    etch_shade_phong(&far, &p, b);
    for (int k = 0; k < 3; k++)
        CHECK_EQ(a[k], b[k]);
    CHECK(a[0] >= 99 && a[0] <= 101); /* 10 and 255 * 0.7717^4 */
}

void suite_shade(void)
{
    RUN(diffuse_light);
    RUN(phong_light);
    RUN(blinn_light);
    RUN(light_becomes_less_with_distance);
    RUN(aim_is_a_unit_vector);
    RUN(near_eye_has_a_direction);
}
