/* vertex/lamp_point.c: lamps at a place. Called by the shade functions. See lamp.h. */
#include "lamp_sum.h"

void etch_lamp_point(const struct etch_lamp *lamp, const etch_q16 position[3],
                     struct etch_incidence *out)
{
    int32_t away[3];

    lamp_away(away, &lamp->place, position);
    (void)etch_unit_q14(out->towards, away);
    out->intensity_q16 = ETCH_Q16_ONE;
}
