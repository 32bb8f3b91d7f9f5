/* vertex/rotate_small.c: rotation in few bytes. Called by the application. See rotate_small.h. */
#include "rotate_small.h"

/* Of a quarter turn, x = 0 .. 1: sin = x (a - x^2 (b - x^2 c)) with a = pi / 2, b = pi - 5/2 and
 * c = pi/2 - 3/2, which has the sine's value and slope at both ends. */
static etch_q16 sine(uint16_t angle)
{
    const uint32_t folded = (angle & 0x4000) != 0 ? 0x4000 - (angle & 0x3FFFu) : angle & 0x3FFFu;
    const uint32_t square_q14 = folded * folded >> 14;
    const uint32_t inner_q16 = 42048 - (4640 * square_q14 >> 14);
    const etch_q16 v = (etch_q16)((102944 - (inner_q16 * square_q14 >> 14)) * folded >> 14);

    return (angle & 0x8000) != 0 ? -v : v;
}

void etch_matrix_rotate_y_small(struct etch_matrix *m, uint16_t angle)
{
    const etch_q16 sin = sine(angle), cos = sine((uint16_t)((angle + 0x4000u) & 0xFFFF));

    etch_matrix_identity(m);
    m->m[0][0] = m->m[2][2] = cos;
    m->m[0][2] = sin;
    m->m[2][0] = -sin;
}
