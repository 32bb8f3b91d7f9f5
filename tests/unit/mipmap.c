/* tests/unit: mipmaps: every level against exact means of the image, the level of a triangle and
 * the coordinates in it against their definitions. */
#include "core/fragment/mipmap.h"
#include "core/fragment/sampler.h"
#include "tests/harness/harness.h"
#include "tests/harness/shapes.h"

void suite_mipmap(void);

#define MOST 2200
static uint8_t bytes[MOST], alpha8[256], alphas[MOST + 1];
static uint16_t palette[256], texels[MOST + 1];

static struct etch_image make_image(uint16_t width, uint16_t height, bool opaque, uint32_t *seed)
{
    const struct etch_image image = {etch_texels_index8,
                                     opaque ? NULL : etch_texels_alpha8,
                                     bytes,
                                     palette,
                                     opaque ? NULL : alpha8,
                                     width,
                                     height,
                                     (uint16_t)(width + 1)};
    int32_t i;

    for (i = 0; i < MOST; i++)
        bytes[i] = (uint8_t)(test_random(seed) & 0xFF);
    for (i = 0; i < 256; i++) {
        palette[i] = (uint16_t)(test_random(seed) & 0xFFFF);
        alpha8[i] = (uint8_t)(test_random(seed) & 0xFF);
    }
    return image;
}

static int32_t channel_at(const struct etch_image *image, int32_t x, int32_t y, int32_t k)
{
    const uint8_t index = bytes[y * image->stride + x];

    return k == 0   ? palette[index] >> 11
           : k == 1 ? palette[index] >> 5 & 63
           : k == 2 ? palette[index] & 31
                    : alpha8[index];
}

/* The mean over the box of texel (x, y) of a level of w x h, rounded half up, by cutting each texel
 * of the image into w x h parts and counting them. */
static int32_t exact_mean(const struct etch_image *image, int32_t w, int32_t h, int32_t x,
                          int32_t y, int32_t k)
{
    const int32_t area = image->width * image->height;
    int32_t sum = 0, i, j;

    for (j = y * image->height; j < (y + 1) * image->height; j++) {
        for (i = x * image->width; i < (x + 1) * image->width; i++)
            sum += channel_at(image, i / w, j / h, k);
    }
    return (2 * sum + area) / (2 * area);
}

static void check_level(const struct etch_image *image, const struct etch_image *level)
{
    const uint16_t *const color = (const uint16_t *)level->texels;
    int32_t x, y, wrong = 0;

    for (y = 0; y < level->height; y++) {
        for (x = 0; x < level->width; x++) {
            const int32_t place = y * level->stride + x, w = level->width, h = level->height;

            wrong += color[place] >> 11 != exact_mean(image, w, h, x, y, 0);
            wrong += (color[place] >> 5 & 63) != exact_mean(image, w, h, x, y, 1);
            wrong += (color[place] & 31) != exact_mean(image, w, h, x, y, 2);
            if (image->alphas != NULL)
                wrong += level->alpha[place] != exact_mean(image, w, h, x, y, 3);
        }
    }
    if (!CHECK_EQ(wrong, 0)) {
        test_note("width", image->width);
        test_note("height", image->height);
        test_note("level's width", level->width);
    }
}

static void levels_are_exact_means(void)
{
    uint32_t seed = 81;
    int32_t i, k;

    for (i = 0; i < TEST_COUNT(40) && !test_failed(); i++) {
        const bool power = i % 2 == 0, opaque = i % 3 == 0;
        const uint16_t w = (uint16_t)(power ? 1 << test_range(&seed, 0, 5)
                                            : test_range(&seed, 1, 45));
        const uint16_t h = (uint16_t)(power ? 1 << test_range(&seed, 0, 5)
                                            : test_range(&seed, 1, 45));
        const struct etch_image image = make_image(w, h, opaque, &seed);
        const uint32_t need = etch_mipmap_texels(w, h);
        struct etch_mipmap m;

        texels[need] = 0xABCD;
        alphas[need] = 0xAB;
        CHECK_EQ(etch_mipmap_build(&m, &image, texels, opaque ? NULL : alphas, need), ETCH_OK);
        CHECK(texels[need] == 0xABCD && alphas[need] == 0xAB);
        CHECK(m.level[0].texels == bytes && m.level[0].width == w && m.level[0].height == h);
        for (k = 1; k < m.count; k++) {
            const struct etch_image *const level = &m.level[k];

            CHECK_EQ(level->width, w >> k > 0 ? w >> k : 1);
            CHECK_EQ(level->height, h >> k > 0 ? h >> k : 1);
            CHECK(etch_image_valid(level) && (level->alphas == NULL) == opaque);
            check_level(&image, level);
            if (power) {
                struct etch_texture fused;

                CHECK_EQ(etch_texture_init(&fused, (const uint16_t *)level->texels, level->width,
                                           level->height),
                         ETCH_OK);
            }
        }
        CHECK(m.level[m.count - 1].width == 1 && m.level[m.count - 1].height == 1);
    }
}

static void build_checks_its_arguments(void)
{
    uint32_t seed = 82;
    struct etch_image image = make_image(8, 4, false, &seed);
    struct etch_mipmap m;

    m.count = 77;
    CHECK_EQ(etch_mipmap_texels(1, 1), 0);
    CHECK_EQ(etch_mipmap_texels(8, 4), 8 + 2 + 1);
    CHECK_EQ(etch_mipmap_texels(3, 5), 2 + 1);
    CHECK_EQ(etch_mipmap_texels(32767, 1), 32767 - 15);
    CHECK_EQ(etch_mipmap_texels(32767, 32767), UINT32_C(357848422));
    CHECK_EQ(etch_mipmap_build(&m, &image, texels, alphas, 10), ETCH_ENOMEM);
    CHECK_EQ(etch_mipmap_build(&m, &image, NULL, alphas, 11), ETCH_EINVAL);
    CHECK_EQ(etch_mipmap_build(&m, &image, texels, NULL, 11), ETCH_EINVAL);
    image.stride = 7;
    CHECK_EQ(etch_mipmap_build(&m, &image, texels, alphas, 11), ETCH_EINVAL);
    CHECK_EQ(m.count, 77);
}

/* ---- levels of triangles --------------------------------------------------------------------- */

/* Twice the area, exactly. */
static uint64_t area_of(const int32_t x[3], const int32_t y[3])
{
    const int64_t a = (int64_t)(x[1] - x[0]) * (y[2] - y[0]) -
                      (int64_t)(y[1] - y[0]) * (x[2] - x[0]);

    return (uint64_t)(a < 0 ? -a : a);
}

static void levels_are_of_the_nearest_size(void)
{
    static const struct etch_rect window = {0, 0, 320, 240};
    struct etch_mipmap m = {.count = ETCH_MIPMAP_LEVELS};
    uint32_t seed = 83;
    int32_t i, k, seen[ETCH_MIPMAP_LEVELS] = {0};

    for (i = 0; i < TEST_COUNT(30000) && !test_failed(); i++) {
        const uint8_t shift = (uint8_t)test_range(&seed, 0, 20);
        struct etch_texture_vertex v[3];
        struct test_triangle t;
        int32_t u8[3], v8[3], level = 0;
        uint64_t pixels, area;

        test_triangle_make(&t, (enum test_triangle_kind)(i % TEST_TRIANGLE_KINDS), window, &seed);
        for (k = 0; k < 3; k++) {
            v[k] = (struct etch_texture_vertex){{t.x[k], t.y[k], 0, 0, 0, 0, 0},
                                                (int32_t)test_random(&seed) >> shift,
                                                (int32_t)test_random(&seed) >> shift,
                                                1};
            u8[k] = v[k].u >> 8;
            v8[k] = v[k].v >> 8;
        }
        pixels = area_of(t.x, t.y);
        area = area_of(u8, v8);
        m.count = (uint8_t)test_range(&seed, 1, ETCH_MIPMAP_LEVELS);
        while (level + 1 < m.count && pixels << 2 * (level + 1) <= 2 * area &&
               pixels < UINT64_C(1) << (62 - 2 * level - 2))
            level++;
        for (k = 0; k < 6; k++) {
            const uint8_t *const order = test_orders[k];
            const struct etch_texture_vertex *const p[3] = {&v[order[0]], &v[order[1]],
                                                            &v[order[2]]};

            if (!CHECK_EQ(etch_mipmap_level(&m, p), level))
                test_note("case", i);
        }
        seen[level]++;
    }
    for (k = 0; k < ETCH_MIPMAP_LEVELS; k++)
        CHECK(seen[k] > 0);
}

/* A square of texels drawn as large as itself, at the sizes where the level changes: 2 T / P = 4^k,
 * T / P = 1/2, 2, 8. */
static void levels_change_at_half_steps(void)
{
    static const struct {
        int32_t texels, pixels, level; /* areas of the right triangle's legs' product */
    } cases[] = {{1, 1, 0},     {2, 1, 1}, {199, 100, 0}, {8, 1, 2},
                 {799, 100, 1}, {1, 2, 0}, {1, 9, 0}};
    struct etch_mipmap m = {.count = 8};
    size_t i;

    for (i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const struct etch_texture_vertex v[3] = {
            {{0, 0, 0, 0, 0, 0, 0}, 0, 0, 1},
            {{cases[i].pixels * 256, 0, 0, 0, 0, 0, 0}, cases[i].texels * 65536, 0, 1},
            {{0, 256, 0, 0, 0, 0, 0}, 0, 65536, 1}};
        const struct etch_texture_vertex *const p[3] = {&v[0], &v[1], &v[2]};

        CHECK_EQ(etch_mipmap_level(&m, p), cases[i].level);
    }
}

static void vertices_move_with_the_level(void)
{
    static const int32_t ends[] = {INT32_MIN, INT32_MIN + 1, -1, 0, 1, 65536, INT32_MAX};
    struct etch_mipmap m = {.count = 4};
    uint32_t seed = 84;
    int32_t i, k;

    for (i = 0; i < TEST_COUNT(20000) && !test_failed(); i++) {
        const uint16_t w = (uint16_t)(i % 2 == 0 ? 1 << test_range(&seed, 0, 14)
                                                 : test_range(&seed, 1, 32767));
        struct etch_texture_vertex v = {{1, 2, 3, 4, 5, 6, 7}, 0, 0, 9}, out;

        v.u = i % 3 == 0 ? ends[test_range(&seed, 0, 6)] : (int32_t)test_random(&seed);
        v.v = (int32_t)test_random(&seed) >> test_range(&seed, 0, 31);
        for (k = 0; k < 4; k++) {
            m.level[k].width = (uint16_t)(w >> k > 0 ? w >> k : 1);
            m.level[k].height = 1;
        }
        for (k = 0; k < 4; k++) {
            const int64_t part = m.level[k].width;
            int64_t off;

            etch_mipmap_vertex(&out, &v, &m, (uint8_t)k);
            off = 2 * ((int64_t)out.u * w - v.u * part); /* -w <= off < w would be half down */
            if (!CHECK(off > -w && off <= w))
                test_note("u", v.u);
            CHECK_EQ(out.v, v.v);
            CHECK(out.w == 9 && out.at.x_q8 == 1 && out.at.a == 7);
        }
    }
}

void suite_mipmap(void)
{
    RUN(levels_are_exact_means);
    RUN(build_checks_its_arguments);
    RUN(levels_are_of_the_nearest_size);
    RUN(levels_change_at_half_steps);
    RUN(vertices_move_with_the_level);
}
