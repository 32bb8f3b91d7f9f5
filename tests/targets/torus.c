/* tests/targets: tori, lit, with depth: of 100 triangles for small memories, of 1000, and one that
 * spins. Linked with each firmware and with the host's reference. */
#include "core/etch.h"
#include "scenes.h"

enum {
    RING = 1 << 10, /* radii in 1/1024 */
    TUBE = 420,
    SPIN = 65536 / 8
};

/* The memory of a torus of `around` times `along` vertices. */
struct torus {
    struct etch_mesh mesh;
    struct etch_mesh_vertex *kept;
    int16_t *positions;
    int8_t *normals;
    uint16_t *indices;
    uint16_t around, along;
};

#define TORUS(name, AROUND, ALONG)                                                                 \
    static int16_t name##_positions[(AROUND) * (ALONG)*3];                                         \
    static int8_t name##_normals[(AROUND) * (ALONG)*3];                                            \
    static uint16_t name##_indices[(AROUND) * (ALONG)*6];                                          \
    static struct etch_mesh_vertex name##_kept[(AROUND) * (ALONG)];                                \
    static const struct torus name = {.mesh = {.positions = name##_positions,                      \
                                               .normals = name##_normals,                          \
                                               .indices = name##_indices,                          \
                                               .vertex_count = (AROUND) * (ALONG),                 \
                                               .triangle_count = 2 * (AROUND) * (ALONG),           \
                                               .extent = RING + TUBE,                              \
                                               .bits = 10},                                        \
                                      .kept = name##_kept,                                         \
                                      .positions = name##_positions,                               \
                                      .normals = name##_normals,                                   \
                                      .indices = name##_indices,                                   \
                                      .around = (AROUND),                                          \
                                      .along = (ALONG)}

static int16_t frame_width, frame_height;

/* a b / 65536, towards zero on every machine. */
static int32_t product_q16(int32_t a, etch_q16 b)
{
    return a * (b / 16) / 4096;
}

static void make_vertex(const struct torus *t, uint16_t i, uint16_t j)
{
    const uint16_t along = (uint16_t)(65536 * (uint32_t)i / t->around);
    const uint16_t round = (uint16_t)(65536 * (uint32_t)j / t->along);
    const int32_t out = product_q16(TUBE, etch_cos_q16(round));
    const int32_t face = product_q16(127, etch_cos_q16(round));
    int16_t *p = t->positions + (i * t->along + j) * 3;
    int8_t *n = t->normals + (i * t->along + j) * 3;

    p[0] = (int16_t)product_q16(RING + out, etch_cos_q16(along));
    p[1] = (int16_t)product_q16(RING + out, etch_sin_q16(along));
    p[2] = (int16_t)product_q16(TUBE, etch_sin_q16(round));
    n[0] = (int8_t)product_q16(face, etch_cos_q16(along));
    n[1] = (int8_t)product_q16(face, etch_sin_q16(along));
    n[2] = (int8_t)product_q16(127, etch_sin_q16(round));
}

static void make_torus(const struct torus *t, int16_t width, int16_t height)
{
    uint16_t *index = t->indices;

    frame_width = width;
    frame_height = height;
    for (uint16_t i = 0; i < t->around; i++)
        for (uint16_t j = 0; j < t->along; j++) {
            const uint16_t next = (uint16_t)((i + 1) % t->around * t->along);
            const uint16_t up = (uint16_t)((j + 1) % t->along), row = (uint16_t)(i * t->along);

            make_vertex(t, i, j);
            *index++ = (uint16_t)(row + j);
            *index++ = (uint16_t)(next + j);
            *index++ = (uint16_t)(next + up);
            *index++ = (uint16_t)(row + j);
            *index++ = (uint16_t)(next + up);
            *index++ = (uint16_t)(row + up);
        }
}

static void draw_torus(const struct torus *t, uint16_t turned, const struct etch_surface *s,
                       bool swapped)
{
    const struct etch_vector eye = {0, ETCH_Q16(-5, 2), ETCH_Q16(5, 2)}, target = {0, 0, 0};
    const struct etch_vector up = {0, 0, ETCH_Q16_ONE};
    const struct etch_vector sun = {ETCH_Q16(1, 1), ETCH_Q16(-2, 1), ETCH_Q16(3, 1)};
    struct etch_light light = {.diffuse = {220, 160, 60}};
    const struct etch_lighting lighting = {.ambient = {30, 30, 50}, .count = 1, .light = &light};
    struct etch_matrix model, view, clip;
    struct etch_mesh_stage stage;
    struct etch_raster_sink sink;
    struct etch_assembly assembly = {.cull = ETCH_CULL_CLOCKWISE, .sink = &sink.sink};

    etch_surface_clear(s, target_color(swapped, 0, 12, 30));
    etch_depth_clear(s, 65535);
    etch_matrix_rotate_x(&model, turned);
    if (etch_matrix_look_at(&view, &eye, &target, &up) != ETCH_OK ||
        etch_matrix_perspective(&clip, 65536 / 8,
                                (etch_q16)((int32_t)frame_width * 4096 / frame_height * 16),
                                ETCH_Q16(1, 1), ETCH_Q16(9, 1)) != ETCH_OK ||
        etch_matrix_multiply(&clip, &clip, &view) != ETCH_OK ||
        etch_matrix_multiply(&clip, &clip, &model) != ETCH_OK ||
        etch_light_aim(&light, &model, &sun) != ETCH_OK ||
        etch_viewport_init(&assembly.viewport,
                           (struct etch_rect){0, 0, frame_width, frame_height}) != ETCH_OK)
        return;
    etch_mesh_stage_init(&stage, &t->mesh, &clip, etch_vertex_lit, &lighting);
    etch_raster_sink_init(&sink, s, etch_triangle_gouraud_depth,
                          swapped ? etch_kernel_gouraud_less_swapped : etch_kernel_gouraud_less);
    (void)etch_mesh_draw(&stage, &assembly, t->kept, t->mesh.vertex_count);
}

/* ---- 100 triangles, still and spinning ---------------------------------------------------------
 */

TORUS(small, 10, 5);
static uint16_t turned;
static bool made;

static void prepare_small(int16_t width, int16_t height)
{
    make_torus(&small, width, height);
}

static void draw_small(const struct etch_surface *s, bool swapped)
{
    draw_torus(&small, 0, s, swapped);
}

static void prepare_spin(int16_t width, int16_t height)
{
    if (!made)
        make_torus(&small, width, height);
    made = true;
    turned = (uint16_t)((turned + SPIN) & 0xFFFF);
}

static void draw_spin(const struct etch_surface *s, bool swapped)
{
    draw_torus(&small, turned, s, swapped);
}

const struct target_scene target_torus = {"torus", prepare_small, draw_small};
const struct target_scene target_spin = {"spin", prepare_spin, draw_spin};

/* ---- 1000 triangles ----------------------------------------------------------------------------
 */

TORUS(large, 50, 10);

static void prepare_large(int16_t width, int16_t height)
{
    make_torus(&large, width, height);
}

static void draw_large(const struct etch_surface *s, bool swapped)
{
    draw_torus(&large, 0, s, swapped);
}

const struct target_scene target_mesh = {"mesh", prepare_large, draw_large};
