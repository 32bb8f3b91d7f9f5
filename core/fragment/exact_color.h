/* fragment/exact_color.h: the loop of exact colours; no part of the API. See exact.h.
 *
 * The planes of gouraud.h are within 2^-10 (1 + 2^-4) of a step of the true value where they come
 * from raster/basis.h, and within 2^-11 where they come from raster/plane.h. They walk here with
 * 2^-9 more, so the true value lies between the plane less 2^-8 and the plane: another integer is
 * there only if the upper 8 bits of the fraction are all 0.
 */
#ifndef ETCH_FRAGMENT_EXACT_COLOR_H
#define ETCH_FRAGMENT_EXACT_COLOR_H

#include "exact.h"
#include "gouraud_rows.h"

#define EXACT_MARGIN_Q27 (UINT32_C(1) << 18)
#define EXACT_MARGIN_Q26 (UINT32_C(1) << 17)

/* v has its integer part above a fraction of `bits`. */
ETCH_INLINE bool exact_is_close(uint32_t v, uint8_t bits)
{
    return etch_wrap_mul(v, UINT32_C(1) << (32 - bits)) < UINT32_C(1) << 24;
}

/* The channel at (x, y): k or, if the true value is below k, one less. */
static uint32_t exact_settle(const struct etch_exact_plane *n, uint64_t area, uint32_t k, int16_t x,
                             int16_t y)
{
    return k - (etch_exact_above(n, x, y, area * (510 * k)) < 0 ? 1 : 0);
}

static ETCH_COLD uint16_t exact_pixel(const struct etch_gouraud_exact_paint *p, int16_t x,
                                      int16_t y, struct gouraud_cursor c)
{
    const uint64_t area = p->depth.area;
    uint32_t r = c.r >> 27, g = c.g >> 26, b = c.b >> 27;

    if (exact_is_close(c.r, 27))
        r = exact_settle(&p->r, area, r, x, y);
    if (exact_is_close(c.g, 26))
        g = exact_settle(&p->g, area, g, x, y);
    if (exact_is_close(c.b, 27))
        b = exact_settle(&p->b, area, b, x, y);
    return (uint16_t)((r << 6 | g) << 5 | b);
}

ETCH_INLINE void exact_span(uint16_t *pixel, int32_t x, uint32_t n, int32_t y,
                            const struct etch_gouraud_exact_paint *p, const bool swapped)
{
    const struct etch_gouraud_paint *const planes = &p->gouraud;
    const uint32_t dr = planes->r.dx, dg = planes->g.dx, db = planes->b.dx;
    uint16_t *const end = pixel + n;
    uint32_t r = etch_wrap_add(etch_plane_at(&planes->r, (int16_t)x, (int16_t)y), EXACT_MARGIN_Q27);
    uint32_t g = etch_wrap_add(etch_plane_at(&planes->g, (int16_t)x, (int16_t)y), EXACT_MARGIN_Q26);
    uint32_t b = etch_wrap_add(etch_plane_at(&planes->b, (int16_t)x, (int16_t)y), EXACT_MARGIN_Q27);

    for (; pixel != end; pixel++) {
        uint16_t color = gouraud_pack(r, g, b);

        if (exact_is_close(r, 27) || exact_is_close(g, 26) || exact_is_close(b, 27))
            color = exact_pixel(p, (int16_t)(x + (int32_t)n - (end - pixel)), (int16_t)y,
                                (struct gouraud_cursor){r, g, b});
        *pixel = swapped ? etch_rgb565_swap(color) : color;
        r = etch_wrap_add(r, dr), g = etch_wrap_add(g, dg), b = etch_wrap_add(b, db);
    }
}

/* A kernel without depth: every run is one span. */
ETCH_INLINE void exact_rows(const struct etch_surface *s, int16_t y0, const struct etch_run *runs,
                            uint8_t n, const struct etch_paint *paint, etch_span *span)
{
    for (uint8_t i = 0; i < n; i++, y0++) {
        const int16_t x = runs[i].x0;

        if (x != runs[i].x1)
            span(s->pixels + etch_surface_index(s, x, y0), x, (uint32_t)(runs[i].x1 - x), y0,
                 paint);
    }
}

#endif
