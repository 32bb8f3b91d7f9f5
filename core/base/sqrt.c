/* base/sqrt.c: integer square root for circles, normals and distances. See fixed.h. */
#include "fixed.h"

uint16_t etch_sqrt_u32(uint32_t v)
{
    uint32_t root = 0;

    /* Invariant: root holds the bits above `bit` of the result, shifted to their weight. Half of
     * the steps are idle where v has 16 bits. */
    for (uint32_t bit = v >> 16 != 0 ? UINT32_C(1) << 30 : UINT32_C(1) << 14; bit != 0; bit >>= 2) {
        if (v >= root + bit) {
            v -= root + bit;
            root = (root >> 1) + bit;
        } else {
            root >>= 1;
        }
    }
    return (uint16_t)root;
}
