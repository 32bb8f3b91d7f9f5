/* leaf/vector128/depth_rows.h: depth first, eight pixels at a time; no part of the API. See
 * fragment/depth_rows.h.
 *
 * Depths are compared as signed lanes, for which SSE2 has an instruction, with their upper bit
 * turned over. Where some of eight pass, all eight are written: the others as they were.
 */
#ifndef ETCH_LEAF_DEPTH_ROWS_H
#define ETCH_LEAF_DEPTH_ROWS_H

#include "../../fragment/depth_rows.h"
#include "vector.h"

/* Lanes of ones where depth may replace stored, both with the upper bit turned over. */
typedef vector_s16 depth_lanes(vector_s16 depth, vector_s16 stored);

ETCH_INLINE vector_s16 depth_lanes_less(vector_s16 depth, vector_s16 stored)
{
    return stored > depth;
}

ETCH_INLINE vector_s16 depth_lanes_lequal(vector_s16 depth, vector_s16 stored)
{
    return ~(depth > stored);
}

/* One row, and the span that is still open: pixels that passed and have no colour yet. */
struct depth_row {
    uint16_t *first, *open; /* depths; open is NULL if the last one failed */
    int32_t x, y;           /* of `first` */
    uintptr_t to_pixel;
    etch_span *span;
    const struct etch_paint *paint;
};

/* Colour for the open span, up to `end`. */
ETCH_INLINE void depth_close(struct depth_row *r, const uint16_t *end)
{
    r->span((uint16_t *)etch_wrap_address_add((uintptr_t)r->open, r->to_pixel),
            r->x + (int32_t)(r->open - r->first), (uint32_t)(end - r->open), r->y, r->paint);
    r->open = NULL;
}

/* Opens and closes spans where of eight depths one passes and its neighbour does not. */
ETCH_INLINE void depth_cut(struct depth_row *r, uint16_t *stored, uint32_t bits)
{
    const uint32_t before = (bits << 2 | (r->open != NULL ? 3 : 0)) & 0xFFFF;

    for (uint32_t turns = (bits ^ before) & 0x5555; turns != 0; turns &= turns - 1) {
        uint16_t *const here = stored + (__builtin_ctz(turns) >> 1);

        if (r->open != NULL)
            depth_close(r, here);
        else
            r->open = here;
    }
}

/* Depths z, z + dz, .. from r->first to end. */
ETCH_INLINE void depth_row(struct depth_row *r, const uint16_t *end, uint32_t z, uint32_t dz,
                           depth_lanes *lanes, etch_depth_test *passes)
{
    const vector_s16 turned = (vector_s16)vector_all(UINT32_C(0x80008000));
    const vector_u32 by4 = vector_all(dz) << 2;
    vector_u32 depths = vector_ramp(z ^ UINT32_C(0x80000000), dz);
    uint16_t *stored = r->first;

    for (; end - stored >= 8; stored += 8) {
        const vector_u32 right = depths + by4;
        const vector_s16 depth = (vector_s16)vector_upper(depths, right);
        const vector_s16 old = (vector_s16)vector_load(stored) ^ turned;
        const vector_s16 mask = lanes(depth, old);
        const uint32_t bits = vector_bits(mask);

        depths = right + by4;
        if (bits != 0)
            vector_store(stored, (vector_u16)(((depth ^ old) & mask) ^ old ^ turned));
        if (bits != 0 || r->open != NULL)
            depth_cut(r, stored, bits);
    }
    z = etch_wrap_add(z, etch_wrap_mul((uint32_t)(stored - r->first), dz));
    for (; stored != end; stored++, z = etch_wrap_add(z, dz)) {
        const bool pass = passes((uint16_t)(z >> 16), *stored);

        if (pass)
            *stored = (uint16_t)(z >> 16);
        if (pass && r->open == NULL)
            r->open = stored;
        else if (!pass && r->open != NULL)
            depth_close(r, stored);
    }
    if (r->open != NULL)
        depth_close(r, end);
}

ETCH_INLINE void depth_rows(const struct etch_surface *s, int16_t y0, const struct etch_run *runs,
                            uint8_t n, const struct etch_paint *paint, etch_span *span,
                            depth_lanes *lanes, etch_depth_test *passes)
{
    const struct etch_plane *const plane = &((const struct etch_depth_paint *)paint)->z;
    const struct etch_run *const last = runs + n;
    const uintptr_t stride = (uintptr_t)s->stride * 2;
    const uintptr_t to_pixel = etch_wrap_address_sub((uintptr_t)s->pixels, (uintptr_t)s->depth);
    uintptr_t row = etch_surface_row(s, s->depth, y0);
    struct depth_row r = {NULL, NULL, 0, y0, to_pixel, span, paint};

    ETCH_ASSERT(s->depth != NULL);
    for (; runs != last; runs++, r.y++, row = etch_wrap_address_add(row, stride)) {
        r.x = runs->x0;
        r.first = (uint16_t *)etch_wrap_address_add(row, (uintptr_t)runs->x0 * 2);
        depth_row(&r, r.first + (runs->x1 - runs->x0), etch_plane_at(plane, runs->x0, (int16_t)r.y),
                  plane->dx, lanes, passes);
    }
}

#endif
