/* proved: the sine (base/trig.c) of every angle is computed without overflow
 * assumed: nothing */
#include "prove.h"
#include "core/base/trig.c"

void prove(void)
{
    const int32_t sine = etch_sin_q30((uint16_t)any(0, 65535));

    /*@ check -0x6487ED52 <= sine <= 0x6487ED52; */
}
