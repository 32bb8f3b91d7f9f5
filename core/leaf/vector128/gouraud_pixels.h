/* leaf/vector128/gouraud_pixels.h: interpolated colour, eight pixels at a time; no part of the API.
 * The planes are those of fragment/gouraud_rows.h, four columns to a vector: sums modulo 2^32 do
 * not depend on their order, so every pixel has the portable one's value. */
#ifndef ETCH_LEAF_GOURAUD_PIXELS_H
#define ETCH_LEAF_GOURAUD_PIXELS_H

#include "gouraud_planes.h"

/* A value in four columns, for each channel. */
struct gouraud_vector {
    vector_u32 r, g, b;
};

/* Eight pixels as they are stored. */
typedef vector_u16 gouraud_join(vector_u16 rgb565);

ETCH_INLINE vector_u16 gouraud_plain(vector_u16 rgb565)
{
    return rgb565;
}

ETCH_INLINE vector_u16 gouraud_swapped(vector_u16 rgb565)
{
    return rgb565 << 8 | rgb565 >> 8;
}

/* Four pixels in the upper halves; what is below them is left of fractions. */
ETCH_INLINE vector_u32 gouraud_upper(const struct gouraud_vector *c)
{
    return (c->r & vector_all(UINT32_C(31) << 27)) | (c->g >> 5 & vector_all(UINT32_C(63) << 21)) |
           c->b >> 11;
}

ETCH_INLINE void gouraud_step(struct gouraud_vector *c, const struct gouraud_vector *by)
{
    c->r += by->r, c->g += by->g, c->b += by->b;
}

/* What lanes z, r, g, b give in all four columns. */
ETCH_INLINE struct gouraud_vector gouraud_spread(vector_u32 v)
{
    return (struct gouraud_vector){__builtin_shufflevector(v, v, 1, 1, 1, 1),
                                   __builtin_shufflevector(v, v, 2, 2, 2, 2),
                                   __builtin_shufflevector(v, v, 3, 3, 3, 3)};
}

/* Steps from the first of four columns to each. */
ETCH_INLINE struct gouraud_vector gouraud_ramp(vector_u32 dx)
{
    const vector_u32 none = {0, 0, 0, 0}, twice = dx + dx, thrice = twice + dx;
    const vector_u32 zr = __builtin_shufflevector(none, dx, 0, 4, 1, 5);
    const vector_u32 zr2 = __builtin_shufflevector(twice, thrice, 0, 4, 1, 5);
    const vector_u32 gb = __builtin_shufflevector(none, dx, 2, 6, 3, 7);
    const vector_u32 gb2 = __builtin_shufflevector(twice, thrice, 2, 6, 3, 7);

    return (struct gouraud_vector){__builtin_shufflevector(zr, zr2, 2, 3, 6, 7),
                                   __builtin_shufflevector(gb, gb2, 0, 1, 4, 5),
                                   __builtin_shufflevector(gb, gb2, 2, 3, 6, 7)};
}

/* n >= 1 pixels from `pixel` on; c stands at the first four. */
ETCH_INLINE void gouraud_walk(uint16_t *pixel, uint32_t n, struct gouraud_vector c,
                              const struct gouraud_vector *by4, gouraud_join *join)
{
    while (n > 8) {
        const vector_u32 four = gouraud_upper(&c);

        gouraud_step(&c, by4);
        vector_store(pixel, join(vector_upper(four, gouraud_upper(&c))));
        gouraud_step(&c, by4);
        pixel += 8, n -= 8;
    }
    vector_u32 four = gouraud_upper(&c);

    if (n > 4) {
        const vector_u16 eight = join(vector_upper(four, four));

        *(four_pixels *)pixel = ((vector_u64)eight)[0];
        gouraud_step(&c, by4);
        four = gouraud_upper(&c);
        pixel += 4, n -= 4;
    }
    vector_store_few(pixel, join(vector_upper(four, four)), n);
}

#endif
