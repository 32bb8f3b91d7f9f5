/* tests/unit: four samples a pixel, own and shared with neighbours. Coverage by sample is the rule
 * of the centre for a moved triangle, and so are the values: the oracle says which samples,
 * painters of plain surfaces which colour and depth. Meshes have no seams; strips and clips change
 * nothing. */
#include "core/base/rgb565.h"
#include "core/draw/shapes.h"
#include "core/draw/triangle.h"
#include "core/fragment/flat.h"
#include "core/fragment/gouraud.h"
#include "core/frame/multisample.h"
#include "core/frame/shared.h"
#include "tests/harness/canvas.h"
#include "tests/harness/shapes.h"
#include "tests/oracle/triangle.h"

void suite_multisample(void);

enum {
    WIDTH = 40,
    HEIGHT = 30,
    CELLS = WIDTH + 1,
    PLANE = CELLS * HEIGHT,
    POINTS = 6
};

static const struct etch_rect frame = {0, 0, WIDTH, HEIGHT};

/* Both kinds of samples behind one face. */
struct kind {
    bool shared;
    int32_t columns, planes, points;
    struct etch_offset_q8 at[POINTS]; /* samples 0 .. 3, then centres */
};

static const struct kind kinds[2] = {
    {false, WIDTH, 4, 5, {{-96, -32}, {-32, 96}, {32, -96}, {96, 32}, {0, 0}, {0, 0}}},
    {true, CELLS, 2, 6, {{-192, -96}, {-64, 32}, {-192, 96}, {-64, -32}, {-128, -32}, {-128, 32}}}};

static uint16_t pixels[4 * PLANE], depths[4 * PLANE];
static struct etch_multisample own;
static struct etch_shared_samples pairs;

static struct etch_surface *sample_of(const struct kind *k, int32_t i)
{
    return k->shared ? &pairs.sample[i] : &own.sample[i];
}

static void open(const struct kind *k, struct etch_rect window)
{
    CHECK_EQ(k->shared ? etch_shared_init(&pairs, pixels, depths, window)
                       : etch_multisample_init(&own, pixels, depths, window),
             ETCH_OK);
}

static void clip(const struct kind *k, struct etch_rect c)
{
    if (k->shared)
        etch_shared_clip(&pairs, c);
    else
        etch_multisample_clip(&own, c);
}

static void clear(const struct kind *k, uint16_t color, uint16_t depth)
{
    int32_t i;

    for (i = 0; i < k->planes; i++) {
        etch_surface_clear(sample_of(k, i), color);
        etch_depth_clear(sample_of(k, i), depth);
    }
}

/* painter 0 .. 5: flat, flat less, flat lequal, then Gouraud. */
static void paint(const struct kind *k, int32_t painter, const struct etch_vertex *const v[3])
{
    static etch_multisample_painter *const of_own[] = {
        etch_multisample_flat,    etch_multisample_flat_less,    etch_multisample_flat_lequal,
        etch_multisample_gouraud, etch_multisample_gouraud_less, etch_multisample_gouraud_lequal};
    static etch_shared_painter *const of_pairs[] = {
        etch_shared_flat,    etch_shared_flat_less,    etch_shared_flat_lequal,
        etch_shared_gouraud, etch_shared_gouraud_less, etch_shared_gouraud_lequal};

    if (k->shared)
        of_pairs[painter](&pairs, v);
    else
        of_own[painter](&own, v);
}

static void resolve(const struct kind *k, const struct etch_surface *out, bool swapped)
{
    if (k->shared)
        (swapped ? etch_shared_resolve_swapped : etch_shared_resolve)(&pairs, out);
    else
        (swapped ? etch_multisample_resolve_swapped : etch_multisample_resolve)(&own, out);
}

/* ---- each sample against its definition --------------------------------------------------------
 */

/* What plain painters draw of the triangle as each point sees it, over all cells. */
static uint16_t seen_color[POINTS][PLANE], seen_depth[POINTS][PLANE];

static void draw_seen(const struct kind *k, bool smooth, const struct etch_vertex vertex[3])
{
    const struct etch_rect cells = {0, 0, CELLS, HEIGHT};
    int32_t i, j;

    for (i = 0; i < k->points; i++) {
        struct etch_vertex moved[3];
        const struct etch_vertex *const v[3] = {&moved[0], &moved[1], &moved[2]};
        struct etch_surface s;

        CHECK_EQ(etch_surface_init(&s, seen_color[i], cells, CELLS), ETCH_OK);
        s.depth = seen_depth[i];
        etch_depth_clear(&s, UINT16_MAX);
        for (j = 0; j < 3; j++)
            moved[j] = etch_vertex_jitter(&vertex[j], k->at[i]);
        if (smooth)
            etch_triangle_gouraud_depth(&s, v, etch_kernel_gouraud_lequal);
        else
            etch_triangle_flat_depth(&s, v, etch_kernel_flat_lequal);
    }
}

/* The samples of column x, by the oracle. */
static int32_t covered(const struct kind *k, const struct oracle_triangle o[4], int32_t x,
                       int32_t y, int32_t *all)
{
    int32_t i, mask = 0;

    *all = !k->shared ? 15 : x % 2 != 0 ? 12 : 3;
    for (i = 0; i < 4; i++)
        if ((*all >> i & 1) != 0 && oracle_triangle_covers(&o[i], x, y))
            mask |= 1 << i;
    return mask;
}

/* Where the fragment's colour is taken. */
static int32_t color_point(const struct kind *k, int32_t mask, int32_t all, int32_t x)
{
    int32_t i = 0;

    if (mask == all)
        return 4 + (k->shared ? x % 2 : 0);
    while ((mask >> i & 1) == 0)
        i++;
    return i;
}

/* Compares all samples with what they were (`old` colour and depth) and should have become. */
static int32_t differences(const struct kind *k, int32_t painter, const struct oracle_triangle o[4],
                           struct etch_rect inside, uint16_t old_color, uint16_t old_depth)
{
    int32_t x, y, i, wrong = 0;

    for (y = 0; y < HEIGHT; y++) {
        for (x = 0; x < k->columns; x++) {
            const bool in = x >= inside.x0 && x < inside.x1 && y >= inside.y0 && y < inside.y1;
            int32_t all;
            const int32_t mask = covered(k, o, x, y, &all);
            const int32_t at = y * CELLS + x;

            for (i = 0; i < 4; i++) {
                const struct etch_surface *s = sample_of(k, k->shared ? i % 2 : i);
                const size_t here = etch_surface_index(s, (int16_t)x, (int16_t)y);
                uint16_t color = old_color, depth = old_depth;

                if ((all >> i & 1) == 0)
                    continue;
                if (in && (mask >> i & 1) != 0 &&
                    (painter % 3 == 0 || seen_depth[i][at] < old_depth ||
                     (painter % 3 == 2 && seen_depth[i][at] == old_depth))) {
                    color = seen_color[color_point(k, mask, all, x)][at];
                    depth = painter % 3 == 0 ? old_depth : seen_depth[i][at];
                }
                wrong += s->pixels[here] != color || s->depth[here] != depth;
            }
        }
    }
    return wrong;
}

/* No channel of the drawn samples lies outside the rounded range of the vertices. */
static int32_t out_of_range(const struct kind *k, const struct etch_vertex v[3], uint16_t old)
{
    uint16_t least = UINT16_MAX, most = 0;
    int32_t c, i, wrong = 0;

    for (c = 0; c < 3; c++) {
        const int shift = c == 0 ? 11 : c == 1 ? 5 : 0;
        const uint32_t ones = c == 1 ? 63 : 31;

        least = UINT16_MAX, most = 0;
        for (i = 0; i < 3; i++) {
            const uint16_t step = (uint16_t)((uint32_t)etch_rgb565(v[i].r, v[i].g, v[i].b) >>
                                                 shift &
                                             ones);

            least = step < least ? step : least;
            most = step > most ? step : most;
        }
        for (i = 0; i < k->planes * k->columns * HEIGHT; i++) {
            const uint32_t step = (uint32_t)pixels[i] >> shift & ones;

            wrong += pixels[i] != old && (step < least || step > most);
        }
    }
    return wrong;
}

static void random_vertices(struct etch_vertex vertex[3], const struct test_triangle *t,
                            uint32_t *seed)
{
    int32_t i;

    for (i = 0; i < 3; i++) {
        const uint32_t bits = test_random(seed);

        vertex[i].x_q8 = t->x[i];
        vertex[i].y_q8 = t->y[i];
        vertex[i].z_q16 = (uint32_t)test_range(seed, 0, 65535) << 16;
        vertex[i].r = (uint8_t)(bits & 255);
        vertex[i].g = (uint8_t)(bits >> 8 & 255);
        vertex[i].b = (uint8_t)(bits >> 16 & 255);
        vertex[i].a = 255;
    }
}

static void compare(const struct kind *k, int32_t n, uint32_t *seed)
{
    static const uint16_t old_color = 0x1234;
    const enum test_triangle_kind shape = (enum test_triangle_kind)(n % TEST_TRIANGLE_KINDS);
    const int32_t painter = n / TEST_TRIANGLE_KINDS % 6;
    const uint16_t old_depth = (uint16_t)test_range(seed, 0, 65535);
    struct etch_rect inside = {0, 0, (int16_t)k->columns, HEIGHT};
    struct etch_vertex vertex[3];
    const struct etch_vertex *const v[3] = {&vertex[0], &vertex[1], &vertex[2]};
    struct oracle_triangle o[4];
    struct test_triangle t;
    int32_t i, j;

    test_triangle_make(&t, shape, frame, seed);
    random_vertices(vertex, &t, seed);
    for (i = 0; i < 4; i++) {
        int32_t x[3], y[3];

        for (j = 0; j < 3; j++) {
            x[j] = t.x[j] - k->at[i].x;
            y[j] = t.y[j] - k->at[i].y;
        }
        oracle_triangle_make(&o[i], x, y);
    }
    open(k, frame);
    clear(k, old_color, old_depth);
    if (n % 4 == 3) {
        inside.x0 = (int16_t)test_range(seed, 0, WIDTH - 1);
        inside.x1 = (int16_t)test_range(seed, inside.x0 + 1, WIDTH);
        inside.y0 = (int16_t)test_range(seed, 0, HEIGHT - 1);
        inside.y1 = (int16_t)test_range(seed, inside.y0 + 1, HEIGHT);
        clip(k, inside);
        inside.x1 = (int16_t)(inside.x1 + (k->shared ? 1 : 0));
    }
    draw_seen(k, painter >= 3, vertex);
    paint(k, painter, v);
    if (!CHECK_EQ(differences(k, painter, o, inside, old_color, old_depth), 0) ||
        !CHECK_EQ(out_of_range(k, vertex, old_color), 0)) {
        test_note("shared", k->shared);
        test_note("kind", shape);
        test_note("painter", painter);
    }
}

static void samples_are_covered_and_valued_by_the_rule(void)
{
    const int32_t count = TEST_COUNT(1560);
    uint32_t seed = 1;
    int32_t n;

    for (n = 0; n < count && !test_failed(); n++) {
        compare(&kinds[0], n, &seed);
        compare(&kinds[1], n, &seed);
    }
}

/* ---- resolving ----------------------------------------------------------------------------------
 */

static struct test_canvas canvas;

static void resolving_is_the_exact_average(void)
{
    const int32_t count = TEST_COUNT(60);
    uint32_t seed = 2;
    int32_t n, x, y, i, c, wrong = 0;

    for (n = 0; n < count; n++) {
        const struct kind *k = &kinds[n % 2];
        const struct etch_rect part = {3, 2, 29, 21};

        open(k, frame);
        for (i = 0; i < k->planes * k->columns * HEIGHT; i++)
            pixels[i] = (uint16_t)(test_random(&seed) >> (n % 3 == 0 ? 0 : 16));
        test_canvas_open(&canvas, frame);
        if (n % 5 == 4)
            test_canvas_clip(&canvas, part);
        resolve(k, &canvas.surface, n % 4 >= 2);
        CHECK_ONCE(&canvas);
        for (y = canvas.surface.clip.y0; y < canvas.surface.clip.y1; y++) {
            for (x = canvas.surface.clip.x0; x < canvas.surface.clip.x1; x++) {
                const uint16_t drawn = test_canvas_at(&canvas, x, y);
                const uint16_t got = n % 4 >= 2 ? etch_rgb565_swap(drawn) : drawn;

                for (c = 0; c < 3; c++) {
                    const int shift = c == 0 ? 11 : c == 1 ? 5 : 0;
                    const uint32_t ones = c == 1 ? 63 : 31;
                    uint32_t sum = 2;

                    for (i = 0; i < 4; i++) {
                        const int32_t cell = x + (k->shared ? i / 2 : 0);
                        const struct etch_surface *s = sample_of(k, k->shared ? i % 2 : i);

                        sum +=
                            (uint32_t)s->pixels[etch_surface_index(s, (int16_t)cell, (int16_t)y)] >>
                                shift &
                            ones;
                    }
                    wrong += ((uint32_t)got >> shift & ones) != sum / 4;
                }
            }
        }
    }
    CHECK_EQ(wrong, 0);
}

/* ---- meshes -------------------------------------------------------------------------------------
 */

enum {
    GRID = 5
};

static struct etch_vertex corner[(GRID + 1) * (GRID + 1)];

/* Corners of a grid over pixels 4 .. WIDTH - 5, the inner ones moved about. */
static void make_mesh(uint32_t *seed, bool colored)
{
    int32_t i, k;

    for (k = 0; k <= GRID; k++) {
        for (i = 0; i <= GRID; i++) {
            const bool inner = i > 0 && i < GRID && k > 0 && k < GRID;
            struct etch_vertex *v = &corner[k * (GRID + 1) + i];

            *v = (struct etch_vertex){.z_q16 = 1000, .r = 200, .g = 120, .b = 40, .a = 255};
            v->x_q8 = 1024 + i * (WIDTH - 8) * 256 / GRID;
            v->y_q8 = 1024 + k * (HEIGHT - 8) * 256 / GRID;
            v->x_q8 += inner ? test_range(seed, -400, 400) : 0;
            v->y_q8 += inner ? test_range(seed, -300, 300) : 0;
            if (colored) {
                v->r = (uint8_t)test_range(seed, 0, 255);
                v->g = (uint8_t)test_range(seed, 0, 255);
                v->z_q16 = (uint32_t)test_range(seed, 0, 65535) << 16;
            }
        }
    }
}

static void draw_mesh(const struct kind *k, int32_t painter)
{
    int32_t t;

    for (t = 0; t < 2 * GRID * GRID; t++) {
        const int32_t at = t / 2 / GRID * (GRID + 1) + t / 2 % GRID;
        const struct etch_vertex *const v[3] = {&corner[t % 2 == 0 ? at : at + GRID + 2],
                                                &corner[at + 1], &corner[at + GRID + 1]};

        paint(k, painter, v);
    }
}

/* Triangles of one colour on another: inside nothing of the background is left. */
static void a_mesh_of_one_colour_has_no_seams(void)
{
    const uint16_t color = etch_rgb565(200, 120, 40);
    const int32_t count = TEST_COUNT(120);
    uint32_t seed = 3;
    int32_t n, x, y, wrong = 0;

    for (n = 0; n < count; n++) {
        const struct kind *k = &kinds[n % 2];
        const int32_t softer = k->shared ? 1 : 0;

        make_mesh(&seed, false);
        open(k, frame);
        clear(k, 0xFFFF, 65535);
        draw_mesh(k, n / 2 % 6);
        test_canvas_open(&canvas, frame);
        resolve(k, &canvas.surface, false);
        for (y = 0; y < HEIGHT; y++) {
            for (x = 0; x < WIDTH; x++) {
                const bool rows = y >= 4 && y < HEIGHT - 4;

                if (rows && x >= 4 + softer && x < WIDTH - 4 - softer)
                    wrong += test_canvas_at(&canvas, x, y) != color;
                else if (!rows || x < 4 - softer || x >= WIDTH - 4 + softer)
                    wrong += test_canvas_at(&canvas, x, y) != 0xFFFF;
            }
        }
    }
    CHECK_EQ(wrong, 0);
}

/* ---- strips, and other calls on the samples
 * -------------------------------------------------------- */

static uint16_t whole[WIDTH * HEIGHT];

static void strips_give_the_whole_frame(void)
{
    static const int16_t rows[] = {1, 7, 16, HEIGHT};
    const int32_t count = TEST_COUNT(48);
    uint32_t seed = 4;
    int32_t n, x, y, wrong = 0;

    for (n = 0; n < count; n++) {
        const struct kind *k = &kinds[n % 2];
        int16_t y0, i;

        make_mesh(&seed, true);
        for (i = 3; i >= 0; i--) {
            for (y0 = 0; y0 < HEIGHT; y0 = (int16_t)(y0 + rows[i])) {
                const int32_t y1 = y0 + rows[i];
                const struct etch_rect strip = {0, y0, WIDTH, (int16_t)(y1 < HEIGHT ? y1 : HEIGHT)};

                open(k, strip);
                clear(k, 0x18E3, 40000);
                draw_mesh(k, n / 2 % 6);
                test_canvas_open(&canvas, strip);
                resolve(k, &canvas.surface, false);
                for (y = strip.y0; y < strip.y1; y++) {
                    for (x = 0; x < WIDTH; x++) {
                        if (i == 3)
                            whole[y * WIDTH + x] = test_canvas_at(&canvas, x, y);
                        wrong += whole[y * WIDTH + x] != test_canvas_at(&canvas, x, y);
                    }
                }
            }
        }
    }
    CHECK_EQ(wrong, 0);
}

/* Flat triangles painted together, and sample by sample with plain painters, are the same. */
static void plain_painters_draw_the_same_samples(void)
{
    static uint16_t kept[4 * PLANE];
    const int32_t count = TEST_COUNT(100);
    uint32_t seed = 5;
    int32_t n, i, j, wrong = 0;

    for (n = 0; n < count; n++) {
        struct etch_vertex vertex[3], moved[3];
        const struct etch_vertex *const v[3] = {&vertex[0], &vertex[1], &vertex[2]};
        const struct etch_vertex *const m[3] = {&moved[0], &moved[1], &moved[2]};
        struct test_triangle t;

        test_triangle_make(&t, (enum test_triangle_kind)(n % TEST_TRIANGLE_KINDS), frame, &seed);
        random_vertices(vertex, &t, &seed);
        open(&kinds[0], frame);
        clear(&kinds[0], 0, 65535);
        etch_multisample_flat(&own, v);
        for (i = 0; i < 4 * WIDTH * HEIGHT; i++)
            kept[i] = pixels[i];
        clear(&kinds[0], 0, 65535);
        for (i = 0; i < 4; i++) {
            for (j = 0; j < 3; j++)
                moved[j] = etch_vertex_jitter(&vertex[j], etch_jitter_4[i]);
            etch_triangle_flat(&own.sample[i], m, etch_kernel_flat);
        }
        for (i = 0; i < 4 * WIDTH * HEIGHT; i++)
            wrong += kept[i] != pixels[i];
    }
    CHECK_EQ(wrong, 0);
}

static void the_offsets_are_those_that_are_published(void)
{
    int32_t i;

    for (i = 0; i < 4; i++) {
        CHECK_EQ(etch_jitter_4[i].x, kinds[0].at[i].x);
        CHECK_EQ(etch_jitter_4[i].y, kinds[0].at[i].y);
        CHECK_EQ(etch_shared_offsets[i].x, kinds[1].at[i].x);
        CHECK_EQ(etch_shared_offsets[i].y, kinds[1].at[i].y);
    }
}

static void the_sinks_paint(void)
{
    const struct etch_vertex vertex[3] = {
        {.x_q8 = -999, .y_q8 = -999, .r = 255, .g = 255, .b = 255},
        {.x_q8 = 99999, .y_q8 = -999},
        {.x_q8 = -999, .y_q8 = 99999}};
    const struct etch_vertex *const v[3] = {&vertex[0], &vertex[1], &vertex[2]};
    struct etch_multisample_sink a;
    struct etch_shared_sink b;

    open(&kinds[0], frame);
    clear(&kinds[0], 0, 65535);
    etch_multisample_sink_init(&a, &own, etch_multisample_flat);
    a.sink.triangle(&a.sink, v);
    CHECK_EQ(pixels[0] & pixels[4 * WIDTH * HEIGHT - 1], 0xFFFF);
    open(&kinds[1], frame);
    clear(&kinds[1], 0, 65535);
    etch_shared_sink_init(&b, &pairs, etch_shared_flat);
    b.sink.triangle(&b.sink, v);
    CHECK_EQ(pixels[0] & pixels[2 * PLANE - 1], 0xFFFF);
}

static void windows_that_are_none_are_refused(void)
{
    const struct etch_rect none = {5, 5, 5, 9}, left = {-1, 0, 4, 4}, far = {32760, 0, 32767, 4};

    CHECK_EQ(etch_multisample_init(&own, NULL, NULL, frame), ETCH_EINVAL);
    CHECK_EQ(etch_multisample_init(&own, pixels, NULL, none), ETCH_EINVAL);
    CHECK_EQ(etch_multisample_init(&own, pixels, NULL, left), ETCH_EINVAL);
    CHECK_EQ(etch_multisample_init(&own, pixels, NULL, far), ETCH_OK);
    CHECK(own.sample[3].depth == NULL);
    CHECK_EQ(etch_shared_init(&pairs, NULL, NULL, frame), ETCH_EINVAL);
    CHECK_EQ(etch_shared_init(&pairs, pixels, NULL, none), ETCH_EINVAL);
    CHECK_EQ(etch_shared_init(&pairs, pixels, NULL, left), ETCH_EINVAL);
    CHECK_EQ(etch_shared_init(&pairs, pixels, NULL, far), ETCH_EINVAL);
}

void suite_multisample(void)
{
    RUN(samples_are_covered_and_valued_by_the_rule);
    RUN(resolving_is_the_exact_average);
    RUN(a_mesh_of_one_colour_has_no_seams);
    RUN(strips_give_the_whole_frame);
    RUN(plain_painters_draw_the_same_samples);
    RUN(the_offsets_are_those_that_are_published);
    RUN(the_sinks_paint);
    RUN(windows_that_are_none_are_refused);
    test_print_count("", TEST_COUNT(1560) * 2,
                     " triangles of thirteen kinds, every sample compared");
}
