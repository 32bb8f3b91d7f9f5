/* tests/fuzz: painted triangles, lines and points: every painter with every kernel that fits it. */
#include "calls.h"

#include "core/draw/triangle_small.h"
#include "core/fragment/flat_small.h"
#include "core/fragment/gouraud_small.h"

typedef const struct etch_vertex *const vertices[3];

/* A painter with one of `n` kernels. */
static void paint(struct fuzz_calls *c, fuzz_function *painter, etch_kernel *const *kernels,
                  uint16_t n)
{
    etch_kernel *kernel = kernels[fuzz_below(c, n)];
    const struct etch_vertex v[3] = {fuzz_vertex(c), fuzz_vertex(c), fuzz_vertex(c)};
    const vertices p = {&v[0], &v[1], &v[2]};

    ((etch_triangle_painter *)painter)(&c->s, p, kernel);
}

#define COUNT(list) (uint16_t)(sizeof(list) / sizeof(list)[0])

static void flat(struct fuzz_calls *c, fuzz_function *f)
{
    static etch_kernel *const kernels[] = {etch_kernel_flat, etch_kernel_flat_small};

    paint(c, f, kernels, COUNT(kernels));
}

static void flat_depth(struct fuzz_calls *c, fuzz_function *f)
{
    static etch_kernel *const kernels[] = {etch_kernel_flat_less, etch_kernel_flat_lequal};

    paint(c, f, kernels, COUNT(kernels));
}

static void flat_exact(struct fuzz_calls *c, fuzz_function *f)
{
    static etch_kernel *const kernels[] = {etch_kernel_flat_exact_less,
                                           etch_kernel_flat_exact_lequal};

    paint(c, f, kernels, COUNT(kernels));
}

static void flat_inverse(struct fuzz_calls *c, fuzz_function *f)
{
    static etch_kernel *const kernels[] = {etch_kernel_flat_inverse_less,
                                           etch_kernel_flat_inverse_lequal};

    paint(c, f, kernels, COUNT(kernels));
}

static void flat_blend(struct fuzz_calls *c, fuzz_function *f)
{
    static etch_kernel *const kernels[] = {etch_kernel_flat_blend, etch_kernel_flat_blend_swapped};

    paint(c, f, kernels, COUNT(kernels));
}

static void dither(struct fuzz_calls *c, fuzz_function *f)
{
    static etch_kernel *const kernels[] = {etch_kernel_gouraud_dither,
                                           etch_kernel_gouraud_dither_swapped};

    paint(c, f, kernels, COUNT(kernels));
}

static void dither_depth(struct fuzz_calls *c, fuzz_function *f)
{
    static etch_kernel *const kernels[] = {
        etch_kernel_gouraud_dither_less, etch_kernel_gouraud_dither_lequal,
        etch_kernel_gouraud_dither_less_swapped, etch_kernel_gouraud_dither_lequal_swapped};

    paint(c, f, kernels, COUNT(kernels));
}

static void gouraud(struct fuzz_calls *c, fuzz_function *f)
{
    static etch_kernel *const kernels[] = {
        etch_kernel_gouraud, etch_kernel_gouraud_swapped, etch_kernel_gouraud_dither,
        etch_kernel_gouraud_dither_swapped, etch_kernel_gouraud_small};

    paint(c, f, kernels, COUNT(kernels));
}

static void gouraud_depth(struct fuzz_calls *c, fuzz_function *f)
{
    static etch_kernel *const kernels[] = {
        etch_kernel_gouraud_less,         etch_kernel_gouraud_lequal,
        etch_kernel_gouraud_less_swapped, etch_kernel_gouraud_lequal_swapped,
        etch_kernel_gouraud_dither_less,  etch_kernel_gouraud_dither_lequal,
        etch_kernel_gouraud_less_small,
    };

    paint(c, f, kernels, COUNT(kernels));
}

static void gouraud_exact(struct fuzz_calls *c, fuzz_function *f)
{
    static etch_kernel *const kernels[] = {etch_kernel_gouraud_exact,
                                           etch_kernel_gouraud_exact_swapped};

    paint(c, f, kernels, COUNT(kernels));
}

static void gouraud_depth_exact(struct fuzz_calls *c, fuzz_function *f)
{
    static etch_kernel *const kernels[] = {
        etch_kernel_gouraud_exact_less, etch_kernel_gouraud_exact_lequal,
        etch_kernel_gouraud_exact_less_swapped, etch_kernel_gouraud_exact_lequal_swapped};

    paint(c, f, kernels, COUNT(kernels));
}

static void gouraud_inverse(struct fuzz_calls *c, fuzz_function *f)
{
    static etch_kernel *const kernels[] = {
        etch_kernel_gouraud_inverse_less, etch_kernel_gouraud_inverse_lequal,
        etch_kernel_gouraud_inverse_less_swapped, etch_kernel_gouraud_inverse_lequal_swapped};

    paint(c, f, kernels, COUNT(kernels));
}

static void gouraud_blend(struct fuzz_calls *c, fuzz_function *f)
{
    static etch_kernel *const kernels[] = {etch_kernel_gouraud_blend,
                                           etch_kernel_gouraud_blend_swapped};

    paint(c, f, kernels, COUNT(kernels));
}

static void gouraud_fade(struct fuzz_calls *c, fuzz_function *f)
{
    static etch_kernel *const kernels[] = {etch_kernel_gouraud_fade,
                                           etch_kernel_gouraud_fade_swapped};

    paint(c, f, kernels, COUNT(kernels));
}

static uint16_t weighted(void *context, int16_t x, int16_t y, const uint32_t b_q16[3])
{
    (void)context;
    if (b_q16[0] > 65536 || b_q16[1] > 65536 || b_q16[2] > 65536) {
        fuzz_fail("a weight above 1");
    }
    return (uint16_t)((b_q16[0] ^ b_q16[1] ^ (uint16_t)x ^ (uint16_t)y) & 0xFFFF);
}

static void barycentric(struct fuzz_calls *c, fuzz_function *f)
{
    const struct etch_vertex v[3] = {fuzz_vertex(c), fuzz_vertex(c), fuzz_vertex(c)};
    const vertices p = {&v[0], &v[1], &v[2]};

    (void)f;
    etch_triangle_barycentric(&c->s, p, weighted, NULL);
}

/* ---- lines and points ------------------------------------------------------------------------ */

static void line(struct fuzz_calls *c, etch_line_painter *painter, etch_kernel *const *kernels)
{
    etch_kernel *kernel = kernels[fuzz_byte(c) % 2];
    const struct etch_vertex v[2] = {fuzz_vertex(c), fuzz_vertex(c)};
    const struct etch_vertex *const p[2] = {&v[0], &v[1]};

    painter(&c->s, p, kernel);
}

static void line_flat_depth(struct fuzz_calls *c, fuzz_function *f)
{
    static etch_kernel *const kernels[] = {etch_kernel_flat_less, etch_kernel_flat_lequal};

    line(c, (etch_line_painter *)f, kernels);
}

static void line_gouraud(struct fuzz_calls *c, fuzz_function *f)
{
    static etch_kernel *const kernels[] = {etch_kernel_gouraud, etch_kernel_gouraud_swapped};

    line(c, (etch_line_painter *)f, kernels);
}

static void line_gouraud_depth(struct fuzz_calls *c, fuzz_function *f)
{
    static etch_kernel *const kernels[] = {etch_kernel_gouraud_less, etch_kernel_gouraud_lequal};

    line(c, (etch_line_painter *)f, kernels);
}

static void line_wide(struct fuzz_calls *c, fuzz_function *f)
{
    const struct etch_vertex v[2] = {fuzz_vertex(c), fuzz_vertex(c)};
    const struct etch_vertex *const p[2] = {&v[0], &v[1]};
    const uint16_t width = fuzz_word(c);

    (void)f;
    if (width % 2 == 0) {
        etch_line_wide(&c->s, p, width, etch_triangle_gouraud_depth, etch_kernel_gouraud_less);
    } else {
        etch_line_wide(&c->s, p, width, etch_triangle_flat, etch_kernel_flat);
    }
}

static void point(struct fuzz_calls *c, fuzz_function *f)
{
    static etch_kernel *const kernels[] = {etch_kernel_gouraud, etch_kernel_gouraud_less,
                                           etch_kernel_gouraud_lequal, etch_kernel_gouraud_swapped};
    const struct etch_vertex v = fuzz_vertex(c);
    const uint16_t size = fuzz_word(c);
    etch_kernel *kernel = kernels[fuzz_byte(c) % 4];

    (void)f;
    etch_point_paint(&c->s, &v, size,
                     fuzz_byte(c) % 2 == 0 ? etch_point_runs_square : etch_point_runs_round,
                     kernel);
}

#define ROW(name, call)                                                                            \
    {                                                                                              \
#name, call, (fuzz_function *)name                                                         \
    }

const struct fuzz_row fuzz_triangle_rows[] = {
    ROW(etch_triangle_flat, flat),
    ROW(etch_triangle_flat_swapped, flat),
    ROW(etch_triangle_flat_small, flat),
    ROW(etch_triangle_flat_depth, flat_depth),
    ROW(etch_triangle_flat_depth_swapped, flat_depth),
    ROW(etch_triangle_flat_depth_exact, flat_exact),
    ROW(etch_triangle_flat_depth_exact_swapped, flat_exact),
    ROW(etch_triangle_flat_inverse, flat_inverse),
    ROW(etch_triangle_flat_inverse_swapped, flat_inverse),
    ROW(etch_triangle_flat_blend, flat_blend),
    ROW(etch_triangle_flat_dither, dither),
    ROW(etch_triangle_flat_depth_dither, dither_depth),
    ROW(etch_triangle_gouraud, gouraud),
    ROW(etch_triangle_gouraud_small, gouraud),
    ROW(etch_triangle_gouraud_depth, gouraud_depth),
    ROW(etch_triangle_gouraud_depth_small, gouraud_depth),
    ROW(etch_triangle_gouraud_exact, gouraud_exact),
    ROW(etch_triangle_gouraud_depth_exact, gouraud_depth_exact),
    ROW(etch_triangle_gouraud_inverse, gouraud_inverse),
    ROW(etch_triangle_gouraud_blend, gouraud_blend),
    ROW(etch_triangle_gouraud_fade, gouraud_fade),
    ROW(etch_triangle_barycentric, barycentric),
    ROW(etch_line_flat_depth, line_flat_depth),
    ROW(etch_line_flat_depth_swapped, line_flat_depth),
    ROW(etch_line_gouraud, line_gouraud),
    ROW(etch_line_gouraud_depth, line_gouraud_depth),
    ROW(etch_line_wide, line_wide),
    ROW(etch_point_paint, point),
    {NULL, NULL, NULL},
};
