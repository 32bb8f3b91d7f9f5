/* tests/targets: flat shapes and a floor in perspective. Linked with each firmware and with the
 * host's reference. Sizes follow the frame, so that small panels show the same. */
#include "scenes.h"

#include "core/etch.h"

static int16_t frame_width, frame_height;

static void keep_size(int16_t width, int16_t height)
{
    frame_width = width;
    frame_height = height;
}

/* ---- every shape, across the borders ----------------------------------------------------------
 */

static void draw_shapes(const struct etch_surface *s, bool swapped)
{
    const int16_t w = frame_width, h = frame_height;
    const int16_t cx = (int16_t)(w / 2), cy = (int16_t)(h / 2), r = (int16_t)(h * 2 / 5);

    etch_surface_clear(s, target_color(swapped, 16, 24, 40));
    etch_rect_fill(s, (int16_t)(-w / 8), (int16_t)(h / 8), (int16_t)(w / 3), (int16_t)(h / 4),
                   target_color(swapped, 40, 90, 160));
    etch_circle_fill(s, cx, cy, r, target_color(swapped, 230, 150, 30));
    etch_circle_draw(s, cx, cy, (int16_t)(r + h / 4), target_color(swapped, 250, 240, 200));
    etch_triangle_fill(s, w, (int16_t)(-h / 6), (int16_t)(w + w / 6), h, cx, (int16_t)(h - 4),
                       target_color(swapped, 30, 140, 80));
    etch_triangle_draw(s, 3, (int16_t)(h - 3), cx, 3, (int16_t)(w - 3), (int16_t)(h - 3),
                       target_color(swapped, 255, 255, 255));
    for (int16_t i = 0; i < 12; i++)
        etch_line_draw(s, -9, (int16_t)(h * i / 12), (int16_t)(w + 9), (int16_t)(h - h * i / 12),
                       target_color(swapped, 120, (uint8_t)(20 * i), 200));
    etch_rect_draw(s, 0, 0, w, h, target_color(swapped, 200, 60, 60));
}

const struct target_scene target_shapes = {"shapes", keep_size, draw_shapes};

/* ---- a chequered floor to the horizon ----------------------------------------------------------
 */

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
        tile[i] = ((i >> 3 ^ i >> 7) & 1) != 0 ? target_color(swapped, 230, (uint8_t)(255 - i), 190)
                                               : target_color(swapped, 20, 40, (uint8_t)(i / 2));
    etch_surface_clear(s, target_color(swapped, 110, 160, 220));
    etch_depth_clear(s, 65535);
    if (etch_texture_init(&texture, tile, 16, 16) != ETCH_OK)
        return;
    etch_triangle_perspective_depth(s, left, &texture, &etch_perspective_less);
    etch_triangle_perspective_depth(s, other, &texture, &etch_perspective_less);
}

const struct target_scene target_floor = {"floor", keep_size, draw_floor};
