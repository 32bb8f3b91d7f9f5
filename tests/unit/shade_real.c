/* tests/unit: lamps against the formula of lamp.h in real numbers: directions, distances and
 * attenuation from where things are, not from what core makes of it (that is shade.c). Ambient,
 * emission, diffuse, Phong, Blinn; directional, point and attenuated lamps; and where light stops
 * to add up.
 *
 * The bound follows from what lamp.h states. With u = 2^-14 a unit vector in 2.14 is within 2
 * sqrt(3) u, below 3.5 u, of the real one, and a way of length d that is kept in 15 fraction bits
 * turns by less than sqrt(3) 2^-15 / d more. A product of two unit vectors errs by the sum of both,
 * R . V by twice two products and one more, H by the error of L and V over the length of L + V. A
 * power n of x that errs by e errs by less than n e (x + e)^(n - 1). Then lamp.h's own 1/2 + 1/32,
 * 1/16 and 1/8 times F, and 2^-12 F + 2^-15 of F. */
#include "tests/unit/shade_sample.h"

void suite_shade_real(void);

enum model {
    DIFFUSE,
    PHONG,
    BLINN
};

#define U (1.0 / 16384)
#define UNIT_ERROR (3.5 * U)

/* A value and how much it may err. */
struct about {
    double value, error;
};

/* ---- the formula -------------------------------------------------------------------------------
 */

/* L and F. */
static struct about lamp_at(const struct sample *s, struct real *towards, double *turn)
{
    struct about f = {1, 0};
    double d;

    *towards = away(&s->lamp.place, s->point.position);
    if (s->lamp.kind == etch_lamp_directional)
        *towards = (struct real){{s->towards.x, s->towards.y, s->towards.z}};
    d = normalize(towards);
    *turn = UNIT_ERROR + (s->lamp.kind == etch_lamp_directional ? 0 : 1.8 / 32768 / d);
    if (s->lamp.kind == etch_lamp_attenuated) {
        const double divisor = (s->lamp.constant + (s->lamp.linear + s->lamp.quadratic * d) * d) /
                               65536;

        f.value = divisor > 0.25 ? 1 / divisor : 4;
        f.error = f.value / 4096 + 1.0 / 32768;
    }
    return f;
}

/* The cosine of the highlight. */
static struct about highlight(enum model model, const struct sample *s, const struct real *towards,
                              double turn)
{
    struct real view = away(&s->lamps.eye, s->point.position), half;
    const double view_turn = UNIT_ERROR + 1.8 / 32768 / normalize(&view);
    const double n_l = dot(&s->normal, towards), n_v = dot(&s->normal, &view);

    if (model == PHONG) {
        const struct about r_v = {2 * n_l * n_v - dot(towards, &view),
                                  2 * (UNIT_ERROR + turn) + 2 * (UNIT_ERROR + view_turn) + turn +
                                      view_turn + U};
        return r_v;
    }
    for (int k = 0; k < 3; k++)
        half.v[k] = towards->v[k] + view.v[k];

    const double length = normalize(&half);
    const struct about n_h = {dot(&s->normal, &half),
                              2 * UNIT_ERROR + 2 * (turn + view_turn) / length};

    return n_h;
}

/* The channel, held to 255, and what it may err by. */
static struct about channel(enum model model, const struct sample *s, int k)
{
    const struct etch_material *m = &s->material;
    struct real towards;
    double turn;
    const struct about f = lamp_at(s, &towards, &turn);
    const double n_l = dot(&s->normal, &towards), surface = m->diffuse[k] * s->color[k] / 255.0;
    struct about c = {m->emission[k] +
                          s->lamps.ambient[k] / 255.0 * m->ambient[k] / 255 * s->color[k],
                      0.5 + 1.0 / 32};

    if (n_l > 0) {
        const double d = s->lamp.diffuse[k] / 255.0 * surface;

        c.value += f.value * n_l * d;
        c.error += d * (f.value * (UNIT_ERROR + turn) + f.error) + (1 + f.value) / 16;
    }
    if (n_l > 0 && model != DIFFUSE) {
        const struct about x = highlight(model, s, &towards, turn);
        const double most = least(1, x.value + x.error), n = m->shininess;
        const double by = s->lamp.specular[k] / 255.0 * m->specular[k];
        const double p = x.value > 0 ? power(least(1, x.value), m->shininess) : 0;

        c.value += f.value * by * p;
        if (most > 0)
            c.error += by * (f.value * n * x.error * power(most, n > 0 ? m->shininess - 1 : 0) +
                             f.error) +
                       (1 + f.value) / 8;
    }
    c.value = least(c.value, 255);
    return c;
}

/* Light or none is decided by less than what it errs by, where a power of 0 is 1. */
static bool is_doubtful(enum model model, const struct sample *s)
{
    struct real towards;
    double turn;
    struct about x;

    (void)lamp_at(s, &towards, &turn);
    x = highlight(model, s, &towards, turn);
    if (dot(&s->normal, &towards) < 2 * turn && dot(&s->normal, &towards) > -2 * turn)
        return true;
    return model != DIFFUSE && s->material.shininess == 0 && x.value < x.error &&
           x.value > -x.error;
}

static void compare(enum model model, etch_shade_function *shade, uint32_t seed)
{
    double worst = 0, tightest = 1e9;
    int32_t compared = 0;

    for (int32_t n = 0; n < TEST_COUNT(6000) && !test_failed(); n++) {
        struct sample s;
        uint8_t rgb[3];

        make_sample(&s, &seed);
        for (int k = 0; k < 3; k++)
            rgb[k] = s.color[k];
        shade(&s.lamps, &s.point, rgb);
        if (is_doubtful(model, &s))
            continue;
        for (int k = 0; k < 3; k++) {
            const struct about c = channel(model, &s, k);
            const double error = rgb[k] > c.value ? rgb[k] - c.value : c.value - rgb[k];

            worst = error > worst && s.material.shininess <= 32 ? error : worst;
            tightest = least(tightest, c.error);
            compared++;
            if (!CHECK(error <= c.error)) {
                test_note("n", n);
                test_note("got", rgb[k]);
                test_note("exact / 1000", (int64_t)(c.value * 1000));
                test_note("bound / 1000", (int64_t)(c.error * 1000));
            }
        }
    }
    CHECK(compared > TEST_COUNT(6000) * 2);
    CHECK(tightest < 0.6);
    test_print_count("", (int32_t)(worst * 1000),
                     " thousandths of a step at worst, up to shininess 32");
}

static void diffuse_light(void)
{
    compare(DIFFUSE, etch_shade_diffuse, 11);
}

static void phong_light(void)
{
    compare(PHONG, etch_shade_phong, 12);
}

static void blinn_light(void)
{
    compare(BLINN, etch_shade_blinn, 13);
}

/* Lamps at no distance give 4 each; two or any number of them 8, of diffuse and of specular light.
 */
static void light_adds_up_to_8(void)
{
    static const uint8_t counts[] = {1, 2, 3, 17, 255};
    static struct etch_lamp lamp[255];
    struct etch_material material;
    const struct etch_shade_point point = {{0, 0, 16384}, {0, 0, 0}};

    for (int i = 0; i < 255; i++)
        lamp[i] = (struct etch_lamp){.kind = etch_lamp_attenuated,
                                     .place = {0, 0, 65536},
                                     .diffuse = {255, 255, 0},
                                     .specular = {0, 255, 255}};
    etch_material_init(&material);
    material.shininess = 1;
    for (size_t i = 0; i < sizeof counts; i++) {
        struct etch_lamps lamps = {.count = counts[i], .lamp = lamp, .material = &material};
        const uint8_t most = counts[i] == 1 ? 4 : 8;
        uint8_t rgb[3] = {10, 1, 30};

        material.specular[1] = 2, material.specular[2] = 20;
        lamps.eye = (struct etch_vector){0, 0, 65536};
        etch_shade_phong(&lamps, &point, rgb);
        CHECK_EQ(rgb[0], 10 * most);
        CHECK_EQ(rgb[1], 3 * most);
        CHECK_EQ(rgb[2], 20 * most);
    }
}

void suite_shade_real(void)
{
    RUN(diffuse_light);
    RUN(phong_light);
    RUN(blinn_light);
    RUN(light_adds_up_to_8);
}
