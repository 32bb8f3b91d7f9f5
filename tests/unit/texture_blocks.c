/* tests/unit: texture coordinates in perspective by stages: exact at every pixel, or linear between
 * multiples of 8 or 16 columns, within their bounds, held to the range of the vertices, the same
 * however a run is cut; and those of the fused kernels. */
#include "core/draw/staged.h"
#include "core/draw/texture.h"
#include "core/fragment/sampler.h"
#include "core/fragment/source_blocks.h"
#include "core/fragment/write.h"
#include "tests/harness/canvas.h"
#include "texture_parts.h"

void suite_texture_blocks(void);

static int32_t compared;

/* The coordinates of one row of pixels. */
static void source(etch_stage_function *stage, const struct texture_sample *s, int32_t x, int32_t y,
                   int32_t n, struct etch_chunk *chunk)
{
    struct etch_staged_planes planes;

    planes.texture.perspective = s->planes;
    chunk->paint = &planes.staged.paint;
    chunk->x = (int16_t)x;
    chunk->y = (int16_t)y;
    chunk->n = (uint16_t)n;
    stage(chunk, NULL);
}

static bool is_near(const int32_t c[3], int32_t got, int64_t place, int64_t near)
{
    const int64_t mine = (int64_t)got * 4096, least = texture_least(c) * 4096;
    const int64_t most = texture_most(c) * 4096;
    const int64_t held = place < least ? least : place > most ? most : place;

    return mine >= least && mine <= most && mine - held <= near && held - mine <= near;
}

/* One coordinate: exact, or on the line between the ends of its block. */
static bool is_right(const struct texture_sample *s, const int32_t c[3], int32_t got, int32_t size,
                     int32_t x, int32_t y)
{
    const int64_t bound = texture_bound(s, c, x, y);
    const int32_t start = x - x % size;

    if (size == 1 || !s->blocks)
        return is_near(c, got, texture_exact(s, c, x, y), bound + 4096);
    const int64_t from = texture_exact(s, c, start, y), to = texture_exact(s, c, start + size, y);

    return is_near(c, got, from + (to - from) * (x - start) / size, 4 * bound + (16 << 12));
}

static void stages_keep_their_bounds(void)
{
    static etch_stage_function *const stages[] = {
        etch_source_texture_perspective, etch_source_texture_blocks8, etch_source_texture_blocks16};
    static const int32_t sizes[] = {1, 8, 16};
    uint32_t seed = 91;
    int32_t i, x, y, k;

    for (i = 0; i < TEST_COUNT(900) && !test_failed(); i++) {
        const int32_t kind = i % 3;
        struct etch_chunk chunk, part;
        struct texture_sample s;

        if (!texture_sample_make(&s, i, &seed))
            continue;
        for (y = s.window.y0; y < s.window.y1; y++) {
            for (x = s.window.x0; x < s.window.x1; x++) {
                int32_t n = 0;

                while (x + n < s.window.x1 && n < 16 - x % 16 &&
                       oracle_triangle_covers(&s.exact, x + n, y))
                    n++;
                if (n == 0)
                    continue;
                source(stages[kind], &s, x, y, n, &chunk);
                for (k = 0; k < n; k++) {
                    source(stages[kind], &s, x + k, y, test_range(&seed, 1, n - k), &part);
                    compared++;
                    if (!CHECK(part.u[0] == chunk.u[k] && part.v[0] == chunk.v[k]) ||
                        !CHECK(is_right(&s, s.u, chunk.u[k], sizes[kind], x + k, y)) ||
                        !CHECK(is_right(&s, s.v, chunk.v[k], sizes[kind], x + k, y))) {
                        test_note("divides every", sizes[kind]);
                        texture_sample_note(&s, x + k, y);
                    }
                }
                x += n - 1;
            }
        }
    }
}

/* ---- stages draw what fused kernels draw ----------------------------------------------------- */

static struct test_canvas fused, staged;
static uint16_t numbers[65536];

static void pixels_are_those_of_the_fused_kernels(void)
{
    static const struct etch_texture texture = {numbers, 8, 8};
    static const struct etch_sampler sampler = {
        {etch_texels_rgb565, NULL, numbers, NULL, NULL, 256, 256, 256},
        etch_filter_nearest_power,
        NULL,
        NULL};
    static etch_varying *const varyings[] = {etch_varying_texture_perspective, NULL};
    static const struct etch_stage stages[2][4] = {{{etch_source_texture_perspective, NULL},
                                                    {etch_stage_texture_replace, &sampler},
                                                    {etch_stage_write, NULL},
                                                    {NULL, NULL}},
                                                   {{etch_source_texture_blocks16, NULL},
                                                    {etch_stage_texture_replace, &sampler},
                                                    {etch_stage_write, NULL},
                                                    {NULL, NULL}}};
    uint32_t seed = 92;
    int32_t i;

    for (i = 0; i < 65536; i++)
        numbers[i] = (uint16_t)i;
    for (i = 0; i < TEST_COUNT(1000) && !test_failed(); i++) {
        const struct etch_pipeline pipeline = {varyings, stages[i % 2], etch_kernel_staged};
        struct etch_staged_planes planes;
        struct texture_sample s;

        if (!texture_sample_make(&s, i, &seed) || (s.w[0] == s.w[1] && s.w[0] == s.w[2]))
            continue;
        const struct etch_texture_vertex *const v[3] = {&s.vertex[0], &s.vertex[1], &s.vertex[2]};
        const struct etch_vertex *const plain[3] = {&v[0]->at, &v[1]->at, &v[2]->at};

        test_canvas_open(&fused, s.window);
        etch_triangle_perspective(&fused.surface, v, &texture,
                                  i % 2 == 0 ? &etch_perspective_exact : &etch_perspective);
        test_canvas_open(&staged, s.window);
        etch_triangle_staged(&staged.surface, plain, &pipeline, &planes);
        if (!CHECK_EQ(test_canvas_hash(&staged), test_canvas_hash(&fused)))
            test_note("case", i);
        CHECK_ONCE(&staged);
    }
}

void suite_texture_blocks(void)
{
    compared = 0;
    RUN(stages_keep_their_bounds);
    RUN(pixels_are_those_of_the_fused_kernels);
    test_print_count("", compared, " pairs of coordinates by stages, none beyond its bound");
}
