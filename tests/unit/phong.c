/* tests/unit: Phong shading: the normals and positions that pixels are shaded with. */
#include "core/draw/mesh_phong.h"
#include "core/base/unit.h"
#include "core/draw/triangle.h"
#include "core/fragment/write.h"
#include "tests/harness/canvas.h"
#include "tests/harness/harness.h"

void suite_phong(void);

#define SIDE 32

/* The pixels of one triangle as they were shaded, row by row. */
struct record {
    int n;
    struct etch_shade_point point[SIDE * SIDE];
};

static struct record record;
static struct test_canvas canvas;
static struct etch_phong_planes planes;

static void note(const void *lighting, const struct etch_shade_point *point, uint8_t rgb[3])
{
    CHECK(lighting == &record);
    record.point[record.n++] = *point;
    rgb[0] = rgb[1] = rgb[2] = 255;
}

static etch_varying *const varyings[] = {etch_varying_color, etch_varying_shade, NULL};
static const struct etch_phong noting = {note, &record};
static const struct etch_stage stages[] = {
    {etch_source_color, NULL}, {etch_stage_phong, &noting}, {etch_stage_write, NULL}, {NULL, NULL}};
static const struct etch_pipeline pipeline = {varyings, stages, etch_kernel_staged};

static void random_vertex(struct etch_shade_vertex *v, int kind, uint32_t *seed)
{
    int32_t n[3];
    int16_t unit[3];

    *v = (struct etch_shade_vertex){0};
    v->at.at.x_q8 = test_range(seed, -SIDE * 128, SIDE * 384);
    v->at.at.y_q8 = test_range(seed, -SIDE * 128, SIDE * 384);
    v->at.w = (uint32_t)test_range(seed, 1, kind == 0 ? 1 : 255);
    for (int k = 0; k < 3; k++)
        n[k] = test_range(seed, -100, 100) + (k == 2 ? 150 : 0);
    (void)etch_unit_q14(unit, n);
    for (int k = 0; k < 3; k++) {
        v->normal[k] = unit[k];
        v->position[k] = (int32_t)test_random(seed) >> (kind % 3 * 12);
    }
}

/* Twice the area that the centre of (x, y) spans with the edge a b, below 2^29. */
static int64_t span(const struct etch_vertex *a, const struct etch_vertex *b, int x, int y)
{
    const int64_t px = x * 256 + 128, py = y * 256 + 128;
    const int64_t area = (b->x_q8 - a->x_q8) * (py - a->y_q8) -
                         (b->y_q8 - a->y_q8) * (px - a->x_q8);

    return area;
}

/* The exact vector is the sum of e_i / w_i times normal i: of e_i w_j w_k, below 2^47, positive. */
static void check_pixel(const struct etch_shade_vertex v[3], int x, int y,
                        const struct etch_shade_point *p)
{
    int64_t weight[3], sum = 0, square = 0, most = 1 << 16, vector[3], root = 0;

    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;

        weight[i] = span(&v[j].at.at, &v[k].at.at, x, y) * v[j].at.w * v[k].at.w;
    }
    if (weight[0] < 0 || weight[1] < 0 || weight[2] < 0)
        for (int i = 0; i < 3; i++)
            weight[i] = -weight[i];
    for (int i = 0; i < 3; i++)
        sum += weight[i];
    for (int k = 0; k < 3; k++) {
        int64_t at = 0, error;

        vector[k] = 0;
        for (int i = 0; i < 3; i++) { /* by shares of 2^30: errs by 3 units of 2^-30 */
            int64_t share = weight[i];
            int64_t all = sum;

            for (; all >= INT64_C(1) << 33; all >>= 1)
                share >>= 1;
            share = share * (INT64_C(1) << 30) / all;
            vector[k] += share * v[i].normal[k]; /* 2.44 */
            at += share * (v[i].position[k] >> 1);
            if (v[i].position[k] > most || v[i].position[k] < -most)
                most = v[i].position[k] > 0 ? v[i].position[k] : -(int64_t)v[i].position[k];
        }
        vector[k] >>= 15; /* 2.29 */
        square += vector[k] * vector[k];
        error = p->position[k] - (at >> 29);
        CHECK((error < 0 ? -error : error) <= (most >> 21) + 4);
    }
    for (int64_t bit = INT64_C(1) << 30; bit != 0; bit >>= 1)
        if ((root + bit) * (root + bit) <= square)
            root += bit;
    for (int k = 0; k < 3; k++) {
        const int64_t error = p->normal[k] * root - vector[k] * 16384;

        CHECK((error < 0 ? -error : error) <= 3 * root);
    }
}

static void normals_and_positions_are_in_perspective(void)
{
    uint32_t seed = 1;
    int32_t pixels = 0;

    test_canvas_open(&canvas, (struct etch_rect){0, 0, SIDE, SIDE});
    for (int32_t n = 0; n < TEST_COUNT(300) && !test_failed(); n++) {
        struct etch_shade_vertex v[3];
        const struct etch_vertex *const corners[3] = {&v[0].at.at, &v[1].at.at, &v[2].at.at};
        int k = 0;

        for (int i = 0; i < 3; i++)
            random_vertex(&v[i], n % 6, &seed);
        test_canvas_wipe(&canvas);
        record.n = 0;
        etch_triangle_staged(&canvas.surface, corners, &pipeline, &planes.staged);
        for (int y = 0; y < SIDE; y++)
            for (int x = 0; x < SIDE; x++)
                if (test_canvas_drawn(&canvas, x, y)) {
                    check_pixel(v, x, y, &record.point[k++]);
                    pixels++;
                }
        CHECK_EQ(k, record.n);
        CHECK_ONCE(&canvas);
        if (test_failed())
            test_note("n", n);
    }
    test_print_count("", pixels, " pixels, each normal within 3 units of 2^-14");
}

void suite_phong(void)
{
    RUN(normals_and_positions_are_in_perspective);
}
