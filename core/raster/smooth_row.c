/* raster/smooth_row.c: the covers of a row, from the changes that its lines made. Called by
 * smooth_walk.c and smooth_rows.c. See smooth_walk.h. */
#include "smooth_walk.h"

void etch_smooth_row_init(struct etch_smooth_row *row, const struct etch_surface *s, int16_t *cover)
{
    const int32_t columns = (int32_t)s->clip.x1 - s->clip.x0;

    for (int32_t i = 0; i <= columns; i++)
        cover[i] = 0;
    row->change = cover;
    row->left = s->clip.x0 * INT32_C(256);
    row->width = columns * 256;
    row->from = columns + 1;
    row->to = -1;
}

/* Sums the changes up, hands over what is covered and leaves the row zero. All that begins in a row
 * ends in it, at the clip's end at the latest, so the last sum is 0. */
void etch_smooth_row_end(struct etch_smooth_row *row, const struct etch_surface *s, int16_t y,
                         const struct etch_cover_paint *paint)
{
    const int32_t columns = row->width >> 8;
    int32_t sum = 0, begin = row->from;

    for (int32_t i = row->from; i <= row->to; i++) {
        sum += row->change[i];
        row->change[i] = (int16_t)sum;
        if (sum == 0 || i == columns) {
            if (begin < i)
                paint->kernel(s, (int16_t)(s->clip.x0 + begin), y, (uint16_t)(i - begin),
                              row->change + begin, paint);
            begin = i + 1;
        }
    }
    for (int32_t i = row->from; i <= row->to; i++)
        row->change[i] = 0;
    row->from = columns + 1;
    row->to = -1;
}
