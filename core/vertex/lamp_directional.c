/* vertex/lamp_directional.c: lamps far away. Aimed by the application, read by the shade functions.
 * See lamp.h. */
#include "lamp.h"
#include "vector.h"

void etch_lamp_directional(const struct etch_lamp *lamp, const etch_q16 position[3],
                           struct etch_incidence *out)
{
    (void)position;
    out->towards[0] = (int16_t)lamp->place.x;
    out->towards[1] = (int16_t)lamp->place.y;
    out->towards[2] = (int16_t)lamp->place.z;
    out->intensity_q16 = ETCH_Q16_ONE;
}

enum etch_status etch_lamp_aim(struct etch_lamp *lamp, const struct etch_vector *towards)
{
    const int64_t v[3] = {towards->x, towards->y, towards->z};
    int32_t unit[3];

    if (etch_vector_unit_q30(unit, v) != ETCH_OK)
        return ETCH_EINVAL;
    lamp->kind = etch_lamp_directional;
    lamp->place.x = (unit[0] + 32768) >> 16;
    lamp->place.y = (unit[1] + 32768) >> 16;
    lamp->place.z = (unit[2] + 32768) >> 16;
    return ETCH_OK;
}
