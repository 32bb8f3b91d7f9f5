/* tests/unit: a user's own pixel work: a shader through the one-line macro, a kernel without it,
 * and a function of the barycentric weights. */
#include "core/draw/shapes.h"
#include "core/draw/triangle.h"
#include "core/fragment/template.h"
#include "core/raster/triangle.h"
#include "tests/harness/canvas.h"

void suite_kernel_user(void);

static struct test_canvas canvas;

/* A shader of three small functions: a chequered flag in two colours. */
struct chequer_paint {
    struct etch_paint paint;
    uint16_t color[2];
};

static inline void chequer_start(struct etch_fragment *f, const struct etch_paint *paint)
{
    (void)paint;
    f->v[0] = (uint32_t)(f->x + f->y) & 1;
}

static inline void chequer_step(struct etch_fragment *f, const struct etch_paint *paint)
{
    (void)paint;
    f->v[0] ^= 1;
}

static inline uint16_t chequer_color(const struct etch_fragment *f, const struct etch_paint *paint)
{
    return ((const struct chequer_paint *)paint)->color[f->v[0]];
}

static const struct etch_shader chequer = {chequer_start, chequer_step, chequer_color};
etch_kernel chequer_kernel;
ETCH_KERNEL(chequer_kernel, chequer, NULL, false)

static void shader_of_ones_own(void)
{
    const struct chequer_paint flag = {{chequer_kernel}, {1, 2}};
    const struct etch_point_q8 v[3] = {{0, 0}, {6 * 256, 0}, {0, 4 * 256}};
    const struct etch_rect window = {0, 0, 7, 4};
    struct etch_triangle t;

    test_canvas_open(&canvas, window);
    CHECK(etch_triangle_setup(&t, v));
    etch_triangle_runs(&canvas.surface, &t, &flag.paint);
    CHECK_PICTURE(&canvas, "ababa.."
                           "baba..."
                           "ab....."
                           "b......");
    CHECK_ONCE(&canvas);
}

/* A kernel without the template: exchanges background and ink. */
static void invert_kernel(const struct etch_surface *s, int16_t y0, const struct etch_run *runs,
                          uint8_t n, const struct etch_paint *paint)
{
    uint8_t i;

    (void)paint;
    for (i = 0; i < n; i++) {
        uint16_t *row = s->pixels + etch_surface_index(s, runs[i].x0, (int16_t)(y0 + i));
        int16_t x;

        for (x = runs[i].x0; x < runs[i].x1; x++, row++)
            *row = *row == TEST_BACKGROUND ? TEST_INK : TEST_BACKGROUND;
    }
}

static void kernel_without_the_template(void)
{
    const struct etch_paint invert = {invert_kernel};
    const struct etch_point_q8 v[3] = {{0, 0}, {4 * 256, 0}, {0, 4 * 256}};
    const struct etch_rect window = {0, 0, 5, 4};
    struct etch_triangle t;

    test_canvas_open(&canvas, window);
    etch_rect_fill(&canvas.surface, 1, 0, 2, 4, TEST_INK);
    CHECK(etch_triangle_setup(&t, v));
    etch_triangle_runs(&canvas.surface, &t, &invert);
    CHECK_PICTURE(&canvas, "#...."
                           "#.#.."
                           "###.."
                           ".##..");
}

/* The weights name the caller's vertices: each pixel in the letter of the nearest. */
static uint16_t heaviest(void *context, int16_t x, int16_t y, const uint32_t b_q16[3])
{
    uint16_t best = 0, i;

    CHECK(context == (void *)&canvas);
    CHECK(x >= 0 && x < 9 && y >= 0 && y < 5);
    for (i = 1; i < 3; i++)
        if (b_q16[i] > b_q16[best])
            best = i;
    return (uint16_t)(best + 1);
}

static void function_of_the_weights(void)
{
    const struct etch_vertex a = {0, 0, 0, 0, 0, 0, 0}, b = {9 * 256, 0, 0, 0, 0, 0, 0};
    const struct etch_vertex c = {0, 5 * 256, 0, 0, 0, 0, 0};
    const struct etch_vertex *const abc[3] = {&a, &b, &c};
    const struct etch_vertex *const bca[3] = {&b, &c, &a};
    const struct etch_rect window = {0, 0, 9, 5};

    test_canvas_open(&canvas, window);
    etch_triangle_barycentric(&canvas.surface, abc, heaviest, &canvas);
    CHECK_PICTURE(&canvas, "aaaabbbb."
                           "aaabbb..."
                           "cccc....."
                           "ccc......"
                           "c........");
    CHECK_ONCE(&canvas);
    test_canvas_wipe(&canvas);
    etch_triangle_barycentric(&canvas.surface, bca, heaviest, &canvas);
    CHECK_PICTURE(&canvas, "ccccaaaa."
                           "cccaaa..."
                           "bbbb....."
                           "bbb......"
                           "b........");
}

void suite_kernel_user(void)
{
    RUN(shader_of_ones_own);
    RUN(kernel_without_the_template);
    RUN(function_of_the_weights);
}
