/* tests/unit: replace, modulate and decal against their definition in integers, on texels that a
 * filter of the test's own gives; identities that hold bit for bit. */
#include "core/fragment/sampler.h"
#include "tests/harness/harness.h"

void suite_texture_environment(void);

static const uint16_t full[4] = {31 << 11, UINT16_C(63) << 10, 31 << 11, UINT16_C(255) << 8};

/* What the filter below gives, and the chunk before. */
static uint16_t texel[4][ETCH_CHUNK], before[4][ETCH_CHUNK];

static void given(const struct etch_texels *out, const struct etch_chunk *chunk,
                  const struct etch_sampler *sampler)
{
    uint16_t i;

    for (i = 0; i < chunk->n; i++) {
        out->r[i] = texel[0][i];
        out->g[i] = texel[1][i];
        out->b[i] = texel[2][i];
        if (sampler->image.alphas != NULL)
            out->a[i] = texel[3][i];
    }
}

/* A level of a channel: often at the ends, often a whole step. */
static uint16_t level(int32_t k, uint32_t *seed)
{
    const uint16_t step = k == 3 ? 256 : k == 1 ? 1024 : 2048;

    switch (test_range(seed, 0, 3)) {
    case 0: return test_range(seed, 0, 1) == 0 ? 0 : full[k];
    case 1: return (uint16_t)(test_range(seed, 0, full[k] / step) * step);
    default: return (uint16_t)test_range(seed, 0, full[k]);
    }
}

static uint16_t *channel_of(struct etch_chunk *c, int32_t k)
{
    uint16_t *const channels[4] = {c->r, c->g, c->b, c->a};

    return channels[k];
}

static void run(struct etch_chunk *chunk, etch_stage_function *stage, bool opaque, uint32_t *seed)
{
    static const struct etch_image images[2] = {
        {NULL, NULL, NULL, NULL, NULL, 1, 1, 1},
        {NULL, etch_texels_mask, NULL, NULL, NULL, 1, 1, 1}};
    const struct etch_sampler sampler = {images[opaque ? 0 : 1], given, NULL, NULL};
    int32_t i, k;

    chunk->n = (uint16_t)test_range(seed, 1, ETCH_CHUNK);
    for (k = 0; k < 4; k++) {
        for (i = 0; i < ETCH_CHUNK; i++) {
            texel[k][i] = level(k, seed);
            before[k][i] = channel_of(chunk, k)[i] = level(k, seed);
        }
    }
    stage(chunk, &sampler);
    for (k = 0; k < 4; k++) {
        for (i = chunk->n; i < ETCH_CHUNK; i++)
            CHECK_EQ(channel_of(chunk, k)[i], before[k][i]);
    }
}

/* |got full - exact| <= halves full / 2, where `exact` is the true value times full. */
static void check_within(int32_t k, int32_t i, int32_t got, int64_t exact, int64_t whole,
                         int32_t halves)
{
    const int64_t off = ((int64_t)got * whole - exact) * 2;

    if (!CHECK(off <= halves * whole && off >= -halves * whole) ||
        !CHECK(got >= 0 && got <= full[k])) {
        test_note("channel", k);
        test_note("fragment", before[k][i]);
        test_note("texel", texel[k][i]);
        test_note("alpha", texel[3][i]);
        test_note("got", got);
    }
}

static void replace_takes_the_texel(void)
{
    uint32_t seed = 71;
    struct etch_chunk chunk;
    int32_t i, k, round;

    for (round = 0; round < TEST_COUNT(2000) && !test_failed(); round++) {
        const bool opaque = round % 2 == 0;

        run(&chunk, etch_stage_texture_replace, opaque, &seed);
        for (k = 0; k < 4; k++) {
            for (i = 0; i < chunk.n; i++)
                CHECK_EQ(channel_of(&chunk, k)[i], k == 3 && opaque ? before[k][i] : texel[k][i]);
        }
    }
}

static void modulate_multiplies(void)
{
    uint32_t seed = 72;
    struct etch_chunk chunk;
    int32_t i, k, round;

    for (round = 0; round < TEST_COUNT(20000) && !test_failed(); round++) {
        const bool opaque = round % 2 == 0;

        run(&chunk, etch_stage_texture_modulate, opaque, &seed);
        for (k = 0; k < 4; k++) {
            for (i = 0; i < chunk.n; i++) {
                const uint16_t f = before[k][i], t = texel[k][i], got = channel_of(&chunk, k)[i];

                if (k == 3 && opaque) {
                    CHECK_EQ(got, f);
                    continue;
                }
                check_within(k, i, got, (int64_t)f * t, full[k], 3);
                if (t == full[k])
                    CHECK_EQ(got, f); /* white changes nothing */
            }
        }
    }
}

/* Under a white fragment a whole step stays that step once it is rounded: modulate draws what
 * replace draws. */
static void white_times_a_texel_is_the_texel(void)
{
    static const uint16_t step[3] = {2048, 1024, 2048};
    const struct etch_sampler sampler = {
        {NULL, NULL, NULL, NULL, NULL, 1, 1, 1}, given, NULL, NULL};
    struct etch_chunk chunk;
    int32_t i, k;

    chunk.n = 1;
    for (i = 0; i < 64; i++) {
        for (k = 0; k < 3; k++) {
            texel[k][0] = (uint16_t)(i * step[k] <= full[k] ? i * step[k] : 0);
            channel_of(&chunk, k)[0] = full[k];
        }
        etch_stage_texture_modulate(&chunk, &sampler);
        for (k = 0; k < 3; k++)
            CHECK_EQ((channel_of(&chunk, k)[0] + step[k] / 2) / step[k], texel[k][0] / step[k]);
    }
}

static void decal_lays_the_texture_over(void)
{
    uint32_t seed = 73;
    struct etch_chunk chunk;
    int32_t i, k, round;

    for (round = 0; round < TEST_COUNT(20000) && !test_failed(); round++) {
        const bool opaque = round % 4 == 0;

        run(&chunk, etch_stage_texture_decal, opaque, &seed);
        for (k = 0; k < 4; k++) {
            for (i = 0; i < chunk.n; i++) {
                const int64_t f = before[k][i], t = texel[k][i], alpha = texel[3][i];
                const uint16_t got = channel_of(&chunk, k)[i];

                if (k == 3 || (!opaque && alpha == 0))
                    CHECK_EQ(got, f);
                else if (opaque || alpha == full[3])
                    CHECK_EQ(got, t);
                else
                    check_within(k, i, got, f * (full[3] - alpha) + t * alpha, full[3], 4);
            }
        }
    }
}

void suite_texture_environment(void)
{
    RUN(replace_takes_the_texel);
    RUN(modulate_multiplies);
    RUN(white_times_a_texel_is_the_texel);
    RUN(decal_lays_the_texture_over);
}
