/* tests/unit: primitive assembly: kinds by their definition, lines and points through clipping, and
 * the takers of draw/mesh_elements. */
#include "core/vertex/elements.h"
#include "core/draw/mesh_elements.h"
#include "core/vertex/clip_line.h"
#include "tests/unit/mesh_parts.h"

void suite_elements(void);

/* ---- kinds ------------------------------------------------------------------------------------
 */

struct written {
    struct etch_element_sink sink;
    uint8_t size;
    char text[200];
    int n;
};

static void write_digits(struct etch_element_sink *sink, const uint16_t *index)
{
    struct written *w = (struct written *)(void *)sink;

    for (int i = 0; i < w->size && CHECK(w->n < 190); i++)
        w->text[w->n++] = (char)('0' + index[i]);
    w->text[w->n++] = ' ';
    w->text[w->n] = '\0';
}

/* `list` has one digit an element; 9 names no vertex. */
static bool gives(etch_element_kind *kind, uint8_t size, const char *list, const char *expected)
{
    struct written w = {.sink.take = write_digits, .size = size};
    uint16_t indices[64];
    struct etch_elements e = {indices, 0, 9};
    int i = 0;

    for (; list[e.count] != '\0'; e.count++)
        indices[e.count] = list[e.count] == '9' ? 65535 : (uint16_t)(list[e.count] - '0');
    kind(&e, &w.sink);
    while (w.text[i] != '\0' && w.text[i] == expected[i])
        i++;
    if (w.text[i] == expected[i])
        return true;
    test_print(w.text);
    return false;
}

static void kinds_are_as_defined(void)
{
    CHECK(gives(etch_elements_points, 1, "0213", "0 2 1 3 "));
    CHECK(gives(etch_elements_points, 1, "0913", "0 1 3 "));
    CHECK(gives(etch_elements_lines, 2, "01234", "01 23 "));
    CHECK(gives(etch_elements_lines, 2, "019345", "01 45 "));
    CHECK(gives(etch_elements_line_strip, 2, "0123", "01 12 23 "));
    CHECK(gives(etch_elements_line_strip, 2, "0129345", "01 12 34 45 "));
    CHECK(gives(etch_elements_line_strip, 2, "0", ""));
    CHECK(gives(etch_elements_line_loop, 2, "0123", "01 12 23 30 "));
    CHECK(gives(etch_elements_line_loop, 2, "0129345", "01 12 20 34 45 53 "));
    CHECK(gives(etch_elements_line_loop, 2, "01", "01 10 "));
    CHECK(gives(etch_elements_line_loop, 2, "0", ""));
    CHECK(gives(etch_elements_line_loop, 2, "9901", "01 10 "));
    CHECK(gives(etch_elements_triangles, 3, "01234567", "012 345 "));
    CHECK(gives(etch_elements_triangles, 3, "012394567", "012 567 "));
    CHECK(gives(etch_elements_triangle_strip, 3, "012345", "012 213 234 435 "));
    CHECK(gives(etch_elements_triangle_strip, 3, "01239456", "012 213 456 "));
    CHECK(gives(etch_elements_triangle_strip, 3, "01", ""));
    CHECK(gives(etch_elements_triangle_fan, 3, "01234", "012 023 034 "));
    CHECK(gives(etch_elements_triangle_fan, 3, "0123945678", "012 023 456 467 478 "));
}

static void without_indices_all_vertices_count(void)
{
    struct written w = {.sink.take = write_digits, .size = 3};
    const struct etch_elements five = {NULL, 5, 5}, four = {NULL, 9, 4};

    etch_elements_triangle_fan(&five, &w.sink);
    CHECK(w.n == 12 && w.text[0] == '0' && w.text[8] == '0' && w.text[9] == '3');
    w.n = 0;
    etch_elements_triangles(&four, &w.sink); /* 3 4 5 and what follows do not exist */
    CHECK(w.n == 4);
}

/* ---- lines and points --------------------------------------------------------------------------
 */

#define MOST 600

struct got {
    struct etch_sink sink;
    int n;
    struct etch_vertex v[MOST][3];
};

static void get(struct got *g, const struct etch_vertex *const *v, int size)
{
    if (!CHECK(g->n < MOST))
        return;
    for (int i = 0; i < size; i++)
        g->v[g->n][i] = *v[i];
    g->n++;
}

static void get_triangle(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    get((struct got *)(void *)sink, v, 3);
}

static void get_line(struct etch_sink *sink, const struct etch_vertex *const v[2])
{
    get((struct got *)(void *)sink, v, 2);
}

static void get_point(struct etch_sink *sink, const struct etch_vertex *v)
{
    get((struct got *)(void *)sink, &v, 1);
}

static struct got a = {.sink = {get_triangle, get_line, get_point}};
static struct got b = {.sink = {get_triangle, get_line, get_point}};

static bool same_vertex(const struct etch_vertex *p, const struct etch_vertex *q)
{
    return p->x_q8 == q->x_q8 && p->y_q8 == q->y_q8 && p->z_q16 == q->z_q16 && p->r == q->r &&
           p->g == q->g && p->b == q->b && p->a == q->a;
}

static void random_vertex(struct etch_clip_vertex *v, int bits, uint32_t *seed)
{
    const uint32_t color = test_random(seed);

    v->x = (int32_t)test_random(seed) >> (32 - bits);
    v->y = (int32_t)test_random(seed) >> (32 - bits);
    v->z = (int32_t)test_random(seed) >> (32 - bits);
    v->w = (int32_t)test_random(seed) >> (32 - bits);
    v->r = (uint8_t)color, v->g = (uint8_t)(color >> 8);
    v->b = (uint8_t)(color >> 16), v->a = (uint8_t)(color >> 24);
}

/* A line reaches the sink as etch_clip_line leaves it, unless both ends are beyond one side. */
static void lines_are_clipped_and_projected(void)
{
    struct etch_assembly assembly = assembly_for(&a.sink, screen);
    uint32_t seed = 1;
    int32_t lines = 0, points = 0;

    for (int32_t n = 0; n < TEST_COUNT(30000) && !test_failed(); n++) {
        struct etch_clip_vertex v[2], end[2];
        const int bits = n % 3 == 0 ? 32 : 18;
        uint8_t out[2];
        bool kept;

        for (int i = 0; i < 2; i++) {
            random_vertex(&v[i], bits, &seed);
            out[i] = etch_viewport_outcode(&assembly.viewport, &v[i]);
        }
        assembly.flat = n % 4 == 0;
        a.n = 0;
        etch_assemble_line(&assembly, v);
        kept = (out[0] & out[1] & ETCH_OUT_REJECT) == 0 &&
               etch_clip_line(&assembly.viewport, v, end);
        CHECK_EQ(a.n, kept ? 1 : 0);
        for (int i = 0; kept && i < 2; i++) {
            struct etch_vertex p;

            etch_viewport_project(&assembly.viewport, &end[i], &p);
            if (assembly.flat)
                p.r = v[0].r, p.g = v[0].g, p.b = v[0].b, p.a = v[0].a;
            CHECK(same_vertex(&p, &a.v[0][i]));
        }
        lines += kept;

        a.n = 0;
        etch_assemble_point(&assembly, &v[0]);
        CHECK_EQ(a.n, (out[0] & ETCH_OUT_CLIP) == 0);
        points += a.n;
    }
    CHECK(lines > TEST_COUNT(100) && points > TEST_COUNT(100));
}

/* ---- meshes ------------------------------------------------------------------------------------
 */

struct direct {
    struct etch_element_sink sink;
    const struct etch_mesh_stage *stage;
    const struct etch_assembly *assembly;
    int size;
};

/* Clip vertices of a primitive, one by one, to etch_assemble_. */
static void take_direct(struct etch_element_sink *sink, const uint16_t *index)
{
    const struct direct *d = (const struct direct *)(void *)sink;
    struct etch_clip_vertex v[3];

    for (int i = 0; i < d->size; i++)
        d->stage->vertex(d->stage, index[i], &v[i]);
    if (d->size == 1)
        etch_assemble_point(d->assembly, v);
    else if (d->size == 2)
        etch_assemble_line(d->assembly, v);
    else
        etch_assemble_triangle(d->assembly, v);
}

/* A user's primitive function: every second triangle, as it is. */
static int32_t seen;
static void every_second(const struct etch_mesh_primitive *primitive,
                         const struct etch_clip_vertex *v)
{
    if (seen++ % 2 == 0)
        etch_assemble_triangle(primitive->assembly, v);
}

static const struct {
    etch_element_kind *kind;
    etch_element_taker *taker;
    int size;
} cases[] = {{etch_elements_points, etch_mesh_take_point, 1},
             {etch_elements_line_loop, etch_mesh_take_line, 2},
             {etch_elements_lines, etch_mesh_take_line, 2},
             {etch_elements_triangles, etch_mesh_take_triangle, 3},
             {etch_elements_triangle_strip, etch_mesh_take_triangle, 3}};

/* What takers make of the buffer is what clip vertices give one by one. */
static void takers_equal_single_primitives(void)
{
    uint32_t seed = 5;

    for (int32_t n = 0; n < TEST_COUNT(100) && !test_failed(); n++) {
        static const struct etch_vector centre = {0, -30000, 0};
        struct etch_assembly to_a = assembly_for(&a.sink, screen), to_b;
        const struct etch_vector eye = {test_range(&seed, -300000, 300000),
                                        test_range(&seed, 1, 60000), 100000};
        const struct etch_matrix m = camera(&eye, &centre, 6553, 40 * 65536);
        const struct etch_elements e = {grid_indices, 600, GRID * GRID - 9};
        struct etch_mesh_stage stage;
        struct etch_mesh_elements elements;

        make_grid(20 + n % 40, &seed);
        etch_mesh_stage_init(&stage, &grid, &m, etch_vertex_plain, NULL);
        to_a.cull = (enum etch_cull)(n % 3);
        to_a.flat = n % 2 == 0;
        to_b = to_a;
        to_b.sink = &b.sink;
        etch_mesh_transform(&stage, &to_a.viewport, buffer);
        for (size_t c = 0; c < sizeof cases / sizeof cases[0]; c++) {
            struct direct direct = {{take_direct}, &stage, &to_b, cases[c].size};

            a.n = b.n = 0;
            etch_mesh_elements_init(&elements, cases[c].taker, &stage, &to_a, buffer);
            cases[c].kind(&e, &elements.sink);
            cases[c].kind(&e, &direct.sink);
            CHECK_EQ(a.n, b.n);
            for (int i = 0; i < a.n * cases[c].size && !test_failed(); i++)
                CHECK(same_vertex(&a.v[i / cases[c].size][i % cases[c].size],
                                  &b.v[i / cases[c].size][i % cases[c].size]));
        }
    }
}

/* The user's function stands between the mesh and clipping. */
static void users_may_choose_primitives(void)
{
    static const struct etch_vector centre = {0, 0, 0}, eye = {200000, 100000, 200000};
    const struct etch_assembly assembly = assembly_for(&a.sink, screen);
    const struct etch_matrix m = camera(&eye, &centre, 655, 40 * 65536);
    struct etch_mesh_stage stage;
    struct etch_mesh_primitive primitive;

    etch_mesh_stage_init(&stage, &octahedron, &m, etch_vertex_plain, NULL);
    etch_mesh_primitive_init(&primitive, every_second, 3, &stage, &assembly);
    a.n = 0;
    etch_mesh_primitive_triangles(&primitive);
    CHECK_EQ(seen, 8);
    CHECK_EQ(a.n, 4);
    for (int i = 0; i < 3; i++) {
        struct etch_clip_vertex v;
        struct etch_vertex p;

        etch_vertex_plain(&stage, octa_indices[6 + i],
                          &v); /* the third triangle is the second kept */
        etch_viewport_project(&assembly.viewport, &v, &p);
        CHECK(same_vertex(&p, &a.v[1][i]));
    }
}

void suite_elements(void)
{
    RUN(kinds_are_as_defined);
    RUN(without_indices_all_vertices_count);
    RUN(lines_are_clipped_and_projected);
    RUN(takers_equal_single_primitives);
    RUN(users_may_choose_primitives);
}
