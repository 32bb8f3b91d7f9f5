/* size/sprites.c: images of 16 colours and a key, turned by quarters and by any angle,
 * nine-patches. */
#include "size.h"

#include "../../../core/draw/image.h"

volatile int16_t size_at[4];
static uint8_t texels[64 * 32];

int main(void)
{
    static const struct etch_surface s = SIZE_SURFACE(NULL);
    static const uint16_t palette[16] = {0, 0xFFFF};
    static const struct etch_image image = {
        .texels = texels, .palette = palette, .width = 64, .height = 64, .stride = 64};
    static const struct etch_image_style style = {&image, etch_row_index4_key, 255};
    const struct etch_border border = {8, 8, 8, 8};
    const struct etch_map_place place = {
        0, 0, size_at[0], size_at[1], (uint16_t)size_at[2], ETCH_Q16_ONE, ETCH_Q16_ONE};
    struct etch_map map;

    etch_image_draw_turned(&s, &style, size_at[0], size_at[1], (enum etch_turn)size_at[2]);
    etch_image_draw_nine(&s, &style, &border, size_at[0], size_at[1], size_at[2], size_at[3]);
    (void)etch_map_rotate(&map, etch_image_whole(&image), &place);
    etch_image_draw_mapped(&s, &style, &map);
    return 0;
}
