/* draw/text_clip.h: the part of a glyph's bitmap inside the clip; no part of the API. */
#ifndef ETCH_DRAW_TEXT_CLIP_H
#define ETCH_DRAW_TEXT_CLIP_H

#include "text.h"

/* Columns and rows of the frame, half-open. */
struct etch_glyph_part {
    int32_t x0, y0, x1, y1;
};

/* False if there is none. The sums stay in 32 bits: pens end at 2^30. */
ETCH_INLINE bool etch_glyph_clip(struct etch_glyph_part *p, const struct etch_surface *s,
                                 const struct etch_glyph_box *box)
{
    const int32_t right = box->x + box->width, below = box->y + box->height;

    p->x0 = box->x > s->clip.x0 ? box->x : s->clip.x0;
    p->x1 = right < s->clip.x1 ? right : s->clip.x1;
    p->y0 = box->y > s->clip.y0 ? box->y : s->clip.y0;
    p->y1 = below < s->clip.y1 ? below : s->clip.y1;
    return p->x0 < p->x1 && p->y0 < p->y1;
}

#endif
