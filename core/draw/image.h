/* draw/image.h: images on the frame: blit, flip, quarter turns, scaling, any turn, nine-patches.
 *
 * An image style is an image (struct etch_image of base/texture.h), a row function and an opacity.
 * Like a paint, the row function is named, so that only what is used is linked; it must fit the
 * image:
 *
 *  image              row function                    what it writes
 *  RGB565             etch_row_rgb565                 the texels
 *                     etch_row_rgb565_key             those that are not palette[0]
 *                     etch_row_rgb565_fade     *      the texels by opacity
 *   + alpha plane     etch_row_rgb565_alpha    *      the texels by alpha and opacity
 *  palette, 8 4 2 1   etch_row_index8 4 2 1           the colours
 *                     etch_row_index8_key ..          those of texels that are not 0
 *                     etch_row_index8_fade ..  *      the colours by opacity
 *  mask, 8 4 bits     etch_row_mask8 4         *      palette[0] by the mask and opacity
 *  1 bit              etch_row_index1_xor             palette[1], exclusive or, where texels are 1:
 *                                                     the same call again takes it away (cursors)
 *
 * Rows marked * blend, and have a twin .._swapped for surfaces in rgb565_swapped. All colours,
 * palettes included, are in the surface's byte order (etch-image -s writes swapped ones); samplers
 * (fragment/sampler.h) want etch_rgb565's always. Opacity is read by rows that blend, 255 is full.
 *
 *  texels    RGB565: uint16_t. 8 bits: a byte. 4, 2, 1 bits: texel row * stride + column, the first
 *            of a byte in its lowest bits (rows need not begin with a byte)
 *  masks     `alpha`, a byte or 4 bits a texel, 255 or 15 full; rgb565_alpha: a byte a texel
 *  colors    and alphas may be NULL if the image is not sampled: then they are not linked
 *
 * Blending: a = round(alpha opacity / 255), then a channel is (texel a + there (255 - a)) / 255
 * rounded to the nearest once (there are no ties); a = 0 does not touch the pixel, 255 writes the
 * texel. image_row.h makes row functions that are not shipped in a line each.
 *
 * Every x, y, w and h is legal; pixels are written once, inside the clip; what is outside costs
 * nothing but the interval of its row. An image without texels draws nothing. Instructions a pixel
 * of the loops for Cortex-M0+ (gcc 12, -O2): rgb565 1.3 where texels and pixels begin on the same
 * side of a word, 2.5 where not; index8 8, along a map 14. A row takes some 70 more.
 */
#ifndef ETCH_DRAW_IMAGE_H
#define ETCH_DRAW_IMAGE_H

#include "../base/map.h"
#include "../base/surface.h"
#include "../base/texture.h"

/* A straight line of texels. Pixel k of a row shows texel `place` (row * stride + column) after k
 * steps; each time that `down` passes 2^32 the place goes on by a row. Both are modulo their sizes.
 */
struct etch_image_line {
    const struct etch_image *image;
    uint64_t place_q32, step_q32;
    uint32_t down, down_step;
    uint8_t opacity;
};

/* Writes n >= 1 pixels from `to` on. All texels of the line are in the image. */
typedef void etch_image_row(uint16_t *to, uint16_t n, const struct etch_image_line *line);

struct etch_image_style {
    const struct etch_image *image;
    etch_image_row *row;
    uint8_t opacity;
};

etch_image_row etch_row_rgb565, etch_row_rgb565_key;
etch_image_row etch_row_rgb565_fade, etch_row_rgb565_fade_swapped;
etch_image_row etch_row_rgb565_alpha, etch_row_rgb565_alpha_swapped;
etch_image_row etch_row_index8, etch_row_index8_key;
etch_image_row etch_row_index8_fade, etch_row_index8_fade_swapped;
etch_image_row etch_row_index4, etch_row_index4_key;
etch_image_row etch_row_index4_fade, etch_row_index4_fade_swapped;
etch_image_row etch_row_index2, etch_row_index2_key;
etch_image_row etch_row_index2_fade, etch_row_index2_fade_swapped;
etch_image_row etch_row_index1, etch_row_index1_key, etch_row_index1_xor;
etch_image_row etch_row_index1_fade, etch_row_index1_fade_swapped;
etch_image_row etch_row_mask8, etch_row_mask8_swapped;
etch_image_row etch_row_mask4, etch_row_mask4_swapped;

/* The image with its upper left pixel at (x, y). */
void etch_image_draw(const struct etch_surface *s, const struct etch_image_style *style, int16_t x,
                     int16_t y);

/* Its texels `part`, the first of them at (x, y); what the image lacks is left out. For sheets. */
void etch_image_draw_part(const struct etch_surface *s, const struct etch_image_style *style,
                          struct etch_rect part, int16_t x, int16_t y);

/* Clockwise quarters, of the image or of its mirror image: MIRROR + HALF is upside down. */
enum etch_turn {
    ETCH_TURN_NONE,
    ETCH_TURN_RIGHT,
    ETCH_TURN_HALF,
    ETCH_TURN_LEFT,
    ETCH_TURN_MIRROR, /* left and right exchanged, then as above */
    ETCH_TURN_MIRROR_RIGHT,
    ETCH_TURN_MIRROR_HALF,
    ETCH_TURN_MIRROR_LEFT
};

/* The image, turned, with what is then its upper left pixel at (x, y); `turn` modulo 8. */
void etch_image_draw_turned(const struct etch_surface *s, const struct etch_image_style *style,
                            int16_t x, int16_t y, enum etch_turn turn);

/* The nearest texel of each place that the map shows (base/map.h): scaling, any turn, any shear.
 * Places outside the image are left out. Costs some 6 instructions a pixel more than a blit, and
 * 100 to 700 a row inside the map's bounds. */
void etch_image_draw_mapped(const struct etch_surface *s, const struct etch_image_style *style,
                            const struct etch_map *map);

/* Its texels `part`, as far as the image has them, stretched over the rectangle (x, y, w, h): pixel
 * i of w shows texel floor((2 i + 1) n / (2 w)) of n, exactly; rows likewise. w or h <= 0 draws
 * nothing. Costs four 64-bit divisions a call, and as a mapped image without what that takes for a
 * row's ends. */
void etch_image_draw_scaled(const struct etch_surface *s, const struct etch_image_style *style,
                            struct etch_rect part, int16_t x, int16_t y, int16_t w, int16_t h);

/* Widths of a frame. */
struct etch_border {
    uint16_t left, top, right, bottom;
};

/* A nine-patch over the rectangle (x, y, w, h): corners of the image as they are, its sides and its
 * middle stretched between them as draw_scaled does. Where the rectangle is narrower than both
 * borders, a side of w pixels shows the outer left w left / (left + right) columns on the left,
 * rounded down, and the outer others on the right; likewise top and bottom. Borders are cut to the
 * image: left first. */
void etch_image_draw_nine(const struct etch_surface *s, const struct etch_image_style *style,
                          const struct etch_border *border, int16_t x, int16_t y, int16_t w,
                          int16_t h);

/* All of the image. */
ETCH_INLINE struct etch_rect etch_image_whole(const struct etch_image *image)
{
    const struct etch_rect all = {0, 0, (int16_t)image->width, (int16_t)image->height};

    return all;
}

#endif
