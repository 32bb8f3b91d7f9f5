/* draw/image_row.h: the loops that row functions are made from, shipped ones and yours. A line
 * makes one:
 *
 *  ETCH_ROW_COPY(my_row, etch_texel_index8)                     a colour, see fragment/texel.h
 *  ETCH_ROW_KEY(my_row, etch_texel_index8, etch_texel_byte)     .. where the second is not 0
 *  ETCH_ROW_BLEND(my_row, etch_texel_index8, etch_texel_alpha8, false)   .. by alpha and opacity;
 *                                                               true: byte-swapped surfaces
 */
#ifndef ETCH_DRAW_IMAGE_ROW_H
#define ETCH_DRAW_IMAGE_ROW_H

#include "../base/rgb565.h"
#include "../fragment/texel.h"
#include "image.h"

/* What is done with one pixel. */
typedef void etch_image_pixel(uint16_t *to, const struct etch_image *image, uint32_t place,
                              uint32_t opacity);

ETCH_INLINE uint64_t etch_image_wrap_step(uint64_t place_q32, uint64_t step_q32)
{
    return place_q32 + step_q32;
}

/* Along a row or a column, by whole texels. */
ETCH_INLINE void etch_image_row_straight(uint16_t *to, uint16_t n,
                                         const struct etch_image_line *line,
                                         etch_image_pixel *pixel)
{
    const struct etch_image image = *line->image;
    const uint32_t opacity = line->opacity, step = (uint32_t)(line->step_q32 >> 32);
    uint32_t place = (uint32_t)(line->place_q32 >> 32);

    for (uint16_t *const end = to + n; to != end; to++) {
        pixel(to, &image, place, opacity);
        place = etch_wrap_add(place, step);
    }
}

/* In any direction. */
ETCH_INLINE void etch_image_row_sloped(uint16_t *to, uint16_t n, const struct etch_image_line *line,
                                       etch_image_pixel *pixel)
{
    const struct etch_image image = *line->image;
    const uint32_t opacity = line->opacity, down_step = line->down_step;
    const uint64_t step = line->step_q32, row = (uint64_t)image.stride << 32;
    uint64_t place = line->place_q32;
    uint32_t down = line->down;

    for (uint16_t *const end = to + n; to != end; to++) {
        pixel(to, &image, (uint32_t)(place >> 32), opacity);
        place = etch_image_wrap_step(place, step);
        down = etch_wrap_add(down, down_step);
        if (down < down_step)
            place = etch_image_wrap_step(place, row);
    }
}

ETCH_INLINE bool etch_image_line_is_straight(const struct etch_image_line *line)
{
    return ((uint32_t)line->step_q32 | line->down_step) == 0;
}

ETCH_INLINE void etch_image_row_any(uint16_t *to, uint16_t n, const struct etch_image_line *line,
                                    etch_image_pixel *pixel)
{
    if (etch_image_line_is_straight(line))
        etch_image_row_straight(to, n, line, pixel);
    else
        etch_image_row_sloped(to, n, line, pixel);
}

/* Both products of a word stay in their halves: 31 255 + 127 < 2^16. x / 255 rounded down is
 * (x + 1 + x / 256) / 256 for x < 65535. */
ETCH_INLINE uint16_t etch_image_mix(uint16_t color, uint16_t there, uint32_t a)
{
    const uint32_t c = color, d = there, keep = 255 - a;
    const uint32_t rb = (c >> 11 | (c & 31) << 16) * a + (d >> 11 | (d & 31) << 16) * keep +
                        UINT32_C(0x00800080); /* 127 of rounding and the 1 */
    const uint32_t g = (c >> 5 & 63) * a + (d >> 5 & 63) * keep + 128;
    const uint32_t q = (rb + ((rb - UINT32_C(0x00010001)) >> 8 & UINT32_C(0x00FF00FF))) >> 8;

    return (uint16_t)((q & 31) << 11 | (g + ((g - 1) >> 8)) >> 8 << 5 | (q >> 16 & 31));
}

/* round(a opacity / 255); there are no ties. */
ETCH_INLINE uint32_t etch_image_alpha(uint32_t a, uint32_t opacity)
{
    const uint32_t t = a * opacity + 128;

    return (t + (t >> 8)) >> 8;
}

ETCH_INLINE void etch_image_blend(uint16_t *to, uint16_t color, uint32_t a, bool swapped)
{
    if (a == 255)
        *to = color;
    else if (a != 0 && swapped)
        *to = etch_rgb565_swap(etch_image_mix(etch_rgb565_swap(color), etch_rgb565_swap(*to), a));
    else if (a != 0)
        *to = etch_image_mix(color, *to, a);
}

/* An opaque texel. */
ETCH_INLINE uint8_t etch_texel_opaque(const struct etch_image *image, uint32_t place)
{
    (void)image;
    (void)place;
    return 255;
}

#define ETCH_ROW_COPY(name, color)                                                                 \
    ETCH_INLINE void name##_pixel(uint16_t *to, const struct etch_image *image, uint32_t place,    \
                                  uint32_t opacity)                                                \
    {                                                                                              \
        (void)opacity;                                                                             \
        *to = color(image, place);                                                                 \
    }                                                                                              \
    void name(uint16_t *to, uint16_t n, const struct etch_image_line *line)                        \
    {                                                                                              \
        etch_image_row_any(to, n, line, name##_pixel);                                             \
    }

#define ETCH_ROW_KEY(name, color, shows)                                                           \
    ETCH_INLINE void name##_pixel(uint16_t *to, const struct etch_image *image, uint32_t place,    \
                                  uint32_t opacity)                                                \
    {                                                                                              \
        (void)opacity;                                                                             \
        if (shows(image, place) != 0)                                                              \
            *to = color(image, place);                                                             \
    }                                                                                              \
    void name(uint16_t *to, uint16_t n, const struct etch_image_line *line)                        \
    {                                                                                              \
        etch_image_row_any(to, n, line, name##_pixel);                                             \
    }

/* One loop: what blending takes hides the steps. */
#define ETCH_ROW_BLEND(name, color, alpha, swapped)                                                \
    ETCH_INLINE void name##_pixel(uint16_t *to, const struct etch_image *image, uint32_t place,    \
                                  uint32_t opacity)                                                \
    {                                                                                              \
        etch_image_blend(to, color(image, place), etch_image_alpha(alpha(image, place), opacity),  \
                         swapped);                                                                 \
    }                                                                                              \
    void name(uint16_t *to, uint16_t n, const struct etch_image_line *line)                        \
    {                                                                                              \
        etch_image_row_sloped(to, n, line, name##_pixel);                                          \
    }

#endif
