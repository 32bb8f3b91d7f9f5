/* raster/outline_arc.c: arcs, pies and rings as contours. Called by applications. See outline.h. */
#include "outline_parts.h"

/* From angle a, sweep on, through the angles that all arcs of the radius have in common. */
static void forwards(struct outline_pen *pen, struct etch_point_q8 c, int32_t r, uint32_t a,
                     uint32_t sweep)
{
    const uint32_t one = UINT32_C(65536) / etch_outline_chords(r), end = a + sweep;

    outline_to(pen, outline_at(c, r, r, (uint16_t)(a & 65535)));
    for (uint32_t at = (a / one + 1) * one; at < end; at += one)
        outline_to(pen, outline_at(c, r, r, (uint16_t)(at & 65535)));
    outline_to(pen, outline_at(c, r, r, (uint16_t)(end & 65535)));
}

static void backwards(struct outline_pen *pen, struct etch_point_q8 c, int32_t r, uint32_t a,
                      uint32_t sweep)
{
    const uint32_t one = UINT32_C(65536) / etch_outline_chords(r), end = a + sweep;

    outline_to(pen, outline_at(c, r, r, (uint16_t)(end & 65535)));
    for (uint32_t at = (end - 1) / one * one; at > a; at -= one)
        outline_to(pen, outline_at(c, r, r, (uint16_t)(at & 65535)));
    outline_to(pen, outline_at(c, r, r, (uint16_t)(a & 65535)));
}

void etch_outline_arc(const struct etch_outline *o, struct etch_point_q8 centre, int32_t outer,
                      int32_t inner, uint16_t from, uint32_t sweep)
{
    struct outline_pen pen = {o, {0, 0}, {0, 0}, false};

    if (inner < 0)
        inner = 0;
    if (outer <= inner || sweep == 0)
        return;
    if (sweep >= 65536) {
        etch_outline_ellipse(o, centre, outer, outer, false);
        if (inner > 0)
            etch_outline_ellipse(o, centre, inner, inner, true);
        return;
    }
    forwards(&pen, centre, outer, from, sweep);
    if (inner > 0)
        backwards(&pen, centre, inner, from, sweep);
    else
        outline_to(&pen, centre);
    outline_close(&pen);
}
