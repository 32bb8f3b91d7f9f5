/* fragment/fog.h: stages that fade colour into that of fog, by the depth z of the chunk (stage.h).
 *
 *      colour = f colour + (1 - f) fog,      f = 1 near .. 0 far
 *
 * Depth is the value of the depth plane, 0 .. 65535, which in perspective grows faster near the eye
 * than far from it. Alpha stays. The result errs by less than a unit of the chunk's formats beyond
 * what f errs by; f = 1 leaves a colour, f = 0 makes it the fog's, exactly.
 */
#ifndef ETCH_FRAGMENT_FOG_H
#define ETCH_FRAGMENT_FOG_H

#include "stage.h"

/* f = (end - z) / (end - start), held to 0 .. 1; it errs by less than 2^-14. */
struct etch_fog_linear {
    uint16_t color[3]; /* red, green, blue in the formats of a chunk */
    uint16_t start, end;
    uint32_t slope; /* 2^31 / (end - start) */
};

/* f = exp(-density z / 65535); it errs by less than 2^-13. */
struct etch_fog_exponential {
    uint16_t color[3];
    uint32_t rate; /* of the exponent to base 2, see fog_exponential.c */
};

/* Fill in all members; r, g, b are 0 .. 255. ETCH_EINVAL unless start < end, or if the density,
 * 16.16, is negative; *fog is then left as it was. */
enum etch_status etch_fog_linear_init(struct etch_fog_linear *fog, uint16_t start, uint16_t end,
                                      uint8_t r, uint8_t g, uint8_t b);
enum etch_status etch_fog_exponential_init(struct etch_fog_exponential *fog, etch_q16 density,
                                           uint8_t r, uint8_t g, uint8_t b);

etch_stage_function etch_stage_fog_linear;      /* data: const struct etch_fog_linear */
etch_stage_function etch_stage_fog_exponential; /* data: const struct etch_fog_exponential */

#endif
