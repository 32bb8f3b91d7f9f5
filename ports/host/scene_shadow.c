/* ports/host/scene_shadow.c: the matrix of `model shadow`. scene_view.c calls it. */
#include "scene_steps.h"

/* A product of two numbers of 16.16, rounded, of up to 47 bits. */
static int64_t product(etch_q16 a, etch_q16 b)
{
    return ((int64_t)a * b + ETCH_Q16_ONE / 2) >> 16;
}

/* Numerator / divisor as 16.16, half up; false if it does not fit. Products reach 2^46, so what is
 * refused here without a division is no entry of 16.16 unless the divisor is beyond 2^28. */
static bool divide(etch_q16 *out, int64_t numerator, int64_t divisor)
{
    const int64_t limit = INT64_C(1) << 44;
    const int64_t sign = divisor < 0 ? -1 : 1;

    if (numerator < -limit || numerator > limit) {
        return false;
    }
    const int64_t twice = numerator * sign * 2 * ETCH_Q16_ONE + divisor * sign;
    const int64_t by = divisor * sign * 2;
    const int64_t value = twice / by - (twice % by < 0);

    *out = value >= INT32_MIN && value <= INT32_MAX ? (etch_q16)value : 0;
    return value >= INT32_MIN && value <= INT32_MAX;
}

/* With the lamp L (x, y, z, 1, or 0 if it is far away) and the plane P (a x + b y + c z + d = 0),
 * the point where the ray from L through a vertex V meets the plane is (P . L) V - (P . V) L.
 * Divided by P . L, so that w stays 1 on the plane. Source: J. Blinn, "Me and my (fake) shadow",
 * 1988. */
static bool project(struct etch_matrix *m, const etch_q16 lamp[4], const etch_q16 plane[4])
{
    int64_t dot = 0;
    bool fits = true;

    for (int i = 0; i < 4; i++) {
        dot += product(plane[i], lamp[i]);
    }
    for (int i = 0; dot != 0 && i < 4; i++) {
        for (int k = 0; k < 4; k++) {
            fits &= divide(&m->m[i][k], (i == k ? dot : 0) - product(lamp[i], plane[k]), dot);
        }
    }
    return dot != 0 && fits;
}

/* [point] x y z, as of light, then a b c d */
bool etch_scene_read_shadow(struct etch_scene_reader *reader, struct etch_matrix *m)
{
    static const char *const names[] = {"x", "y", "z", "a", "b", "c", "d"};
    etch_q16 v[7];
    const etch_q16 w = etch_scene_take(reader, "point") ? ETCH_Q16_ONE : 0;

    for (int i = 0; i < 7; i++) {
        if (!etch_text_q16(&reader->text, names[i], &v[i])) {
            return false;
        }
    }
    const etch_q16 lamp[4] = {v[0], v[1], v[2], w};

    return project(m, lamp, v + 3) ||
           etch_text_fail(&reader->text, "the lamp throws no shadow on that plane");
}
