/* tests/unit: the stencil test, its operations and masks, and the tests of alpha and depth, against
 * their definitions: all functions, all operations, all values. */
#include "core/draw/shapes.h"
#include "core/fragment/stencil.h"
#include "core/fragment/test.h"
#include "tests/harness/canvas.h"

void suite_stencil(void);

static uint16_t colors[ETCH_CHUNK], depths[ETCH_CHUNK];
static uint8_t stencils[ETCH_CHUNK + 2];
static struct etch_surface surface;

static const struct {
    etch_stage_function *stencil, *depth;
    int passes; /* bits 0, 1, 2: less, equal, greater */
} tests[8] = {
    {etch_stage_stencil_never, etch_stage_depth_never, 0},
    {etch_stage_stencil_less, etch_stage_depth_less, 1},
    {etch_stage_stencil_equal, etch_stage_depth_equal, 2},
    {etch_stage_stencil_lequal, etch_stage_depth_lequal, 3},
    {etch_stage_stencil_greater, etch_stage_depth_greater, 4},
    {etch_stage_stencil_notequal, etch_stage_depth_notequal, 5},
    {etch_stage_stencil_gequal, etch_stage_depth_gequal, 6},
    {etch_stage_stencil_always, NULL, 7},
};

static etch_stencil_operation *const operations[8] = {
    NULL,
    etch_stencil_zero,
    etch_stencil_replace,
    etch_stencil_incr,
    etch_stencil_decr,
    etch_stencil_invert,
    etch_stencil_incr_wrap,
    etch_stencil_decr_wrap,
};

static bool passes(int test, int a, int b)
{
    return (tests[test].passes >> (a < b ? 0 : a == b ? 1 : 2) & 1) != 0;
}

static int result(int operation, int stored, int reference)
{
    switch (operation) {
    case 1: return 0;
    case 2: return reference;
    case 3: return stored == 255 ? 255 : stored + 1;
    case 4: return stored == 0 ? 0 : stored - 1;
    case 5: return ~stored & 255;
    case 6: return (stored + 1) % 256;
    case 7: return (stored + 255) % 256;
    default: return stored;
    }
}

static int masked_result(int operation, int stored, const struct etch_stencil *s)
{
    return (stored & ~s->write_mask & 255) |
           (result(operation, stored, s->reference) & s->write_mask);
}

static void open(struct etch_chunk *c, uint16_t alive)
{
    const struct etch_rect window = {0, 0, ETCH_CHUNK, 1};

    CHECK_EQ(etch_surface_init(&surface, colors, window, ETCH_CHUNK), ETCH_OK);
    surface.depth = depths;
    surface.stencil = stencils + 1;
    c->surface = &surface;
    c->first = 0;
    c->x = c->y = 0;
    c->n = ETCH_CHUNK;
    c->alive = alive;
    c->stencilled = 0;
}

/* One chunk of stored values v .. v + 15, of which those in `alive` are tested, those in `hidden`
 * dropped between the test and its operations. */
static void compare(int test, const struct etch_stencil *s, const int operation[3], int v,
                    uint16_t alive, uint16_t hidden)
{
    struct etch_chunk c;
    int i;

    open(&c, alive);
    stencils[0] = stencils[ETCH_CHUNK + 1] = 0xA5;
    for (i = 0; i < ETCH_CHUNK; i++)
        stencils[i + 1] = (uint8_t)(v + i);
    tests[test].stencil(&c, s);
    c.alive = (uint16_t)(c.alive & ~hidden);
    etch_stage_stencil_update(&c, s);
    for (i = 0; i < ETCH_CHUNK; i++) {
        const int stored = (v + i) & 255;
        const bool was = (alive >> i & 1) != 0, drop = (hidden >> i & 1) != 0;
        const bool pass = passes(test, s->reference & s->mask, stored & s->mask);
        const int want = !was    ? stored
                         : !pass ? masked_result(operation[0], stored, s)
                         : drop  ? masked_result(operation[1], stored, s)
                                 : masked_result(operation[2], stored, s);

        CHECK_EQ(stencils[i + 1], want);
        CHECK_EQ(c.alive >> i & 1, was && pass && !drop);
    }
    CHECK(c.stencilled == 0 && stencils[0] == 0xA5 && stencils[ETCH_CHUNK + 1] == 0xA5);
}

/* All functions, references, stored values, with full and partial masks, operations in turn. */
static void stencil_functions_and_operations(void)
{
    uint32_t seed = 3;
    int test, reference, v, count = 0;

    for (test = 0; test < 8; test++) {
        for (reference = 0; reference < 256 && !test_failed(); reference++) {
            for (v = 0; v < 256; v += ETCH_CHUNK) {
                const uint32_t bits = test_random(&seed);
                const int operation[3] = {count % 8, count / 8 % 8, count / 64 % 8};
                const struct etch_stencil s = {(uint8_t)reference,
                                               (uint8_t)(count % 3 == 0 ? bits & 255 : 255),
                                               (uint8_t)(count % 5 == 0 ? bits >> 8 & 255 : 255),
                                               operations[operation[0]],
                                               operations[operation[1]],
                                               operations[operation[2]]};

                compare(test, &s, operation, v, (uint16_t)(count % 4 == 0 ? bits >> 16 : 0xFFFF),
                        (uint16_t)(bits >> 3 & 0xFFFF));
                count++;
            }
        }
    }
    test_print_count("", (int64_t)count * ETCH_CHUNK, " stencil tests and operations");
}

/* Each operation on all values with all references. */
static void operations_on_all_values(void)
{
    int k, stored, reference;

    for (k = 1; k < 8; k++)
        for (stored = 0; stored < 256; stored++)
            for (reference = 0; reference < 256; reference++)
                if (operations[k]((uint8_t)stored, (uint8_t)reference) !=
                    result(k, stored, reference))
                    CHECK_EQ(operations[k]((uint8_t)stored, (uint8_t)reference),
                             result(k, stored, reference));
}

static void depth_functions_and_writing(void)
{
    static const uint16_t values[] = {0, 1, 2, 100, 32767, 32768, 65534, 65535};
    int test, i, k;

    for (test = 0; test < 7; test++) {
        for (i = 0; i < 8; i++) {
            struct etch_chunk c;

            open(&c, 0x00FF);
            for (k = 0; k < ETCH_CHUNK; k++) {
                depths[k] = values[k % 8];
                c.z[k] = values[i];
            }
            tests[test].depth(&c, NULL);
            etch_stage_depth_write(&c, NULL);
            for (k = 0; k < ETCH_CHUNK; k++) {
                const bool pass = k < 8 && passes(test, values[i], values[k % 8]);

                CHECK_EQ(c.alive >> k & 1, pass);
                CHECK_EQ(depths[k], pass ? values[i] : values[k % 8]);
            }
        }
    }
}

/* An alpha is compared with all its fraction bits. */
static void alpha_test_at_all_references(void)
{
    int reference, a, k;

    for (reference = 0; reference < 256; reference++) {
        const struct etch_alpha_test test = {(uint8_t)reference};

        for (a = 0; a <= 65280; a += 255) {
            struct etch_chunk c;

            open(&c, 0xFFFF);
            for (k = 0; k < ETCH_CHUNK; k++)
                c.a[k] = (uint16_t)(k < 8                          ? a
                                    : reference * 256 + k - 11 < 0 ? 0
                                                                   : reference * 256 + k - 11);
            etch_stage_alpha_gequal(&c, &test);
            for (k = 0; k < ETCH_CHUNK; k++)
                if ((c.alive >> k & 1) != (c.a[k] >= reference * 256))
                    CHECK_EQ(c.alive >> k & 1, c.a[k] >= reference * 256);
        }
    }
}

/* Clears go through the scissor and change no other byte. */
static void stencil_clears_inside_the_clip(void)
{
    static const struct etch_rect clips[] = {
        {10, 20, 17, 25}, {11, 21, 16, 24}, {12, 22, 13, 23}, {14, 22, 14, 25}, {11, 23, 15, 23}};
    const struct etch_rect window = {10, 20, 17, 25};
    static uint16_t pixels[5 * 9];
    static uint8_t plane[5 * 9];
    int x, y, k;

    for (k = 0; k < 5; k++) {
        struct etch_surface s;

        CHECK_EQ(etch_surface_init(&s, pixels, window, 9), ETCH_OK);
        for (x = 0; x < 45; x++)
            plane[x] = 7;
        s.stencil = plane;
        etch_surface_clip(&s, clips[k]);
        etch_stencil_clear(&s, 200);
        for (y = 0; y < 5; y++)
            for (x = 0; x < 9; x++)
                CHECK_EQ(plane[9 * y + x], x + 10 >= clips[k].x0 && x + 10 < clips[k].x1 &&
                                                   y + 20 >= clips[k].y0 && y + 20 < clips[k].y1
                                               ? 200
                                               : 7);
    }
}

void suite_stencil(void)
{
    RUN(stencil_functions_and_operations);
    RUN(operations_on_all_values);
    RUN(depth_functions_and_writing);
    RUN(alpha_test_at_all_references);
    RUN(stencil_clears_inside_the_clip);
}
