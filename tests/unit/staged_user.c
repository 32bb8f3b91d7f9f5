/* tests/unit: stages, varyings and kernels of one's own behind the painter of stages. */
#include "core/draw/staged.h"
#include "core/fragment/write.h"
#include "core/raster/plane.h"
#include "tests/harness/canvas.h"

void suite_staged_user(void);

static struct test_canvas canvas;
static struct etch_staged_planes planes;

#define END                                                                                        \
    {                                                                                              \
        NULL, NULL                                                                                 \
    }

/* A varying and a source of one's own behind the shipped planes, and a stage that drops pixels. */
struct distance_planes {
    struct etch_staged_planes shipped;
    struct etch_plane distance;
};

static void set_distance(struct etch_staged_planes *p, const struct etch_varying_input *in)
{
    static const uint32_t value[3] = {0, 0, UINT32_C(8) << 16};

    etch_plane_setup(&((struct distance_planes *)(void *)p)->distance, in->triangle, value);
}

static void drop_far(struct etch_chunk *c, const void *data)
{
    const struct distance_planes *p = (const struct distance_planes *)(const void *)c->paint;
    uint16_t i;

    for (i = 0; i < c->n; i++)
        if (etch_plane_at(&p->distance, (int16_t)(c->x + i), c->y) >> 16 >= *(const uint32_t *)data)
            c->alive = (uint16_t)(c->alive & ~(UINT32_C(1) << i));
}

static void stages_and_varyings_of_ones_own(void)
{
    static const uint32_t limit = 3;
    static etch_varying *const varyings[] = {etch_varying_flat, set_distance, NULL};
    static const struct etch_stage stages[] = {
        {etch_source_flat, NULL}, {drop_far, &limit}, {etch_stage_write, NULL}, END};
    static const struct etch_pipeline pipeline = {varyings, stages, etch_kernel_staged};
    static struct distance_planes own;
    const struct etch_vertex a = {0, 0, 0, 0, 0, 8, 0}, b = {8 * 256, 0, 0, 0, 0, 8, 0};
    const struct etch_vertex c = {0, 8 * 256, 0, 0, 0, 8, 0};
    const struct etch_vertex *const v[3] = {&a, &b, &c};
    const struct etch_rect window = {0, 0, 9, 5};

    test_canvas_open(&canvas, window);
    etch_triangle_staged(&canvas.surface, v, &pipeline, &own.shipped);
    CHECK_PICTURE(&canvas, "aaaaaaa.."
                           "aaaaaa..."
                           "aaaaa...."
                           "........."
                           ".........");
}

/* A kernel of one's own over the planes that the painter sets up: no stages at all. */
static void dots(const struct etch_surface *s, int16_t y0, const struct etch_run *runs, uint8_t n,
                 const struct etch_paint *paint)
{
    const struct etch_staged_planes *p = (const struct etch_staged_planes *)(const void *)paint;
    uint8_t i;

    for (i = 0; i < n; i++) {
        const int16_t y = (int16_t)(y0 + i);
        int16_t x;

        for (x = runs[i].x0; x < runs[i].x1; x++)
            if ((x + y) % 2 == 0)
                s->pixels[etch_surface_index(s, x, y)] =
                    (uint16_t)(etch_plane_at(&p->color.linear.b, x, y) >> 27);
    }
}

static void kernels_of_ones_own(void)
{
    static etch_varying *const varyings[] = {etch_varying_color, NULL};
    static const struct etch_pipeline pipeline = {varyings, NULL, dots};
    const struct etch_vertex a = {0, 0, 0, 0, 0, 8, 0}, b = {6 * 256, 0, 0, 0, 0, 8, 0};
    const struct etch_vertex c = {0, 6 * 256, 0, 0, 0, 8, 0};
    const struct etch_vertex *const v[3] = {&a, &b, &c};
    const struct etch_rect window = {0, 0, 7, 4};

    test_canvas_open(&canvas, window);
    etch_triangle_staged(&canvas.surface, v, &pipeline, &planes);
    CHECK_PICTURE(&canvas, "a.a.a.."
                           ".a.a..."
                           "a.a...."
                           ".a.....");
}

void suite_staged_user(void)
{
    RUN(stages_and_varyings_of_ones_own);
    RUN(kernels_of_ones_own);
}
