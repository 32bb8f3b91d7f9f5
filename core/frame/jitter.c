/* frame/jitter.c: the offsets of 2 to 16 samples. Read by applications that accumulate and by
 * multisample_setup.c. See jitter.h. */
#include "jitter.h"

const struct etch_offset_q8 etch_jitter_2[2] = {{-64, 64}, {64, -64}};
const struct etch_offset_q8 etch_jitter_4[4] = {{-96, -32}, {-32, 96}, {32, -96}, {96, 32}};
const struct etch_offset_q8 etch_jitter_8[8] = {{-112, -80}, {-80, -16}, {-48, 48}, {-16, 112},
                                                {16, -112},  {48, -48},  {80, 16},  {112, 80}};
const struct etch_offset_q8 etch_jitter_16[16] = {
    {-120, -72}, {-104, -8}, {-88, 56}, {-72, 120}, {-56, -88}, {-40, -24}, {-24, 40}, {-8, 104},
    {8, -104},   {24, -40},  {40, 24},  {56, 88},   {72, -120}, {88, -56},  {104, 8},  {120, 72}};
