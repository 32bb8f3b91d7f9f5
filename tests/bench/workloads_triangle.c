/* bench/workloads_triangle.c: W6..W11, the small and the big triangles in each way of shading.
 * Colours and positions are converted beforehand to what the calls take. See bench.h. */
#include "bench.h"

#include "../../core/draw/shapes.h"
#include "../../core/draw/triangle.h"
#include "../../core/fragment/flat.h"
#include "../../core/fragment/gouraud.h"

static wl_tri triangles[WL_NSMALL];
static struct etch_vertex vertices[WL_NSMALL][3];

static void convert(int n)
{
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 3; k++) {
            const wl_tri *t = &triangles[i];
            struct etch_vertex *v = &vertices[i][k];

            v->x_q8 = t->x[k] * 256 + 128;
            v->y_q8 = t->y[k] * 256 + 128;
            v->z_q16 = (uint32_t)t->z[k] << 16;
            v->r = (uint8_t)wl_r8(t->c[k]);
            v->g = (uint8_t)wl_g8(t->c[k]);
            v->b = (uint8_t)wl_b8(t->c[k]);
            v->a = 255;
        }
}

static void prepare_small(void)
{
    wl_make_small(triangles);
    convert(WL_NSMALL);
}

static void prepare_big(void)
{
    wl_make_big(triangles);
    convert(WL_NBIG);
}

static inline void fill(const struct etch_surface *s, int n)
{
    for (const wl_tri *t = triangles; t < triangles + n; t++)
        etch_triangle_fill(s, t->x[0], t->y[0], t->x[1], t->y[1], t->x[2], t->y[2], t->c[0]);
}

static inline void paint(const struct etch_surface *s, int n, etch_triangle_painter *painter,
                         etch_kernel *kernel)
{
    for (int i = 0; i < n; i++) {
        const struct etch_vertex *const v[3] = {&vertices[i][0], &vertices[i][1], &vertices[i][2]};
        painter(s, v, kernel);
    }
}

static void draw_small_flat(const struct etch_surface *s, uint8_t frame)
{
    (void)frame;
    fill(s, WL_NSMALL);
}

static void draw_big_flat(const struct etch_surface *s, uint8_t frame)
{
    (void)frame;
    fill(s, WL_NBIG);
}

static void draw_small_gouraud(const struct etch_surface *s, uint8_t frame)
{
    (void)frame;
    paint(s, WL_NSMALL, etch_triangle_gouraud, etch_kernel_gouraud);
}

static void draw_big_gouraud(const struct etch_surface *s, uint8_t frame)
{
    (void)frame;
    paint(s, WL_NBIG, etch_triangle_gouraud, etch_kernel_gouraud);
}

static void draw_big_flat_depth(const struct etch_surface *s, uint8_t frame)
{
    (void)frame;
    paint(s, WL_NBIG, etch_triangle_flat_depth, etch_kernel_flat_less);
}

static void draw_big_gouraud_depth(const struct etch_surface *s, uint8_t frame)
{
    (void)frame;
    paint(s, WL_NBIG, etch_triangle_gouraud_depth, etch_kernel_gouraud_less);
}

const struct bench_workload bench_w6 = {1, false, prepare_small, draw_small_flat};
const struct bench_workload bench_w7 = {1, false, prepare_big, draw_big_flat};
const struct bench_workload bench_w8 = {1, false, prepare_small, draw_small_gouraud};
const struct bench_workload bench_w9 = {1, false, prepare_big, draw_big_gouraud};
const struct bench_workload bench_w10 = {1, true, prepare_big, draw_big_flat_depth};
const struct bench_workload bench_w11 = {1, true, prepare_big, draw_big_gouraud_depth};
