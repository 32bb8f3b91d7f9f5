/* tests/unit: passes over frames that are drawn several times, or larger: accumulation and
 * supersampling against sums in 64 bits, jitter offsets by their definition, images exchanged. */
#include "core/base/rgb565.h"
#include "core/draw/shapes.h"
#include "core/draw/triangle.h"
#include "core/fragment/flat.h"
#include "core/fragment/gouraud.h"
#include "core/frame/accumulation.h"
#include "core/frame/exchange.h"
#include "core/frame/jitter.h"
#include "core/frame/supersample.h"
#include "tests/harness/canvas.h"
#include "tests/harness/shapes.h"
#include "tests/oracle/triangle.h"

void suite_passes(void);

enum {
    WIDTH = 32,
    HEIGHT = 24,
    PIXELS = WIDTH * HEIGHT,
    LARGE = 4
};

static const struct etch_rect frame = {0, 0, WIDTH, HEIGHT};
static struct test_canvas canvas, second;
static uint16_t large_pixels[PIXELS * LARGE * LARGE], sums[3 * PIXELS];

static uint32_t channel(uint16_t color, int i)
{
    return i == 0 ? color >> 11U : i == 1 ? color >> 5U & 63U : color & 31U;
}

static void fill_random(const struct etch_surface *s, uint32_t *seed)
{
    const struct etch_rect c = s->clip;
    int32_t x, y;

    for (y = c.y0; y < c.y1; y++)
        for (x = c.x0; x < c.x1; x++)
            s->pixels[etch_surface_index(s, (int16_t)x, (int16_t)y)] =
                (uint16_t)(test_range(seed, 0, 5) == 0 ? 0xFFFF : test_random(seed) >> 16);
}

/* A random part of the window. */
static struct etch_rect random_clip(struct etch_rect w, uint32_t *seed)
{
    struct etch_rect c;

    c.x0 = (int16_t)test_range(seed, w.x0, w.x1 - 1);
    c.y0 = (int16_t)test_range(seed, w.y0, w.y1 - 1);
    c.x1 = (int16_t)test_range(seed, c.x0, w.x1);
    c.y1 = (int16_t)test_range(seed, c.y0, w.y1);
    return c;
}

/* ---- accumulation ------------------------------------------------------------------------------ */

/* Sums as they should be, per channel of each pixel. */
static uint64_t expected[3 * PIXELS];

static void expect(const struct etch_surface *s, uint16_t weight, bool load)
{
    int32_t x, y, i;

    for (y = s->clip.y0; y < s->clip.y1; y++) {
        for (x = s->clip.x0; x < s->clip.x1; x++) {
            for (i = 0; i < 3; i++) {
                uint64_t *sum = &expected[3 * (y * WIDTH + x) + i];
                const uint16_t c = s->pixels[etch_surface_index(s, (int16_t)x, (int16_t)y)];

                *sum = (load ? 0 : *sum) + (uint64_t)channel(c, i) * weight;
                *sum = *sum < 65535 ? *sum : 65535;
            }
        }
    }
}

static void check_sums(void)
{
    int32_t i, wrong = 0;

    for (i = 0; i < 3 * PIXELS; i++)
        wrong += sums[i] != expected[i];
    CHECK_EQ(wrong, 0);
}

static void check_returned(const struct etch_surface *s, uint32_t divisor, bool swapped)
{
    int32_t x, y, i, wrong = 0;

    for (y = s->clip.y0; y < s->clip.y1; y++) {
        for (x = s->clip.x0; x < s->clip.x1; x++) {
            uint16_t got = s->pixels[etch_surface_index(s, (int16_t)x, (int16_t)y)];

            if (swapped)
                got = etch_rgb565_swap(got);
            for (i = 0; i < 3; i++) {
                const uint64_t n = (2 * expected[3 * (y * WIDTH + x) + i] + divisor) /
                                   (2 * divisor);
                const uint64_t most = i == 1 ? 63 : 31;

                wrong += channel(got, i) != (n < most ? n : most);
            }
        }
    }
    if (!CHECK_EQ(wrong, 0))
        test_note("divisor", divisor);
}

static void accumulation_is_the_exact_weighted_average(void)
{
    const int32_t count = TEST_COUNT(400);
    uint32_t seed = 1;
    int32_t n, i;

    for (n = 0; n < count && !test_failed(); n++) {
        const int32_t frames = test_range(&seed, 1, 20);
        const int32_t most = n % 4 == 3 ? 65535 : 1040 / frames;
        struct etch_accumulation a;
        uint32_t weights = 0;

        for (i = 0; i < 3 * PIXELS; i++)
            expected[i] = sums[i] = 0;
        CHECK_EQ(etch_accumulation_init(&a, sums, frame, WIDTH), ETCH_OK);
        test_canvas_open(&canvas, frame);
        for (i = 0; i < frames; i++) {
            const uint16_t weight = (uint16_t)test_range(&seed, 0, most);

            if (n % 2 == 1)
                test_canvas_clip(&canvas, random_clip(frame, &seed));
            fill_random(&canvas.surface, &seed);
            expect(&canvas.surface, weight, i == 0);
            weights += weight;
            (i == 0 ? etch_accumulation_load : etch_accumulation_add)(&a, &canvas.surface, weight);
        }
        check_sums();
        if (n % 4 >= 2 || weights == 0 || weights > 65535)
            weights = (uint32_t)test_range(&seed, 1, n % 4 == 2 ? 300 : 65535);
        test_canvas_wipe(&canvas);
        (n % 3 == 0 ? etch_accumulation_return_swapped
                    : etch_accumulation_return)(&a, &canvas.surface, (uint16_t)weights);
        CHECK_ONCE(&canvas);
        check_returned(&canvas.surface, weights, n % 3 == 0);
    }
}

/* Every sum and divisor that 8-bit weights make, and the largest. */
static void returning_rounds_every_sum_once(void)
{
    struct etch_accumulation a;
    uint32_t divisor, i, n;

    CHECK_EQ(etch_accumulation_init(&a, sums, frame, WIDTH), ETCH_OK);
    test_canvas_open(&canvas, frame);
    for (n = 1; n <= (uint32_t)TEST_COUNT(300) && !test_failed(); n++) {
        divisor = n < 290 ? n : n < 295 ? 65535 - n : 1040 + n;
        for (i = 0; i < 3 * PIXELS; i++)
            expected[i] = sums[i] = (uint16_t)(i < 2000 ? i * divisor / 31 : 65535 - i);
        etch_accumulation_return(&a, &canvas.surface, (uint16_t)divisor);
        check_returned(&canvas.surface, divisor, false);
    }
    test_canvas_wipe(&canvas);
    etch_accumulation_return(&a, &canvas.surface, 0); /* nothing */
    CHECK(!test_canvas_drawn(&canvas, 0, 0));
}

static void sums_are_multiplied_by_a_fraction(void)
{
    const int32_t count = TEST_COUNT(200);
    uint32_t seed = 2;
    int32_t n, i, wrong = 0;
    struct etch_accumulation a;

    CHECK_EQ(etch_accumulation_init(&a, sums, frame, WIDTH), ETCH_OK);
    for (n = 0; n < count; n++) {
        const struct etch_rect area = n % 3 == 0 ? frame : random_clip(frame, &seed);
        const uint16_t up = (uint16_t)test_range(&seed, 0, n % 2 == 0 ? 16 : 65535);
        const uint16_t down = (uint16_t)test_range(&seed, 0, n % 2 == 0 ? 16 : 65535);

        for (i = 0; i < 3 * PIXELS; i++) {
            const int32_t x = i / 3 % WIDTH, y = i / 3 / WIDTH;
            const bool inside = x >= area.x0 && x < area.x1 && y >= area.y0 && y < area.y1;
            uint64_t v = sums[i] = (uint16_t)(test_random(&seed) >> 16);

            if (inside && down != 0)
                v = (v * up * 2 + down) / (2ULL * down);
            expected[i] = v < 65535 ? v : 65535;
        }
        etch_accumulation_multiply(&a, area, up, down);
        for (i = 0; i < 3 * PIXELS; i++)
            wrong += sums[i] != expected[i];
    }
    CHECK_EQ(wrong, 0);
}

static void accumulation_refuses_what_is_no_plane(void)
{
    struct etch_accumulation a;
    const struct etch_rect none = {4, 4, 4, 8}, left = {-1, 0, 3, 3};

    CHECK_EQ(etch_accumulation_init(&a, NULL, frame, WIDTH), ETCH_EINVAL);
    CHECK_EQ(etch_accumulation_init(&a, sums, none, WIDTH), ETCH_EINVAL);
    CHECK_EQ(etch_accumulation_init(&a, sums, left, WIDTH), ETCH_EINVAL);
    CHECK_EQ(etch_accumulation_init(&a, sums, frame, WIDTH - 1), ETCH_EINVAL);
}

/* ---- supersampling ------------------------------------------------------------------------------- */

typedef void resolve_function(const struct etch_surface *large, const struct etch_surface *out);

static resolve_function *const resolve[3][2] = {
    {etch_supersample_resolve_2, etch_supersample_resolve_2_swapped},
    {etch_supersample_resolve_3, etch_supersample_resolve_3_swapped},
    {etch_supersample_resolve_4, etch_supersample_resolve_4_swapped}};

static struct etch_surface large_surface(struct etch_rect window, uint8_t n)
{
    struct etch_surface s;

    CHECK_EQ(etch_surface_init(&s, large_pixels, etch_supersample_window(window, n),
                               (uint16_t)((window.x1 - window.x0) * n)),
             ETCH_OK);
    return s;
}

static void check_resolved(const struct etch_surface *large, int32_t n, bool swapped)
{
    const struct etch_rect c = canvas.surface.clip;
    int32_t x, y, i, j, k, wrong = 0;

    for (y = c.y0; y < c.y1; y++) {
        for (x = c.x0; x < c.x1; x++) {
            uint16_t got = test_canvas_at(&canvas, x, y);

            if (swapped)
                got = etch_rgb565_swap(got);
            for (k = 0; k < 3; k++) {
                uint32_t sum = 0;

                for (j = 0; j < n; j++)
                    for (i = 0; i < n; i++)
                        sum += channel(large->pixels[etch_surface_index(large, (int16_t)(n * x + i),
                                                                        (int16_t)(n * y + j))],
                                       k);
                wrong += channel(got, k) != (2 * sum + (uint32_t)(n * n)) / (uint32_t)(2 * n * n);
            }
        }
    }
    CHECK_EQ(wrong, 0);
}

static void supersampling_is_the_exact_average(void)
{
    const int32_t count = TEST_COUNT(120);
    uint32_t seed = 3;
    int32_t i;

    for (i = 0; i < count && !test_failed(); i++) {
        const uint8_t n = (uint8_t)(2 + i % 3);
        const bool swapped = i % 2 == 1;
        const int16_t x = (int16_t)(i % 5 * 11), y = (int16_t)(i % 7 * 9);
        const struct etch_rect window = {x, y, (int16_t)(x + WIDTH), (int16_t)(y + HEIGHT)};
        const struct etch_surface large = large_surface(window, n);

        test_canvas_open(&canvas, window);
        if (i % 4 >= 2)
            test_canvas_clip(&canvas, random_clip(window, &seed));
        fill_random(&large, &seed);
        resolve[n - 2][swapped](&large, &canvas.surface);
        CHECK_ONCE(&canvas);
        check_resolved(&large, n, swapped);
    }
}

/* White on black: a pixel is the number of its samples that the large triangle covers. */
static void supersampled_coverage_counts_samples(void)
{
    const int32_t count = TEST_COUNT(600);
    uint32_t seed = 4;
    int32_t t, x, y, i, k, wrong = 0;

    for (t = 0; t < count; t++) {
        const uint8_t n = (uint8_t)(2 + t % 3);
        const struct etch_surface large = large_surface(frame, n);
        struct etch_vertex vertex[3];
        const struct etch_vertex *const v[3] = {&vertex[0], &vertex[1], &vertex[2]};
        struct test_triangle s;
        struct oracle_triangle o;

        test_triangle_make(&s, (enum test_triangle_kind)(t / 3 % 3), frame, &seed);
        for (k = 0; k < 3; k++) {
            vertex[k] = (struct etch_vertex){s.x[k] *= n, s.y[k] *= n, 0, 255, 255, 255, 255};
        }
        oracle_triangle_make(&o, s.x, s.y);
        etch_surface_clear(&large, 0);
        etch_triangle_flat(&large, v, etch_kernel_flat);
        test_canvas_open(&canvas, frame);
        resolve[n - 2][0](&large, &canvas.surface);
        for (y = 0; y < HEIGHT; y++) {
            for (x = 0; x < WIDTH; x++) {
                int32_t covered = 0;

                for (i = 0; i < n * n; i++)
                    covered += oracle_triangle_covers(&o, n * x + i % n, n * y + i / n);
                wrong += (int32_t)channel(test_canvas_at(&canvas, x, y), 0) !=
                         (2 * 31 * covered + n * n) / (2 * n * n);
            }
        }
    }
    CHECK_EQ(wrong, 0);
}

/* ---- a mesh of one colour has no seams ------------------------------------------------------------ */

enum {
    CELLS = 5,
    POINTS = (CELLS + 1) * (CELLS + 1)
};

/* Corners of a grid, the inner ones moved about, over pixels 3 .. WIDTH - 4 and 3 .. HEIGHT - 4. */
static struct etch_vertex corner[POINTS];

static void make_mesh(uint32_t *seed)
{
    int32_t i, k;

    for (k = 0; k <= CELLS; k++) {
        for (i = 0; i <= CELLS; i++) {
            const bool inner = i > 0 && i < CELLS && k > 0 && k < CELLS;
            struct etch_vertex *v = &corner[k * (CELLS + 1) + i];

            *v = (struct etch_vertex){.r = 200, .g = 120, .b = 40, .a = 255};
            v->x_q8 = 768 + i * (WIDTH - 6) * 256 / CELLS;
            v->y_q8 = 768 + k * (HEIGHT - 6) * 256 / CELLS;
            v->x_q8 += inner ? test_range(seed, -400, 400) : 0;
            v->y_q8 += inner ? test_range(seed, -300, 300) : 0;
        }
    }
}

/* Draws it n times as large, moved by a jitter offset. */
static void draw_mesh(const struct etch_surface *s, int32_t n, struct etch_offset_q8 offset)
{
    int32_t t, k;

    for (t = 0; t < 2 * CELLS * CELLS; t++) {
        const int32_t at = t / 2 / CELLS * (CELLS + 1) + t / 2 % CELLS;
        const int32_t index[3] = {t % 2 == 0 ? at : at + CELLS + 2, at + 1, at + CELLS + 1};
        struct etch_vertex vertex[3];
        const struct etch_vertex *const v[3] = {&vertex[0], &vertex[1], &vertex[2]};

        for (k = 0; k < 3; k++) {
            vertex[k] = etch_vertex_jitter(&corner[index[k]], offset);
            vertex[k].x_q8 *= n;
            vertex[k].y_q8 *= n;
        }
        etch_triangle_gouraud(s, v, etch_kernel_gouraud);
    }
}

/* The mesh's rectangle is one colour and what is about it the background. */
static void check_seamless(void)
{
    const uint16_t color = etch_rgb565(200, 120, 40);
    int32_t x, y, wrong = 0;

    for (y = 0; y < HEIGHT; y++) {
        for (x = 0; x < WIDTH; x++) {
            const bool inside = x >= 3 && x < WIDTH - 3 && y >= 3 && y < HEIGHT - 3;

            wrong += test_canvas_at(&canvas, x, y) != (inside ? color : 0xFFFF);
        }
    }
    CHECK_EQ(wrong, 0);
}

static void seamless_by_supersampling(void)
{
    const struct etch_offset_q8 none = {0, 0};
    const int32_t count = TEST_COUNT(60);
    uint32_t seed = 5;
    int32_t i;

    for (i = 0; i < count && !test_failed(); i++) {
        const uint8_t n = (uint8_t)(2 + i % 3);
        const struct etch_surface large = large_surface(frame, n);

        make_mesh(&seed);
        etch_surface_clear(&large, 0xFFFF);
        draw_mesh(&large, n, none);
        test_canvas_open(&canvas, frame);
        resolve[n - 2][0](&large, &canvas.surface);
        check_seamless();
    }
}

static const struct {
    const struct etch_offset_q8 *offset;
    int32_t n;
} jitters[] = {{etch_jitter_2, 2}, {etch_jitter_4, 4}, {etch_jitter_8, 8}, {etch_jitter_16, 16}};

static void seamless_by_accumulation(void)
{
    const int32_t count = TEST_COUNT(40);
    struct etch_accumulation a;
    uint32_t seed = 6;
    int32_t i, k;

    CHECK_EQ(etch_accumulation_init(&a, sums, frame, WIDTH), ETCH_OK);
    test_canvas_open(&canvas, frame);
    for (i = 0; i < count && !test_failed(); i++) {
        make_mesh(&seed);
        for (k = 0; k < jitters[i % 4].n; k++) {
            etch_surface_clear(&canvas.surface, 0xFFFF);
            draw_mesh(&canvas.surface, 1, jitters[i % 4].offset[k]);
            (k == 0 ? etch_accumulation_load : etch_accumulation_add)(&a, &canvas.surface, 1);
        }
        etch_accumulation_return(&a, &canvas.surface, (uint16_t)jitters[i % 4].n);
        check_seamless();
    }
}

/* ---- jitter ---------------------------------------------------------------------------------------- */

static void offsets_take_every_row_and_column_once(void)
{
    int32_t j, i;

    for (j = 0; j < 4; j++) {
        const int32_t n = jitters[j].n;
        int32_t x = 0, y = 0, columns = 0, rows = 0;

        for (i = 0; i < n; i++) {
            const struct etch_offset_q8 o = jitters[j].offset[i];

            x += o.x;
            y += o.y;
            columns |= 1 << (o.x + 128) * n / 256;
            rows |= 1 << (o.y + 128) * n / 256;
            CHECK_EQ((o.x + 128) * n % 256, 128); /* the middle of its column */
            CHECK_EQ((o.y + 128) * n % 256, 128);
        }
        CHECK_EQ(x, 0);
        CHECK_EQ(y, 0);
        CHECK_EQ(columns, (1 << n) - 1);
        CHECK_EQ(rows, (1 << n) - 1);
    }
}

static struct etch_vertex caught[3];
static int caught_count;

static void catch_triangle(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    (void)sink;
    for (caught_count = 0; caught_count < 3; caught_count++)
        caught[caught_count] = *v[caught_count];
}

static void catch_line(struct etch_sink *sink, const struct etch_vertex *const v[2])
{
    (void)sink;
    for (caught_count = 0; caught_count < 2; caught_count++)
        caught[caught_count] = *v[caught_count];
}

static void catch_point(struct etch_sink *sink, const struct etch_vertex *v)
{
    (void)sink;
    caught[0] = *v;
    caught_count = 1;
}

static void the_jitter_sink_moves_every_vertex(void)
{
    static const struct etch_vertex vertex[3] = {
        {10, 20, 30, 1, 2, 3, 4}, {-10, 0, 31, 5, 6, 7, 8}, {99, 98, 97, 96, 95, 94, 93}};
    const struct etch_vertex *const v[3] = {&vertex[0], &vertex[1], &vertex[2]};
    struct etch_sink sink = {catch_triangle, catch_line, catch_point};
    const struct etch_offset_q8 offset = {-96, 32};
    struct etch_jitter_sink jitter;
    int n, i;

    etch_jitter_sink_init(&jitter, &sink, offset);
    for (n = 1; n <= 3; n++) {
        if (n == 1)
            jitter.sink.point(&jitter.sink, v[0]);
        else if (n == 2)
            jitter.sink.line(&jitter.sink, v);
        else
            jitter.sink.triangle(&jitter.sink, v);
        CHECK_EQ(caught_count, n);
        for (i = 0; i < n; i++) {
            CHECK_EQ(caught[i].x_q8, vertex[i].x_q8 + 96);
            CHECK_EQ(caught[i].y_q8, vertex[i].y_q8 - 32);
            CHECK_EQ(caught[i].z_q16, vertex[i].z_q16);
            CHECK_EQ(caught[i].g, vertex[i].g);
            CHECK_EQ(caught[i].a, vertex[i].a);
        }
    }
}

/* ---- exchange -------------------------------------------------------------------------------------- */

static void images_are_exchanged_inside_both_clips(void)
{
    static uint16_t a[PIXELS], b[PIXELS];
    const struct etch_rect moved = {7, 5, 7 + WIDTH, 5 + HEIGHT};
    const int32_t count = TEST_COUNT(100);
    uint32_t seed = 7;
    int32_t n, x, y, wrong = 0;

    for (n = 0; n < count; n++) {
        const struct etch_rect ca = random_clip(frame, &seed), cb = random_clip(moved, &seed);

        test_canvas_open(&canvas, frame);
        test_canvas_open(&second, moved);
        fill_random(&canvas.surface, &seed);
        fill_random(&second.surface, &seed);
        for (y = 0; y < HEIGHT; y++) {
            for (x = 0; x < WIDTH; x++) {
                a[y * WIDTH + x] = test_canvas_at(&canvas, x, y);
                b[y * WIDTH + x] = test_canvas_at(&second, x + 7, y + 5);
            }
        }
        etch_surface_clip(&canvas.surface, ca);
        etch_surface_clip(&second.surface, cb);
        (n % 3 == 0   ? etch_surface_exchange
         : n % 3 == 1 ? etch_surface_xor
                      : etch_surface_copy)(&canvas.surface, &second.surface);
        for (y = 0; y < HEIGHT + 5; y++) {
            for (x = 0; x < WIDTH + 7; x++) {
                const bool both = x >= ca.x0 && x < ca.x1 && y >= ca.y0 && y < ca.y1 &&
                                  x >= cb.x0 && x < cb.x1 && y >= cb.y0 && y < cb.y1;
                const bool in_a = x < WIDTH && y < HEIGHT, in_b = x >= 7 && y >= 5;
                const uint16_t pa = in_a ? a[y * WIDTH + x] : 0;
                const uint16_t pb = in_b ? b[(y - 5) * WIDTH + x - 7] : 0;
                const uint16_t want = n % 3 == 1 ? (uint16_t)(pa ^ pb) : pb;

                if (in_a)
                    wrong += test_canvas_at(&canvas, x, y) != (both ? want : pa);
                if (in_b)
                    wrong += test_canvas_at(&second, x, y) != (both && n % 3 == 0 ? pa : pb);
            }
        }
    }
    CHECK_EQ(wrong, 0);
}

static void an_image_exchanged_with_itself_stays(void)
{
    uint32_t seed = 8, hash;

    test_canvas_open(&canvas, frame);
    fill_random(&canvas.surface, &seed);
    hash = test_canvas_hash(&canvas);
    etch_surface_exchange(&canvas.surface, &canvas.surface);
    etch_surface_copy(&canvas.surface, &canvas.surface);
    CHECK_EQ(test_canvas_hash(&canvas), hash);
}

void suite_passes(void)
{
    RUN(accumulation_is_the_exact_weighted_average);
    RUN(returning_rounds_every_sum_once);
    RUN(sums_are_multiplied_by_a_fraction);
    RUN(accumulation_refuses_what_is_no_plane);
    RUN(supersampling_is_the_exact_average);
    RUN(supersampled_coverage_counts_samples);
    RUN(seamless_by_supersampling);
    RUN(seamless_by_accumulation);
    RUN(offsets_take_every_row_and_column_once);
    RUN(the_jitter_sink_moves_every_vertex);
    RUN(images_are_exchanged_inside_both_clips);
    RUN(an_image_exchanged_with_itself_stays);
    test_print_count("", TEST_COUNT(600), " supersampled triangles counted sample by sample");
}
