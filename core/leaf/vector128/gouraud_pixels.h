/* leaf/vector128/gouraud_pixels.h: interpolated colour, eight pixels at a time; no part of the API.
 * The planes are those of fragment/gouraud_rows.h, four columns to a vector: sums modulo 2^32 do not
 * depend on their order, so every pixel has the portable one's value. */
#ifndef ETCH_LEAF_GOURAUD_PIXELS_H
#define ETCH_LEAF_GOURAUD_PIXELS_H

#include "../../fragment/gouraud.h"
#include "vector.h"

/* Where the planes stand in four columns, and their steps by four. */
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

/* The steps of the planes, from a column to the fourth after it. */
ETCH_INLINE struct gouraud_vector gouraud_steps(const struct etch_gouraud_paint *p)
{
    return (struct gouraud_vector){vector_all(p->r.dx) << 2, vector_all(p->g.dx) << 2,
                                   vector_all(p->b.dx) << 2};
}

/* n pixels from `pixel` on; c stands at the first four. */
ETCH_INLINE void gouraud_walk(uint16_t *pixel, uint32_t n, struct gouraud_vector c,
                              const struct gouraud_vector *by4, gouraud_join *join)
{
    for (;;) {
        const vector_u32 four = gouraud_upper(&c);

        gouraud_step(&c, by4);
        const vector_u16 eight = join(vector_upper(four, gouraud_upper(&c)));

        if (n <= 8) {
            vector_store_first(pixel, eight, n);
            return;
        }
        vector_store(pixel, eight);
        gouraud_step(&c, by4);
        pixel += 8, n -= 8;
    }
}

#endif
