/* size/packed.c: a run-length compressed image of a palette, and a mask blended in a colour. */
#include "size.h"

#include "../../../core/draw/image_rle.h"

volatile int16_t size_at[2];
static uint8_t data[999], alpha[64 * 64];
static uint32_t rows[8];
static uint16_t line[64];

int main(void)
{
    static const struct etch_surface s = SIZE_SURFACE(NULL);
    static const uint16_t palette[256] = {0, 0xFFFF};
    static const struct etch_rle_image image = {
        .image = {.palette = palette, .width = 64, .height = 64, .stride = 64},
        .texels = {etch_rle_bytes, data, rows, sizeof data, 64, 1, 1, 3}};
    static const struct etch_image mask = {
        .palette = palette, .alpha = alpha, .width = 64, .height = 64, .stride = 64};
    static const struct etch_rle_style style = {&image, etch_row_index8, 255, line};
    static const struct etch_image_style ink = {&mask, etch_row_mask8, 128};

    etch_rle_draw(&s, &style, size_at[0], size_at[1]);
    etch_image_draw(&s, &ink, size_at[0], size_at[1]);
    return 0;
}
