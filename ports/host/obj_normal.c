/* ports/host/obj_normal.c: normals of OBJ files to int8 of length 127. obj_mesh.c calls it. */
#include "obj_parts.h"

static int64_t magnitude(int64_t v)
{
    return v < 0 ? -v : v;
}

/* floor(sqrt(v)), a bit a step. */
static uint32_t root(uint64_t v)
{
    uint64_t r = 0;

    for (uint64_t bit = UINT64_C(1) << 31; bit != 0; bit >>= 1) {
        if ((r | bit) * (r | bit) <= v) {
            r |= bit;
        }
    }
    return (uint32_t)r;
}

void obj_normalise(const int64_t n[3], int8_t out[3])
{
    int64_t v[3] = {n[0], n[1], n[2]};
    int64_t most = 0, length;

    for (int i = 0; i < 3; i++) {
        most = magnitude(v[i]) > most ? magnitude(v[i]) : most;
    }
    /* to 2^28 .. 2^29: then the squares' sum fits, and the root is right to 28 bits */
    for (; most > INT64_C(1) << 29; most /= 2) {
        v[0] /= 2, v[1] /= 2, v[2] /= 2;
    }
    for (; most != 0 && most < INT64_C(1) << 28; most *= 2) {
        v[0] *= 2, v[1] *= 2, v[2] *= 2;
    }
    length = root((uint64_t)(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
    for (int i = 0; i < 3; i++) {
        const int64_t twice = length != 0 ? magnitude(v[i]) * 254 / length : 0;

        out[i] = (int8_t)(v[i] < 0 ? -((twice + 1) / 2) : (twice + 1) / 2);
    }
}

void obj_written_normal(const struct obj_vector *vn, int64_t n[3])
{
    struct obj_vector moved = *vn;
    int32_t point = INT32_MIN, value = 0;

    for (int i = 0; i < 3; i++) {
        point = vn->c[i].count != 0 && vn->c[i].point > point ? vn->c[i].point : point;
    }
    for (int i = 0; i < 3; i++) {
        moved.c[i].point -= moved.c[i].count != 0 ? point : 0;
        (void)etch_decimal_scale(&moved.c[i], 30, &value);
        n[i] = value;
    }
}
