/* raster/outline_ellipse.c: circles and ellipses as contours. Called by applications. See
 * outline.h. */
#include "outline_parts.h"

void etch_outline_ellipse(const struct etch_outline *o, struct etch_point_q8 centre, int32_t rx,
                          int32_t ry, bool hole)
{
    const uint32_t n = etch_outline_chords(rx > ry ? rx : ry);
    struct outline_pen pen = {o, {0, 0}, {0, 0}, false};

    if (rx < 0 || ry < 0)
        return;
    for (uint32_t i = 0; i < n; i++)
        outline_to(
            &pen, outline_at(centre, rx, ry, (uint16_t)((hole ? n - i : i) * (65536 / n) & 65535)));
    outline_close(&pen);
}
