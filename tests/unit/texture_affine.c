/* tests/unit: affine texture against exact rationals at every pixel of triangles of every kind: the
 * planes within their bound and inside the range of the vertices, the kernels by the texel. */
#include "core/draw/texture.h"
#include "core/fragment/texture.h"
#include "core/raster/texture_plane.h"
#include "tests/harness/canvas.h"
#include "tests/harness/shapes.h"
#include "tests/oracle/texture.h"

void suite_texture_affine(void);

static struct test_canvas canvas;
static int32_t pixels;
static uint32_t worst; /* error in 2^-20 texel, where x + y <= 2046 */

static const struct etch_rect windows[] = {
    {0, 0, 40, 30}, {280, 200, 320, 230}, {1003, 1013, 1043, 1043}, {8000, 100, 8040, 130}};

struct sample {
    struct oracle_triangle exact;
    struct etch_texture_vertex vertex[3];
    struct etch_rect window;
};

/* Coordinates: a few texels, integers, one ulp beside them, constants, many repeats. */
static void random_coordinates(int32_t c[3], uint32_t *seed)
{
    const int kind = test_range(seed, 0, 5);
    const int32_t base = test_range(seed, -1000, 1000) * 65536;
    int i;

    for (i = 0; i < 3; i++) {
        switch (kind) {
        case 0: c[i] = base + test_range(seed, 0, 64) * 65536; break;
        case 1: c[i] = base + test_range(seed, 0, 2) * 65536 - test_range(seed, 0, 1); break;
        case 2: c[i] = base + test_range(seed, 0, 1 << 22); break;
        case 3: c[i] = base; break;
        case 4: c[i] = base + test_range(seed, 0, 60000); break;
        default: c[i] = test_range(seed, -1000 * 65536, 1000 * 65536); break;
        }
    }
}

static void make_sample(struct sample *s, int32_t i, uint32_t *seed)
{
    struct test_triangle t;
    int32_t u[3], v[3];
    int k;

    s->window = windows[i / TEST_TRIANGLE_KINDS % 4];
    test_triangle_make(&t, (enum test_triangle_kind)(i % TEST_TRIANGLE_KINDS), s->window, seed);
    oracle_triangle_make(&s->exact, t.x, t.y);
    random_coordinates(u, seed);
    random_coordinates(v, seed);
    for (k = 0; k < 3; k++) {
        const struct etch_texture_vertex vertex = {
            {t.x[k], t.y[k], 0, 0, 0, 0, 255}, u[k], v[k], 1};

        s->vertex[k] = vertex;
    }
}

/* The plane's value, of 2^-(16 + bits) texel, against the exact one and the range of c. */
static bool plane_ok(const struct sample *s, const struct etch_plane *p, const int32_t c[3],
                     uint8_t bits, int32_t x, int32_t y)
{
    const int32_t unit_q20 = 1 << (bits < 4 ? 4 - bits : 0);
    const uint64_t exact = oracle_texture(&s->exact, x, y, c, NULL, bits);
    const uint32_t biased = etch_wrap_add(etch_plane_at(p, (int16_t)x, (int16_t)y),
                                          etch_wrap_up(UINT32_C(1) << 31, bits));
    const int32_t error = (int32_t)etch_wrap_sub(biased, (uint32_t)(exact & UINT32_MAX));
    const uint32_t size = (uint32_t)(error < 0 ? -error : error);
    const uint32_t error_q20 = bits < 4 ? size * (uint32_t)unit_q20 : size >> (bits - 4);
    int32_t least = c[0], most = c[0];
    int i;

    for (i = 1; i < 3; i++) {
        least = c[i] < least ? c[i] : least;
        most = c[i] > most ? c[i] : most;
    }
    if (x + y <= 2046 && bits > 0 && error_q20 > worst)
        worst = error_q20;
    if (x + y < (bits < 4 ? 1000 : 16000)) { /* the true value, and what came out, in range */
        const int64_t mine = (int64_t)exact + error - ((INT64_C(1) << 31) << bits);

        if (mine < (int64_t)least * (1 << bits) || mine > (int64_t)most * (1 << bits))
            return false;
    }
    return least == most ? error == 0
                         : x + y > 2046 || error_q20 < UINT32_C(1) << (bits > 0 ? 14 : 15);
}

static void note(const struct sample *s, int32_t x, int32_t y)
{
    int i;

    test_note("pixel x", x);
    test_note("pixel y", y);
    for (i = 0; i < 3; i++) {
        test_note("x_q8", s->vertex[i].at.x_q8);
        test_note("y_q8", s->vertex[i].at.y_q8);
        test_note("u", s->vertex[i].u);
        test_note("v", s->vertex[i].v);
    }
}

static void planes_keep_their_bound(void)
{
    uint32_t seed = 54;
    int32_t i, x, y;

    for (i = 0; i < TEST_COUNT(12000) && !test_failed(); i++) {
        const uint8_t bits = (uint8_t)(i % 13);
        struct sample s;
        const struct etch_texture_vertex *const v[3] = {&s.vertex[0], &s.vertex[1], &s.vertex[2]};
        struct etch_triangle t;
        struct etch_basis basis;
        struct etch_plane pu, pv;
        int k;

        make_sample(&s, i, &seed);
        const int32_t us[3] = {v[0]->u, v[1]->u, v[2]->u}, vs[3] = {v[0]->v, v[1]->v, v[2]->v};
        struct etch_point_q8 p[3];

        for (k = 0; k < 3; k++) {
            p[k].x = v[k]->at.x_q8;
            p[k].y = v[k]->at.y_q8;
        }
        if (!etch_triangle_setup(&t, p))
            continue;
        etch_texture_affine(&pu, &pv, &t, etch_basis_setup(&basis, &t) ? &basis : NULL, v, bits);
        for (y = s.window.y0; y < s.window.y1; y++) {
            for (x = s.window.x0; x < s.window.x1; x++) {
                if (!oracle_triangle_covers(&s.exact, x, y))
                    continue;
                pixels++;
                if (!CHECK(plane_ok(&s, &pu, us, 4, x, y)) ||
                    !CHECK(plane_ok(&s, &pv, vs, bits, x, y)))
                    note(&s, x, y);
            }
        }
    }
}

/* Whether a texel lies within 1/64 of the exact coordinate. */
static bool texel_ok(const struct sample *s, const int32_t c[3], uint32_t texel, uint8_t bits,
                     int32_t x, int32_t y)
{
    const uint64_t exact = oracle_texture(&s->exact, x, y, c, NULL, 4), near = 1 << 14;
    const uint32_t mask = (UINT32_C(1) << bits) - 1;

    return texel == ((exact - near) >> 20 & mask) || texel == ((exact + near) >> 20 & mask);
}

/* Of the colours only: kernels without depth leave the depths alone. */
static uint32_t color_hash(void)
{
    const struct etch_rect w = canvas.surface.window;
    uint32_t hash = 0;
    int32_t x, y;

    for (y = w.y0; y < w.y1; y++)
        for (x = w.x0; x < w.x1; x++)
            hash = etch_wrap_add(etch_wrap_mul(hash, 31), test_canvas_at(&canvas, x, y));
    return hash;
}

/* A texture of numbers shows which texel a pixel got: within 1/64 of the exact place, with and
 * without depth, in every order of the vertices. */
static void kernels_take_the_right_texel(void)
{
    static uint16_t texels[4096];
    const struct etch_texture texture = {texels, 5, 7};
    uint32_t seed = 55;
    int32_t i, x, y;

    for (i = 0; i < 4096; i++)
        texels[i] = (uint16_t)i;
    for (i = 0; i < TEST_COUNT(3000) && !test_failed(); i++) {
        struct sample s;
        uint32_t hash = 0;
        int k;

        make_sample(&s, i, &seed);
        if (s.window.x0 > 2000)
            continue;
        const int32_t us[3] = {s.vertex[0].u, s.vertex[1].u, s.vertex[2].u};
        const int32_t vs[3] = {s.vertex[0].v, s.vertex[1].v, s.vertex[2].v};

        test_canvas_open(&canvas, s.window);
        for (k = 0; k < 6; k++) {
            const uint8_t *const o = test_orders[k];
            const struct etch_texture_vertex *const v[3] = {&s.vertex[o[0]], &s.vertex[o[1]],
                                                            &s.vertex[o[2]]};

            test_canvas_wipe(&canvas);
            if (k % 2 == 0)
                etch_triangle_texture(&canvas.surface, v, &texture, etch_kernel_texture);
            else
                etch_triangle_texture_depth(&canvas.surface, v, &texture,
                                            k == 1 ? etch_kernel_texture_less
                                                   : etch_kernel_texture_lequal);
            CHECK_ONCE(&canvas);
            if (k > 0 && !CHECK_EQ(color_hash(), hash))
                note(&s, 0, 0);
            hash = color_hash();
        }
        for (y = s.window.y0; y < s.window.y1; y++) {
            for (x = s.window.x0; x < s.window.x1; x++) {
                const uint16_t got = test_canvas_at(&canvas, x, y);

                if (!CHECK(oracle_triangle_covers(&s.exact, x, y)
                               ? texel_ok(&s, us, got & 31, 5, x, y) &&
                                     texel_ok(&s, vs, got >> 5, 7, x, y)
                               : got == TEST_BACKGROUND))
                    note(&s, x, y);
            }
        }
    }
}

void suite_texture_affine(void)
{
    pixels = 0;
    worst = 0;
    RUN(planes_keep_their_bound);
    RUN(kernels_take_the_right_texel);
    test_print_count("", pixels, " coordinates against exact rationals, none beyond its bound");
    test_print_count("largest error ", (worst + 1023) / 1024, "/1024 texel, allowed 16");
}
