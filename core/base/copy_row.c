/* base/copy_row.c: a row of pixels as they are. Called by copies, scrolls and blits. See copy.h. */
#include "copy.h"
#include "fill.h"

void etch_copy_row(uint16_t *to, const uint16_t *from, uint32_t n)
{
    if (n >= 8 && (((uintptr_t)to ^ (uintptr_t)from) & 2) == 0) {
        if (((uintptr_t)to & 2) != 0)
            *to++ = *from++, n--;

        etch_pair *q = (etch_pair *)(void *)to;
        const etch_pair *p = (const etch_pair *)(const void *)from;

        for (; n >= 16; n -= 16, q += 8, p += 8) {
            q[0] = p[0], q[1] = p[1], q[2] = p[2], q[3] = p[3];
            q[4] = p[4], q[5] = p[5], q[6] = p[6], q[7] = p[7];
        }
        for (; n >= 2; n -= 2)
            *q++ = *p++;
        to = (uint16_t *)(void *)q, from = (const uint16_t *)(const void *)p;
    }
    for (; n >= 8; n -= 8, to += 8, from += 8) {
        to[0] = from[0], to[1] = from[1], to[2] = from[2], to[3] = from[3];
        to[4] = from[4], to[5] = from[5], to[6] = from[6], to[7] = from[7];
    }
    for (; n != 0; n--)
        *to++ = *from++;
}
