/* vertex/transform.c: position to clip space. Called by the vertex functions of draw/mesh, once
 * a vertex. See transform.h. */
#include "transform.h"

static uint64_t magnitude(etch_q16 v)
{
    return v < 0 ? (uint64_t) - (int64_t)v : (uint64_t)v;
}

/* True if no partial sum of the row, with the rounding, reaches 2^31. */
static bool is_narrow(const etch_q16 row[4], uint8_t bits, uint16_t extent)
{
    const uint64_t products = (magnitude(row[0]) + magnitude(row[1]) + magnitude(row[2])) * extent;

    return products + ((magnitude(row[3]) + 1) << bits) < UINT64_C(1) << 31;
}

void etch_transform_init(struct etch_transform *t, const struct etch_matrix *matrix, uint8_t bits,
                         uint16_t extent)
{
    t->matrix = *matrix;
    t->bits = bits < 15 ? bits : 15;
    t->narrow = true;
    for (int row = 0; row < 4; row++)
        t->narrow = t->narrow && is_narrow(matrix->m[row], t->bits, extent);
}

/* Modular, so that a position beyond the promised extent is wrong but defined. */
static etch_q16 narrow_row(const etch_q16 row[4], const int16_t p[3], uint8_t bits)
{
    const uint32_t half = (UINT32_C(1) << bits) >> 1;
    uint32_t sum = etch_wrap_mul((uint32_t)row[3], UINT32_C(1) << bits) + half;

    sum = etch_wrap_add(sum, etch_wrap_mul((uint32_t)row[0], (uint32_t)(int32_t)p[0]));
    sum = etch_wrap_add(sum, etch_wrap_mul((uint32_t)row[1], (uint32_t)(int32_t)p[1]));
    sum = etch_wrap_add(sum, etch_wrap_mul((uint32_t)row[2], (uint32_t)(int32_t)p[2]));
    return (int32_t)sum >> bits;
}

/* |sum| < 3 * 2^46 + 2^46. */
static etch_q16 wide_row(const etch_q16 row[4], const int16_t p[3], uint8_t bits)
{
    int64_t sum = row[3] * (INT64_C(1) << bits) + (INT64_C(1) << bits) / 2;

    sum += etch_mul_s32(row[0], p[0]) + etch_mul_s32(row[1], p[1]) + etch_mul_s32(row[2], p[2]);
    return etch_saturate_s32(sum >> bits);
}

void etch_transform_position(const struct etch_transform *t, const int16_t p[3],
                             struct etch_clip_vertex *out)
{
    const etch_q16(*const m)[4] = t->matrix.m;
    const uint8_t bits = t->bits;

    if (t->narrow) {
        out->x = narrow_row(m[0], p, bits);
        out->y = narrow_row(m[1], p, bits);
        out->z = narrow_row(m[2], p, bits);
        out->w = narrow_row(m[3], p, bits);
    } else {
        out->x = wide_row(m[0], p, bits);
        out->y = wide_row(m[1], p, bits);
        out->z = wide_row(m[2], p, bits);
        out->w = wide_row(m[3], p, bits);
    }
}
