/* tests/targets: what every board draws. Linked with each firmware and with the host's reference.
 * Sizes follow the frame, so that small panels show the same. */
#include "scenes.h"

#include "core/etch.h"

static int16_t frame_width, frame_height;

static uint16_t color(bool swapped, uint8_t r, uint8_t g, uint8_t b)
{
    const uint16_t c = etch_rgb565(r, g, b);
    return swapped ? etch_rgb565_swap(c) : c;
}

static void keep_size(int16_t width, int16_t height)
{
    frame_width = width;
    frame_height = height;
}

/* ---- every shape, across the borders ---------------------------------------------------------- */

static void draw_shapes(const struct etch_surface *s, bool swapped)
{
    const int16_t w = frame_width, h = frame_height;
    const int16_t cx = (int16_t)(w / 2), cy = (int16_t)(h / 2), r = (int16_t)(h * 2 / 5);

    etch_surface_clear(s, color(swapped, 16, 24, 40));
    etch_rect_fill(s, (int16_t)(-w / 8), (int16_t)(h / 8), (int16_t)(w / 3), (int16_t)(h / 4),
                   color(swapped, 40, 90, 160));
    etch_circle_fill(s, cx, cy, r, color(swapped, 230, 150, 30));
    etch_circle_draw(s, cx, cy, (int16_t)(r + h / 4), color(swapped, 250, 240, 200));
    etch_triangle_fill(s, w, (int16_t)(-h / 6), (int16_t)(w + w / 6), h, cx, (int16_t)(h - 4),
                       color(swapped, 30, 140, 80));
    etch_triangle_draw(s, 3, (int16_t)(h - 3), cx, 3, (int16_t)(w - 3), (int16_t)(h - 3),
                       color(swapped, 255, 255, 255));
    for (int16_t i = 0; i < 12; i++)
        etch_line_draw(s, -9, (int16_t)(h * i / 12), (int16_t)(w + 9), (int16_t)(h - h * i / 12),
                       color(swapped, 120, (uint8_t)(20 * i), 200));
    etch_rect_draw(s, 0, 0, w, h, color(swapped, 200, 60, 60));
}

/* ---- a torus of 100 triangles, lit, with depth ------------------------------------------------- */

enum {
    AROUND = 10,
    ALONG = 5,
    VERTICES = AROUND * ALONG,
    TRIANGLES = 2 * VERTICES,
    RING = 1 << 10, /* radii in 1/1024 */
    TUBE = 420
};
static int16_t torus_positions[VERTICES * 3];
static int8_t torus_normals[VERTICES * 3];
static uint16_t torus_indices[TRIANGLES * 3];
static struct etch_mesh_vertex torus_kept[VERTICES];
static const struct etch_mesh torus = {.positions = torus_positions,
                                       .normals = torus_normals,
                                       .indices = torus_indices,
                                       .vertex_count = VERTICES,
                                       .triangle_count = TRIANGLES,
                                       .extent = RING + TUBE,
                                       .bits = 10};

/* a b / 65536, towards zero on every machine. */
static int32_t product_q16(int32_t a, etch_q16 b)
{
    return a * (b / 16) / 4096;
}

static void make_vertex(uint16_t i, uint16_t j)
{
    const uint16_t along = (uint16_t)(65536 * (uint32_t)i / AROUND);
    const uint16_t round = (uint16_t)(65536 * (uint32_t)j / ALONG);
    const int32_t out = product_q16(TUBE, etch_cos_q16(round));
    const int32_t face = product_q16(127, etch_cos_q16(round));
    int16_t *p = torus_positions + (i * ALONG + j) * 3;
    int8_t *n = torus_normals + (i * ALONG + j) * 3;

    p[0] = (int16_t)product_q16(RING + out, etch_cos_q16(along));
    p[1] = (int16_t)product_q16(RING + out, etch_sin_q16(along));
    p[2] = (int16_t)product_q16(TUBE, etch_sin_q16(round));
    n[0] = (int8_t)product_q16(face, etch_cos_q16(along));
    n[1] = (int8_t)product_q16(face, etch_sin_q16(along));
    n[2] = (int8_t)product_q16(127, etch_sin_q16(round));
}

static void make_torus(int16_t width, int16_t height)
{
    uint16_t *index = torus_indices;

    keep_size(width, height);
    for (uint16_t i = 0; i < AROUND; i++)
        for (uint16_t j = 0; j < ALONG; j++) {
            const uint16_t next = (uint16_t)((i + 1) % AROUND * ALONG);
            const uint16_t up = (uint16_t)((j + 1) % ALONG), row = (uint16_t)(i * ALONG);

            make_vertex(i, j);
            *index++ = (uint16_t)(row + j);
            *index++ = (uint16_t)(next + j);
            *index++ = (uint16_t)(next + up);
            *index++ = (uint16_t)(row + j);
            *index++ = (uint16_t)(next + up);
            *index++ = (uint16_t)(row + up);
        }
}

static void draw_torus(const struct etch_surface *s, bool swapped)
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

    etch_surface_clear(s, color(swapped, 0, 12, 30));
    etch_depth_clear(s, 65535);
    etch_matrix_identity(&model);
    if (etch_matrix_look_at(&view, &eye, &target, &up) != ETCH_OK ||
        etch_matrix_perspective(&clip, 65536 / 8,
                                (etch_q16)((int32_t)frame_width * 4096 / frame_height * 16),
                                ETCH_Q16(1, 1), ETCH_Q16(9, 1)) != ETCH_OK ||
        etch_matrix_multiply(&clip, &clip, &view) != ETCH_OK ||
        etch_light_aim(&light, &model, &sun) != ETCH_OK ||
        etch_viewport_init(&assembly.viewport,
                           (struct etch_rect){0, 0, frame_width, frame_height}) != ETCH_OK)
        return;
    etch_mesh_stage_init(&stage, &torus, &clip, etch_vertex_lit, &lighting);
    etch_raster_sink_init(&sink, s, etch_triangle_gouraud_depth,
                          swapped ? etch_kernel_gouraud_less_swapped : etch_kernel_gouraud_less);
    (void)etch_mesh_draw(&stage, &assembly, torus_kept, VERTICES);
}

/* ---- a chequered floor to the horizon ---------------------------------------------------------- */

static uint16_t tile[16 * 16];

static void draw_floor(const struct etch_surface *s, bool swapped)
{
    const int32_t right = (int32_t)frame_width * 256, bottom = (int32_t)frame_height * 256;
    const int32_t horizon = bottom * 2 / 5, depth = INT32_C(32) << 16;
    const struct etch_texture_vertex corner[4] = {
        {{0, horizon, UINT32_C(60000) << 16, 0, 0, 0, 255}, 0, 8 * depth, 32},
        {{right, horizon, UINT32_C(60000) << 16, 0, 0, 0, 255}, 8 * depth, 8 * depth, 32},
        {{2 * right, bottom, UINT32_C(9000) << 16, 0, 0, 0, 255}, 5 * depth, 0, 1},
        {{-right, bottom, UINT32_C(9000) << 16, 0, 0, 0, 255}, 3 * depth, 0, 1}};
    const struct etch_texture_vertex *const left[3] = {&corner[0], &corner[2], &corner[1]};
    const struct etch_texture_vertex *const other[3] = {&corner[0], &corner[3], &corner[2]};
    struct etch_texture texture;

    for (uint16_t i = 0; i < 256; i++)
        tile[i] = ((i >> 3 ^ i >> 7) & 1) != 0 ? color(swapped, 230, (uint8_t)(255 - i), 190)
                                               : color(swapped, 20, 40, (uint8_t)(i / 2));
    etch_surface_clear(s, color(swapped, 110, 160, 220));
    etch_depth_clear(s, 65535);
    if (etch_texture_init(&texture, tile, 16, 16) != ETCH_OK)
        return;
    etch_triangle_perspective_depth(s, left, &texture, &etch_perspective_less);
    etch_triangle_perspective_depth(s, other, &texture, &etch_perspective_less);
}

const struct target_scene target_scenes[] = {{"shapes", keep_size, draw_shapes},
                                             {"torus", make_torus, draw_torus},
                                             {"floor", keep_size, draw_floor},
                                             {NULL, NULL, NULL}};
