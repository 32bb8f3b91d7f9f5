/* tests/unit: frames drawn larger and averaged, against sums in 64 bits; meshes of one colour have
 * no seams, by supersampling and by accumulation. */
#include "core/base/rgb565.h"
#include "core/draw/shapes.h"
#include "core/draw/triangle.h"
#include "core/fragment/flat.h"
#include "core/fragment/gouraud.h"
#include "core/frame/accumulation.h"
#include "core/frame/jitter.h"
#include "core/frame/supersample.h"
#include "tests/harness/canvas.h"
#include "tests/harness/shapes.h"
#include "tests/oracle/triangle.h"
#include "tests/unit/passes_parts.h"

void suite_supersample(void);

static struct test_canvas canvas;
static uint16_t large_pixels[PIXELS * LARGE * LARGE], sums[3 * PIXELS];

/* ---- supersampling
 * ------------------------------------------------------------------------------- */

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

/* ---- a mesh of one colour has no seams
 * ------------------------------------------------------------ */

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

void suite_supersample(void)
{
    RUN(supersampling_is_the_exact_average);
    RUN(supersampled_coverage_counts_samples);
    RUN(seamless_by_supersampling);
    RUN(seamless_by_accumulation);
}
