/* draw/setup_small.c: positions and colour planes of a triangle in few bytes. Called by the small
 * painters. See setup_small.h.
 *
 * A channel c becomes c 31 2^27 / 255 or c 63 2^26 / 255 with the factor rounded up, by less than
 * 2^-29 of itself, and the 1/2 that rounds: at most 7 units of 2^-27 above raster/channel.c. */
#include "../fragment/gouraud.h"
#include "setup_small.h"

bool etch_setup_small(struct etch_gouraud_paint *paint, struct etch_point_q8 p[3],
                      const struct etch_vertex *const v[3])
{
    uint8_t *plane = (uint8_t *)paint + offsetof(struct etch_gouraud_paint, r); /* then g, b */

    for (uint8_t channel = 0; channel < 3; channel++, plane += sizeof(struct etch_plane)) {
        const bool green = channel == 1;
        const uint32_t factor = green ? 16579837 : 16316665;
        const uint32_t half = green ? UINT32_C(1) << 25 : UINT32_C(1) << 26;
        uint32_t value[3];

        for (uint8_t i = 0; i < 3; i++) {
            const uint8_t *const rgb = (const uint8_t *)v[i] + offsetof(struct etch_vertex, r);

            value[i] = rgb[channel] * factor + half;
            p[i].x = v[i]->x_q8;
            p[i].y = v[i]->y_q8;
        }
        if (!etch_plane_setup_small((struct etch_plane *)(void *)plane, p, value))
            return false;
    }
    return true;
}
