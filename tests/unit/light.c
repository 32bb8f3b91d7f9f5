/* tests/unit: diffuse light against its formula. */
#include "core/vertex/light.h"
#include "tests/harness/harness.h"

void suite_light(void);

static const struct etch_matrix *identity(struct etch_matrix *m)
{
    etch_matrix_identity(m);
    return m;
}

/* channel = min(255, color (ambient + sum diffuse max(0, N . L)) / 255), where a light's vector
 * of length 2^21 / 127 is L and a normal of length 127 is N: N . L = their product / 2^21. */
static bool is_lit(uint8_t got, uint8_t color, const struct etch_lighting *lighting, int channel,
                   const int8_t n[3])
{
    const int64_t one = INT64_C(255) << 21;
    int64_t sum = (int64_t)lighting->ambient[channel] << 21; /* channels in 2^-21 */
    int64_t most = one / 2 + one / 64;
    int i;

    for (i = 0; i < lighting->count; i++) {
        const struct etch_light *l = &lighting->light[i];
        const int64_t dot = (int64_t)l->x * n[0] + (int64_t)l->y * n[1] + (int64_t)l->z * n[2];

        sum += dot > 0 ? dot * l->diffuse[channel] : 0;
        most += one / 32;
    }
    const int64_t exact = color * sum < 255 * one ? color * sum : 255 * one;
    const int64_t error = got * one - exact;

    return error <= most && error >= -most;
}

static void random_light(struct etch_light *l, uint32_t *seed)
{
    struct etch_matrix m;
    struct etch_vector towards;
    int i;

    do {
        towards.x = test_range(seed, -1000, 1000);
        towards.y = test_range(seed, -1000, 1000);
        towards.z = test_range(seed, -1000, 1000);
    } while (etch_light_aim(l, identity(&m), &towards) != ETCH_OK);
    for (i = 0; i < 3; i++)
        l->diffuse[i] = (uint8_t)(test_random(seed) >> 11);
}

static void lit_colors_meet_the_bound(void)
{
    static const int8_t ends[] = {-128, -127, -1, 0, 1, 127};
    uint32_t seed = 1;
    int32_t n, i;

    for (n = 0; n < TEST_COUNT(100000); n++) {
        struct etch_light lights[4];
        struct etch_lighting lighting = {{0, 0, 0}, (uint8_t)test_range(&seed, 0, 4), lights};
        int8_t normal[3];
        uint8_t color[3], rgb[3];

        for (i = 0; i < lighting.count; i++)
            random_light(&lights[i], &seed);
        for (i = 0; i < 3; i++) {
            lighting.ambient[i] = (uint8_t)test_range(&seed, 0, n % 2 == 0 ? 40 : 255);
            normal[i] = n % 3 == 0 ? ends[test_range(&seed, 0, 5)]
                                   : (int8_t)test_range(&seed, -128, 127);
            color[i] = rgb[i] = (uint8_t)(n % 5 == 0 ? 255 : test_range(&seed, 0, 255));
        }
        etch_light_vertex(&lighting, normal, rgb);
        for (i = 0; i < 3; i++)
            CHECK(is_lit(rgb[i], color[i], &lighting, i, normal));
    }
}

/* Any number of lights at full strength, on a normal that is longer than 1, on every kind of
 * colour: sums pass 2^32 many times over and saturate instead of wrapping. */
static void many_lights_saturate(void)
{
    static const uint8_t colors[] = {0, 1, 2, 3, 127, 128, 200, 253, 254, 255};
    static const int8_t normals[][3] = {{127, 127, 127}, {-128, -128, -128}, {127, 0, 0}};
    static struct etch_light lights[255];
    int n, i, c;

    for (n = 0; n < 3; n++) {
        const int16_t to = normals[n][0] < 0 ? -9534 : 9534; /* (1, 1, 1) or its opposite */

        for (i = 0; i < 255; i++) {
            lights[i].x = lights[i].y = lights[i].z = to;
            lights[i].diffuse[0] = lights[i].diffuse[1] = 255;
            lights[i].diffuse[2] = (uint8_t)(n == 0 ? 255 : 254);
        }
        for (i = 0; i < 255 * 2; i++) {
            const uint8_t dark = (uint8_t)(i % 2 == 0 ? 0 : 255);
            const struct etch_lighting lighting = {
                {dark, dark, dark}, (uint8_t)(i / 2 + 1), lights};

            for (c = 0; c < (int)sizeof colors; c++) {
                uint8_t rgb[3] = {colors[c], colors[c], colors[c]};

                etch_light_vertex(&lighting, normals[n], rgb);
                CHECK(is_lit(rgb[0], colors[c], &lighting, 0, normals[n]));
                CHECK(is_lit(rgb[2], colors[c], &lighting, 2, normals[n]));
                CHECK_EQ(rgb[1], rgb[0]);
                if (n == 0 && i / 2 == 254) /* 441 times the colour */
                    CHECK_EQ(rgb[0], colors[c] == 0 ? 0 : 255);
            }
        }
    }
}

/* Light from the front, side and back of a normal, white on white. */
static void light_falls_by_the_cosine(void)
{
    static const struct etch_vector towards = {0, 0, 5};
    static const int8_t normals[][3] = {{0, 0, 127}, {112, 0, 60}, {127, 0, 0}, {0, 0, -127}};
    static const int expected[] = {255, 120, 0, 0}; /* 60 / 127 * 255 = 120.47 */
    struct etch_light light = {0, 0, 0, {255, 255, 255}};
    const struct etch_lighting lighting = {{0, 0, 0}, 1, &light};
    struct etch_matrix m;
    int i;

    CHECK_EQ(etch_light_aim(&light, identity(&m), &towards), ETCH_OK);
    CHECK_EQ(light.z, 16513);
    for (i = 0; i < 4; i++) {
        uint8_t rgb[3] = {255, 255, 255};

        etch_light_vertex(&lighting, normals[i], rgb);
        CHECK_EQ(rgb[0], expected[i]);
        CHECK_EQ(rgb[1], expected[i]);
        CHECK_EQ(rgb[2], expected[i]);
    }
}

/* The model turned by a matrix and the light brought back by it: N . L is that of the turned
 * normal, for turns, mirrors and uniform scales. */
static void aim_undoes_the_model(void)
{
    uint32_t seed = 5;
    int32_t n;

    for (n = 0; n < TEST_COUNT(20000); n++) {
        const etch_q16 size = (n % 3 == 0 ? -1 : 1) * (n % 2 == 0 ? 65536 : 12345 * 4);
        const struct etch_vector axis = {test_range(&seed, 1, 99), test_range(&seed, -99, 99),
                                         test_range(&seed, -99, 99)};
        const struct etch_vector towards = {test_range(&seed, -9999, 9999),
                                            test_range(&seed, 1, 9999),
                                            test_range(&seed, -9999, 9999)};
        struct etch_matrix model, scale, one;
        struct etch_light local = {0, 0, 0, {0, 0, 0}}, world = local;
        int i;

        etch_matrix_scale(&scale, size, size, size);
        CHECK_EQ(etch_matrix_rotate(&model, (uint16_t)test_random(&seed), &axis), ETCH_OK);
        CHECK_EQ(etch_matrix_multiply(&model, &scale, &model), ETCH_OK);
        CHECK_EQ(etch_light_aim(&local, &model, &towards), ETCH_OK);
        CHECK_EQ(etch_light_aim(&world, identity(&one), &towards), ETCH_OK);
        const int32_t from[3] = {world.x, world.y, world.z};
        const int32_t to[3] = {local.x, local.y, local.z};
        const int32_t length = size < 0 ? -size : size;

        for (i = 0; i < 3; i++) { /* model * local = length * world (or its mirror image) */
            const int64_t back = (int64_t)model.m[i][0] * to[0] + (int64_t)model.m[i][1] * to[1] +
                                 (int64_t)model.m[i][2] * to[2];
            const int64_t error = back - (int64_t)length * from[i];

            CHECK(error <= (int64_t)length * 3 && error >= -(int64_t)length * 3);
        }
        const int32_t square = to[0] * to[0] + to[1] * to[1] + to[2] * to[2];

        CHECK(square > 16511 * 16511 && square < 16515 * 16515);
    }
}

static void aim_refuses(void)
{
    static const struct etch_vector none = {0, 0, 0}, some = {0, 0, 1};
    struct etch_light light = {1, 2, 3, {4, 5, 6}};
    struct etch_matrix flat, one;

    etch_matrix_scale(&flat, 65536, 65536, 0);
    CHECK_EQ(etch_light_aim(&light, identity(&one), &none), ETCH_EINVAL);
    CHECK_EQ(etch_light_aim(&light, &flat, &some), ETCH_EINVAL);
    CHECK(light.x == 1 && light.y == 2 && light.z == 3 && light.diffuse[0] == 4);
}

void suite_light(void)
{
    RUN(lit_colors_meet_the_bound);
    RUN(many_lights_saturate);
    RUN(light_falls_by_the_cosine);
    RUN(aim_undoes_the_model);
    RUN(aim_refuses);
}
