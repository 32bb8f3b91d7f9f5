/* size/blit.c: RGB565 images as they are, copied and scrolled. */
#include "size.h"

#include "../../../core/draw/image.h"
#include "../../../core/frame/move.h"

volatile int16_t size_at[4];
static uint16_t texels[64 * 64];

int main(void)
{
    static const struct etch_surface s = SIZE_SURFACE(NULL);
    static const struct etch_image image = {
        .texels = texels, .width = 64, .height = 64, .stride = 64};
    static const struct etch_image_style style = {&image, etch_row_rgb565, 255};
    const struct etch_rect area = etch_rect_from_size(size_at[0], size_at[1], 99, 99);

    etch_image_draw(&s, &style, size_at[0], size_at[1]);
    etch_surface_copy_rect(&s, size_at[2], size_at[3], &s, area);
    etch_surface_scroll(&s, area, size_at[2], size_at[3], 0);
    return 0;
}
