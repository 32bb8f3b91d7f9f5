/* tests/unit: samplers: every format, filter and wrap against the definition, in exact rationals,
 * on random and hostile coordinates; fused filters equal to those of parts; what init takes. */
#include "core/fragment/sampler.h"
#include "core/fragment/texel.h"
#include "tests/harness/harness.h"
#include "tests/oracle/sampler.h"

void suite_sampler(void);

/* ---- an image in all formats ----------------------------------------------------------------- */

/* Texels, their gaps, and the unused part of the memory hold what no texel of the image has. */
#define PLACES 33000
static uint16_t colors[PLACES];
static uint8_t bytes[PLACES], nibbles[PLACES / 2 + 1], mask[PLACES];
static uint16_t palette8[256], palette4[16];
static uint8_t alpha8[256], alpha4[16];

enum format {
    RGB565,
    MASKED,
    INDEX8,
    ALPHA8,
    INDEX4,
    ALPHA4,
    FORMATS
};

static enum format format;
static struct etch_image image;

/* The oracle's way to a texel. */
static void texel(int32_t x, int32_t y, uint8_t channel[4])
{
    const int32_t place = y * image.stride + x;
    const int32_t nibble = place % 2 == 0 ? nibbles[place / 2] % 16 : nibbles[place / 2] / 16;
    const uint16_t color = format <= MASKED   ? colors[place]
                           : format <= ALPHA8 ? palette8[bytes[place]]
                                              : palette4[nibble];

    channel[0] = (uint8_t)(color >> 11);
    channel[1] = (uint8_t)(color >> 5 & 63);
    channel[2] = (uint8_t)(color & 31);
    channel[3] = format == MASKED   ? mask[place]
                 : format == ALPHA8 ? alpha8[bytes[place]]
                                    : alpha4[nibble];
}

static void fill(uint32_t *seed)
{
    int32_t i;

    for (i = 0; i < PLACES; i++) {
        colors[i] = (uint16_t)(test_random(seed) & 0xFFFF);
        bytes[i] = (uint8_t)(test_random(seed) & 0xFF);
        mask[i] = (uint8_t)(test_random(seed) & 0xFF);
        nibbles[i / 2] = (uint8_t)(test_random(seed) & 0xFF);
    }
    for (i = 0; i < 256; i++) {
        palette8[i] = (uint16_t)(test_random(seed) & 0xFFFF);
        alpha8[i] = (uint8_t)(test_random(seed) & 0xFF);
        palette4[i % 16] = (uint16_t)(test_random(seed) & 0xFFFF);
        alpha4[i % 16] = (uint8_t)(test_random(seed) & 0xFF);
    }
}

static void make_image(enum format f, uint16_t width, uint16_t height, uint16_t gap)
{
    static const struct etch_image formats[FORMATS] = {
        {etch_texels_rgb565, NULL, colors, NULL, NULL, 0, 0, 0},
        {etch_texels_rgb565, etch_texels_mask, colors, NULL, mask, 0, 0, 0},
        {etch_texels_index8, NULL, bytes, palette8, NULL, 0, 0, 0},
        {etch_texels_index8, etch_texels_alpha8, bytes, palette8, alpha8, 0, 0, 0},
        {etch_texels_index4, NULL, nibbles, palette4, NULL, 0, 0, 0},
        {etch_texels_index4, etch_texels_alpha4, nibbles, palette4, alpha4, 0, 0, 0}};

    format = f;
    image = formats[f];
    image.width = width;
    image.height = height;
    image.stride = (uint16_t)(width + gap);
}

/* ---- comparing ------------------------------------------------------------------------------- */

static const uint16_t unit[4] = {2048, 1024, 2048, 256}; /* of a chunk's formats, in a step */

struct wrap_pair {
    etch_texel_wrap *wrap;
    enum oracle_wrap means;
    bool power;
};
static const struct wrap_pair wraps[] = {{etch_texels_repeat, ORACLE_REPEAT, false},
                                         {etch_texels_clamp, ORACLE_CLAMP, false},
                                         {etch_texels_mirror, ORACLE_MIRROR, false},
                                         {etch_texels_repeat_power, ORACLE_REPEAT, true},
                                         {etch_texels_mirror_power, ORACLE_MIRROR, true}};

/* Coordinates of a chunk: neighbours, anywhere, near the ends of the range, at and beside whole and
 * half texels. */
static void make_coordinates(int32_t c[ETCH_CHUNK], int32_t kind, uint32_t *seed)
{
    const int32_t step = test_range(seed, -200000, 200000),
                  from = test_range(seed, -999999, 999999);
    int32_t i;

    for (i = 0; i < ETCH_CHUNK; i++) {
        const int32_t near = test_range(seed, -2, 2), far = test_range(seed, 0, 70000);

        c[i] = kind == 0   ? from + step * i
               : kind == 1 ? (int32_t)test_random(seed)
               : kind == 2 ? (i % 2 == 0 ? INT32_MIN + far : INT32_MAX - far)
               : kind == 3 ? (i % 2 == 0 ? INT32_MIN + i / 4 : INT32_MAX - i / 4)
                           : test_range(seed, -32767, 32766) * 65536 + (i % 2) * 32768 + near;
    }
}

/* One chunk by the filter and by the oracle. */
static void check_chunk(const struct etch_sampler *s, const struct oracle_sampler *o, bool linear,
                        const struct etch_chunk *chunk)
{
    uint16_t out[4][ETCH_CHUNK];
    const struct etch_texels to = {out[0], out[1], out[2], out[3]};
    int32_t i, k, wrong = 0;

    for (i = 0; i < 4 * ETCH_CHUNK; i++)
        out[i / ETCH_CHUNK][i % ETCH_CHUNK] = 0xABCD;
    s->filter(&to, chunk, s);
    for (i = 0; i < ETCH_CHUNK; i++) {
        uint64_t mean[4];
        uint8_t spread[4], channel[4];

        oracle_nearest(o, chunk->u[i], chunk->v[i], channel);
        oracle_linear(o, chunk->u[i], chunk->v[i], mean, spread);
        for (k = 0; k < 4; k++) {
            const uint16_t got = out[k][i];
            const int64_t off = (int64_t)((uint64_t)got << 32) - (int64_t)(mean[k] * unit[k]);
            const int64_t most = ((int64_t)spread[k] * unit[k] << 22) + (INT64_C(1) << 31);

            if (i >= chunk->n || (k == 3 && s->image.alphas == NULL))
                wrong += got != 0xABCD; /* is left alone */
            else if (linear)
                wrong += off > most || off < -most;
            else
                wrong += got != channel[k] * unit[k];
        }
    }
    if (!CHECK_EQ(wrong, 0)) {
        test_note("format", format);
        test_note("width", s->image.width);
        test_note("height", s->image.height);
        test_note("u", chunk->u[0]);
        test_note("v", chunk->v[0]);
    }
}

static void check_image(const struct etch_sampler *s, const struct oracle_sampler *o, bool linear,
                        int32_t rounds, uint32_t *seed)
{
    struct etch_chunk chunk;
    int32_t i;

    for (i = 0; i < rounds && !test_failed(); i++) {
        chunk.n = (uint16_t)(i % 3 == 0 ? test_range(seed, 1, ETCH_CHUNK) : ETCH_CHUNK);
        make_coordinates(chunk.u, test_range(seed, 0, 4), seed);
        make_coordinates(chunk.v, test_range(seed, 0, 4), seed);
        check_chunk(s, o, linear, &chunk);
    }
}

/* A size; powers of two for those wraps. */
static uint16_t make_size(bool power, uint32_t *seed)
{
    return (uint16_t)(power ? 1 << test_range(seed, 0, 7) : test_range(seed, 1, 150));
}

static void every_combination_is_exact(void)
{
    uint32_t seed = 61;
    int32_t f, u, v, linear;

    fill(&seed);
    for (f = 0; f < FORMATS; f++) {
        for (u = 0; u < 5; u++) {
            for (v = 0; v < 5; v++) {
                for (linear = 0; linear < 2 && !test_failed(); linear++) {
                    const struct oracle_sampler o = {texel, make_size(wraps[u].power, &seed),
                                                     make_size(wraps[v].power, &seed),
                                                     wraps[u].means, wraps[v].means};
                    struct etch_sampler s;

                    make_image((enum format)f, (uint16_t)o.width, (uint16_t)o.height,
                               (uint16_t)test_range(&seed, 0, 3));
                    CHECK_EQ(etch_sampler_init(&s, &image,
                                               linear ? etch_filter_linear : etch_filter_nearest,
                                               wraps[u].wrap),
                             ETCH_OK);
                    s.wrap_v = wraps[v].wrap;
                    check_image(&s, &o, linear != 0, TEST_COUNT(40), &seed);
                }
            }
        }
    }
}

/* The longest sides, either way, where products and periods are greatest. */
static void longest_sides_are_exact(void)
{
    static const uint16_t sides[][2] = {{32767, 1}, {1, 32767}, {32766, 1}, {16384, 2}, {2, 16384}};
    uint32_t seed = 62;
    int32_t i, w, linear;

    fill(&seed);
    for (i = 0; i < 5; i++) {
        for (w = 0; w < (i < 3 ? 3 : 5); w++) {
            for (linear = 0; linear < 2 && !test_failed(); linear++) {
                const struct oracle_sampler o = {texel, sides[i][0], sides[i][1], wraps[w].means,
                                                 wraps[w].means};
                struct etch_sampler s;

                make_image(i % 2 == 0 ? RGB565 : ALPHA4, sides[i][0], sides[i][1], 0);
                (void)etch_sampler_init(
                    &s, &image, linear ? etch_filter_linear : etch_filter_nearest, wraps[w].wrap);
                check_image(&s, &o, linear != 0, TEST_COUNT(100), &seed);
            }
        }
    }
}

/* ---- fused ----------------------------------------------------------------------------------- */

static ETCH_FILTER_NEAREST(fused_nearest, etch_address_mirror, etch_texel_index4,
                           etch_texel_alpha4) static ETCH_FILTER_LINEAR(fused_linear,
                                                                        etch_address_clamp,
                                                                        etch_texel_index8,
                                                                        etch_texel_alpha8)

    static void fused_filters_are_exact(void)
{
    static const struct {
        etch_texel_filter *filter;
        enum format format;
        enum oracle_wrap wrap;
        bool power, linear;
    } fused[] = {{etch_filter_nearest_power, RGB565, ORACLE_REPEAT, true, false},
                 {etch_filter_linear_power, RGB565, ORACLE_REPEAT, true, true},
                 {fused_nearest, ALPHA4, ORACLE_MIRROR, false, false},
                 {fused_linear, ALPHA8, ORACLE_CLAMP, false, true}};
    uint32_t seed = 63;
    int32_t i, k;

    fill(&seed);
    for (i = 0; i < 4; i++) {
        for (k = 0; k < TEST_COUNT(20) && !test_failed(); k++) {
            const struct oracle_sampler o = {texel, make_size(fused[i].power, &seed),
                                             make_size(fused[i].power, &seed), fused[i].wrap,
                                             fused[i].wrap};
            struct etch_sampler s = {image, fused[i].filter, NULL, NULL};

            make_image(fused[i].format, (uint16_t)o.width, (uint16_t)o.height, 1);
            s.image = image;
            check_image(&s, &o, fused[i].linear, 10, &seed);
        }
    }
}

static void init_checks_the_image(void)
{
    struct etch_sampler s = {{0}, NULL, NULL, NULL};
    struct etch_image bad[8];
    int32_t i;

    make_image(MASKED, 4, 4, 0);
    for (i = 0; i < 8; i++)
        bad[i] = image;
    bad[0].colors = NULL;
    bad[1].texels = NULL;
    bad[2].alpha = NULL;
    bad[3].width = 0;
    bad[4].height = 0;
    bad[5].width = bad[5].stride = 32768;
    bad[6].height = 32768;
    bad[7].stride = 3;
    for (i = 0; i < 8; i++)
        CHECK_EQ(etch_sampler_init(&s, &bad[i], etch_filter_nearest, etch_texels_clamp),
                 ETCH_EINVAL);
    CHECK_EQ(etch_sampler_init(&s, &image, NULL, etch_texels_clamp), ETCH_EINVAL);
    CHECK_EQ(etch_sampler_init(&s, &image, etch_filter_nearest, NULL), ETCH_EINVAL);
    CHECK(s.filter == NULL && s.image.texels == NULL);
    CHECK_EQ(etch_sampler_init(&s, &image, etch_filter_nearest, etch_texels_clamp), ETCH_OK);
    CHECK(s.wrap_u == etch_texels_clamp && s.wrap_v == etch_texels_clamp && s.image.width == 4);
}

void suite_sampler(void)
{
    RUN(every_combination_is_exact);
    RUN(longest_sides_are_exact);
    RUN(fused_filters_are_exact);
    RUN(init_checks_the_image);
}
