/* raster/round_rect.c: rounded rectangles to runs. Called by draw/ and applications. See
 * round_rect.h. */
#include "round_rect.h"
#include "stretched.h"

void etch_round_rect_runs(const struct etch_surface *s, int16_t x, int16_t y, int16_t w, int16_t h,
                          int16_t r, const struct etch_paint *paint)
{
    struct etch_stretched p;
    const int32_t radius = etch_stretched_box(&p, x, y, w, h, r);

    if (radius >= 0 && etch_stretched_init(&p, s, radius, radius))
        etch_stretched_fill(s, &p, paint);
}

void etch_round_rect_outline_runs(const struct etch_surface *s, int16_t x, int16_t y, int16_t w,
                                  int16_t h, int16_t r, const struct etch_paint *paint)
{
    struct etch_stretched p;
    const int32_t radius = etch_stretched_box(&p, x, y, w, h, r);

    if (radius >= 0 && etch_stretched_init(&p, s, radius, radius))
        etch_stretched_outline(s, &p, paint);
}
