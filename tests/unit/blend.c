/* tests/unit: blending, logic operations and colour masks against their definitions, in 64 bits:
 * all destinations, all alphas, and sources with their fraction bits. */
#include "core/fragment/blend.h"
#include "core/fragment/logic.h"
#include "core/fragment/write.h"
#include "tests/harness/harness.h"

void suite_blend(void);

static struct etch_chunk chunk;
static int64_t compared;

/* A channel: its place in the pixel, the fraction bits of the chunk, and full. */
struct channel {
    uint16_t *values;
    int shift, bits;
    uint64_t most;
};

static const struct channel channels[3] = {
    {chunk.r, 11, 11, 31}, {chunk.g, 5, 10, 63}, {chunk.b, 0, 11, 31}};

typedef uint64_t definition(uint64_t s, uint64_t d, uint64_t a, const struct channel *c);

static uint64_t round_up_ties(uint64_t n, uint64_t d)
{
    return (2 * n + d) / (2 * d);
}

static uint64_t least(uint64_t a, uint64_t b)
{
    return a < b ? a : b;
}

static uint64_t mix(uint64_t s, uint64_t d, uint64_t a, const struct channel *c)
{
    return round_up_ties(s * a + (d << c->bits) * (65280 - a), UINT64_C(65280) << c->bits);
}

static uint64_t sum(uint64_t s, uint64_t d, uint64_t a, const struct channel *c)
{
    (void)a;
    return least(round_up_ties(s + (d << c->bits), UINT64_C(1) << c->bits), c->most);
}

static uint64_t weighted_sum(uint64_t s, uint64_t d, uint64_t a, const struct channel *c)
{
    return least(round_up_ties(s * a + (d << c->bits) * 65280, UINT64_C(65280) << c->bits),
                 c->most);
}

static uint64_t product(uint64_t s, uint64_t d, uint64_t a, const struct channel *c)
{
    (void)a;
    return round_up_ties(s * d, c->most << c->bits);
}

/* Sixteen sources round s0 with one destination and alpha in every channel, which the stage turns
 * into what the definition gives, and writing keeps. */
static void compare(etch_stage_function *stage, const void *data, definition *defined, uint64_t s0,
                    uint64_t d, uint64_t a)
{
    uint64_t s[3][ETCH_CHUNK], dst[3];
    uint16_t i;
    int k;

    chunk.n = ETCH_CHUNK;
    for (k = 0; k < 3; k++)
        dst[k] = d % (channels[k].most + 1);
    for (i = 0; i < ETCH_CHUNK; i++) {
        chunk.a[i] = (uint16_t)a;
        chunk.pixel[i] = (uint16_t)(dst[0] << 11 | dst[1] << 5 | dst[2]);
        for (k = 0; k < 3; k++) {
            const uint64_t full = channels[k].most << channels[k].bits;

            s[k][i] = least(s0 + i * (s0 % 97), full);
            channels[k].values[i] = (uint16_t)s[k][i];
        }
    }
    stage(&chunk, data);
    for (i = 0; i < ETCH_CHUNK; i++) {
        const uint16_t pixel = etch_chunk_pixel(&chunk, i);

        for (k = 0; k < 3; k++) {
            const struct channel *c = &channels[k];
            const uint64_t got = pixel >> c->shift & c->most;

            compared++;
            if (got != defined(s[k][i], dst[k], a, c)) {
                CHECK_EQ(got, defined(s[k][i], dst[k], a, c));
                test_note("channel", k);
                test_note("s", (int64_t)s[k][i]);
                test_note("d", (int64_t)dst[k]);
                test_note("a", (int64_t)a);
            }
        }
    }
}

/* All destinations with all 8-bit alphas and those beside them, and sources all over the range. */
static void compare_all(etch_stage_function *stage, definition *defined, bool alphas)
{
    const uint64_t step = 4001 * (uint64_t)TEST_DIVISOR;
    uint64_t s, d, a;

    for (a = 0; a <= 65280 && !test_failed(); a += alphas ? 255 : 65280)
        for (d = 0; d < 64; d++)
            for (s = (a + d) % 3 * 777; s < 64512; s += step)
                compare(stage, NULL, defined, s, d, a);
    for (d = 0; d < 64; d++) {
        compare(stage, NULL, defined, 64512, d, 65280);
        compare(stage, NULL, defined, 1, d, 256);
        compare(stage, NULL, defined, 63487, d, 65279);
    }
}

static void alpha_is_exact(void)
{
    compare_all(etch_stage_blend_alpha, mix, true);
}

static void constant_alpha_is_exact(void)
{
    struct etch_blend_constant constant;
    uint64_t s, d;
    int a;

    for (a = 0; a < 256 && !test_failed(); a++) {
        constant.alpha = (uint8_t)a;
        for (d = 0; d < 64; d++)
            for (s = (uint64_t)a * 3; s < 64512; s += 9001)
                compare(etch_stage_blend_constant, &constant, mix, s, d, (uint64_t)a * 256);
    }
}

static void addition_is_exact(void)
{
    compare_all(etch_stage_blend_add, sum, false);
    compare_all(etch_stage_blend_add_alpha, weighted_sum, true);
}

static void multiplication_is_exact(void)
{
    uint64_t s, d;

    for (s = 0; s < 64512 && !test_failed(); s += 16)
        for (d = 0; d<64; d += TEST_DIVISOR> 1 ? 7 : 1)
            compare(etch_stage_blend_multiply, NULL, product, s - s % 97, d, 0);
    compare_all(etch_stage_blend_multiply, product, false);
}

/* Every destination stays under alpha 0, and every source gets through alpha 255, bit for bit. */
static void ends_of_alpha_are_identities(void)
{
    static const uint16_t sources[] = {0, 0x1234, 0xFFFF, 0xF800, 0x07E0, 0x001F, 0x8410};
    const uint16_t n = sizeof sources / sizeof sources[0];
    uint32_t d;
    uint16_t i;

    for (d = 0; d < 65536; d++) {
        chunk.n = ETCH_CHUNK;
        for (i = 0; i < ETCH_CHUNK; i++) {
            etch_chunk_set_pixel(&chunk, i, sources[i % n]);
            chunk.a[i] = i < 8 ? 0 : 255 << 8;
            chunk.pixel[i] = (uint16_t)d;
        }
        etch_stage_blend_alpha(&chunk, NULL);
        for (i = 0; i < ETCH_CHUNK; i++)
            if (etch_chunk_pixel(&chunk, i) != (i < 8 ? d : sources[i % n]))
                CHECK_EQ(etch_chunk_pixel(&chunk, i), i < 8 ? d : sources[i % n]);
    }
}

/* The sixteen operations by their truth tables: bit 3 .. 0 is the result for S D = 11, 10, 01, 00.
 */
static const struct {
    etch_stage_function *stage;
    unsigned truth;
} logic[16] = {
    {etch_stage_logic_clear, 0},        {etch_stage_logic_nor, 1},
    {etch_stage_logic_and_inverted, 2}, {etch_stage_logic_copy_inverted, 3},
    {etch_stage_logic_and_reverse, 4},  {etch_stage_logic_invert, 5},
    {etch_stage_logic_xor, 6},          {etch_stage_logic_nand, 7},
    {etch_stage_logic_and, 8},          {etch_stage_logic_equiv, 9},
    {etch_stage_logic_noop, 10},        {etch_stage_logic_or_inverted, 11},
    {etch_stage_logic_copy, 12},        {etch_stage_logic_or_reverse, 13},
    {etch_stage_logic_or, 14},          {etch_stage_logic_set, 15},
};

static uint16_t truth_of(unsigned truth, uint16_t s, uint16_t d)
{
    unsigned result = 0, bit;

    for (bit = 0; bit < 16; bit++)
        result |= (truth >> ((s >> bit & 1) * 2 + (d >> bit & 1)) & 1) << bit;
    return (uint16_t)result;
}

static void logic_operations_are_their_truth_tables(void)
{
    uint32_t seed = 7;
    int32_t k, round;
    uint16_t i;

    for (k = 0; k < 16; k++) {
        for (round = 0; round < TEST_COUNT(500); round++) {
            uint16_t s[ETCH_CHUNK];

            chunk.n = ETCH_CHUNK;
            for (i = 0; i < ETCH_CHUNK; i++) {
                const uint32_t bits = test_random(&seed);

                s[i] = (uint16_t)(bits >> 16);
                etch_chunk_set_pixel(&chunk, i, s[i]);
                chunk.pixel[i] = (uint16_t)(bits & 0xFFFF);
            }
            logic[k].stage(&chunk, NULL);
            for (i = 0; i < ETCH_CHUNK; i++)
                CHECK_EQ(etch_chunk_pixel(&chunk, i),
                         truth_of(logic[k].truth, s[i], chunk.pixel[i]));
        }
    }
}

static void masks_keep_bits(void)
{
    static const uint16_t masks[] = {0, 0xFFFF, 0xF800, 0x07E0, 0x001F, 0xF81F, 0x5555};
    uint32_t seed = 8;
    uint16_t i, m;

    for (m = 0; m < sizeof masks / sizeof masks[0]; m++) {
        const struct etch_color_mask mask = {masks[m]};
        uint16_t s[ETCH_CHUNK];

        chunk.n = ETCH_CHUNK;
        for (i = 0; i < ETCH_CHUNK; i++) {
            const uint32_t bits = test_random(&seed);

            s[i] = (uint16_t)(bits >> 16);
            etch_chunk_set_pixel(&chunk, i, s[i]);
            chunk.pixel[i] = (uint16_t)(bits & 0xFFFF);
        }
        etch_stage_color_mask(&chunk, &mask);
        for (i = 0; i < ETCH_CHUNK; i++)
            CHECK_EQ(etch_chunk_pixel(&chunk, i),
                     (s[i] & masks[m]) | (chunk.pixel[i] & (0xFFFF ^ masks[m])));
    }
}

/* Every value of a channel is rounded to nearest, ties upwards. */
static void writing_rounds_once(void)
{
    uint32_t v;

    for (v = 0; v <= 64512; v++) {
        chunk.r[0] = chunk.b[0] = (uint16_t)least(v, 63488);
        chunk.g[0] = (uint16_t)v;
        const uint16_t p = etch_chunk_pixel(&chunk, 0);

        if (p >> 11 != round_up_ties(least(v, 63488), 2048) || (p & 31) != p >> 11 ||
            (p >> 5 & 63) != round_up_ties(v, 1024))
            CHECK_EQ(p, -1);
    }
}

void suite_blend(void)
{
    compared = 0;
    RUN(alpha_is_exact);
    RUN(constant_alpha_is_exact);
    RUN(addition_is_exact);
    RUN(multiplication_is_exact);
    RUN(ends_of_alpha_are_identities);
    RUN(logic_operations_are_their_truth_tables);
    RUN(masks_keep_bits);
    RUN(writing_rounds_once);
    test_print_count("", compared, " blended channels, all rounded exactly");
}
