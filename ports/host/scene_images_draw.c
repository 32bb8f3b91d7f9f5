/* ports/host/scene_images_draw.c: what the statements of scene_images.c draw. */
#include "../../core/base/rgb565.h"
#include "../../core/fragment/sampler.h"
#include "../../core/fragment/source_map.h"
#include "../../core/fragment/write.h"
#include "../../core/frame/move.h"
#include "../../core/raster/map_runs.h"
#include "scene_image.h"

static struct etch_image_style style_of(const struct etch_scene_showing *w, int order)
{
    const struct etch_scene_format *const f = w->image->format;
    const struct etch_scene_row *const rows = w->opacity == UINT8_MAX ? f->full : f->fade;

    return (struct etch_image_style){&w->image->image[order], rows[order].row, w->opacity};
}

/* By stages; samplers take the image that is not swapped. */
static void show_linear(const struct etch_surface *s, const struct etch_scene_showing *w,
                        const struct etch_map *map, int order)
{
    struct etch_sampler sampler;
    const struct etch_blend_constant opacity = {w->opacity};
    const struct etch_stage stages[] = {
        {etch_source_map, map},
        {etch_stage_texture_replace, &sampler},
        {etch_stage_opacity, &opacity},
        {order == 1 ? etch_stage_read_swapped : etch_stage_read, NULL},
        {etch_stage_blend_alpha, NULL},
        {order == 1 ? etch_stage_write_swapped : etch_stage_write, NULL},
        {NULL, NULL}};
    const struct etch_staged_paint paint = {{etch_kernel_staged}, stages};

    if (etch_sampler_init(&sampler, &w->image->image[0], etch_filter_linear, etch_texels_clamp) ==
        ETCH_OK) {
        etch_map_runs(s, map, &paint.paint);
    }
}

void etch_scene_show_blit(const struct etch_surface *s, const struct etch_scene_showing *w,
                          int order)
{
    const struct etch_image_style style = style_of(w, order);
    const struct etch_rle_style packed = {&w->image->packed[order], style.row, w->opacity,
                                          w->image->line};

    if (w->image->compressed) {
        etch_rle_draw(s, &packed, w->at[0], w->at[1]);
    } else if (w->turn != 0) {
        etch_image_draw_turned(s, &style, w->at[0], w->at[1], (enum etch_turn)w->turn);
    } else {
        etch_image_draw_part(s, &style, w->part, w->at[0], w->at[1]);
    }
}

void etch_scene_show_stretch(const struct etch_surface *s, const struct etch_scene_showing *w,
                             int order)
{
    const struct etch_image_style style = style_of(w, order);
    struct etch_map map;

    if (!w->linear) {
        etch_image_draw_scaled(s, &style, w->part, w->at[0], w->at[1], w->at[2], w->at[3]);
        return;
    }
    etch_map_scale(&map, etch_rect_intersect(w->part, etch_image_whole(style.image)), w->at[0],
                   w->at[1], w->at[2], w->at[3]);
    show_linear(s, w, &map, order);
}

void etch_scene_show_nine(const struct etch_surface *s, const struct etch_scene_showing *w,
                          int order)
{
    const struct etch_image_style style = style_of(w, order);
    const struct etch_border border = {(uint16_t)w->at[4], (uint16_t)w->at[5], (uint16_t)w->at[6],
                                       (uint16_t)w->at[7]};

    etch_image_draw_nine(s, &style, &border, w->at[0], w->at[1], w->at[2], w->at[3]);
}

void etch_scene_show_spin(const struct etch_surface *s, const struct etch_scene_showing *w,
                          int order)
{
    const struct etch_image_style style = style_of(w, order);
    struct etch_map map;

    (void)etch_map_rotate(&map, etch_rect_intersect(w->part, etch_image_whole(style.image)),
                          &w->place); /* what cannot be draws nothing */
    if (w->linear) {
        show_linear(s, w, &map, order);
    } else {
        etch_image_draw_mapped(s, &style, &map);
    }
}

static uint16_t ordered(const struct etch_scene_showing *w, int order)
{
    const uint16_t color = etch_rgb565(w->rgb[0], w->rgb[1], w->rgb[2]);

    return order == 1 ? etch_rgb565_swap(color) : color;
}

void etch_scene_show_cursor(const struct etch_surface *s, const struct etch_scene_showing *w,
                            int order)
{
    const uint16_t ink[2] = {0, ordered(w, order)};
    struct etch_image image = w->image->image[0];
    const struct etch_image_style style = {&image, etch_row_index1_xor, UINT8_MAX};

    image.palette = ink;
    etch_image_draw(s, &style, w->at[0], w->at[1]);
}

void etch_scene_show_xor(const struct etch_surface *s, const struct etch_scene_showing *w,
                         int order)
{
    etch_rect_xor(s, w->at[0], w->at[1], w->at[2], w->at[3], ordered(w, order));
}

/* To another place of the same rows, which a strip has, too. */
void etch_scene_show_copy(const struct etch_surface *s, const struct etch_scene_showing *w,
                          int order)
{
    (void)order;
    etch_surface_copy_rect(s, w->at[4], w->at[1], s,
                           etch_rect_from_size(w->at[0], w->at[1], w->at[2], w->at[3]));
}

void etch_scene_show_scroll(const struct etch_surface *s, const struct etch_scene_showing *w,
                            int order)
{
    etch_surface_scroll(s, etch_rect_from_size(w->at[0], w->at[1], w->at[2], w->at[3]), w->at[4], 0,
                        ordered(w, order));
}
