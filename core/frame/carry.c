/* frame/carry.c: rows that are kept from strip to strip. Called by applications before, and by
 * filters after they have read a strip. See carry.h. */
#include "carry.h"

enum etch_status etch_carry_init(struct etch_carry *c, uint16_t *kept, struct etch_rect frame,
                                 uint8_t rows, uint8_t columns)
{
    ETCH_ASSERT(c != NULL && ((uintptr_t)kept & 1) == 0);
    if (kept == NULL || rows == 0 || etch_rect_is_empty(frame) || frame.x0 < 0 || frame.y0 < 0)
        return ETCH_EINVAL;
    c->kept = kept;
    c->frame = frame;
    c->rows = rows;
    c->columns = columns;
    c->source = (struct etch_rect){0, 0, 0, 0};
    return ETCH_OK;
}

/* `r` and what the pass looks at about it, inside the frame. */
static struct etch_rect grown(const struct etch_carry *c, struct etch_rect r)
{
    const int32_t x1 = (int32_t)r.x1 + c->columns, y1 = (int32_t)r.y1 + c->rows;
    const struct etch_rect more = {(int16_t)(r.x0 - c->columns), (int16_t)(r.y0 - c->rows),
                                   x1 < c->frame.x1 ? (int16_t)x1 : c->frame.x1,
                                   y1 < c->frame.y1 ? (int16_t)y1 : c->frame.y1};

    return etch_rect_intersect(more, c->frame);
}

/* The first row at hand. */
static int32_t first_kept(const struct etch_carry *c)
{
    const int32_t first = c->source.y1 - 2 * c->rows;

    return first > c->source.y0 ? first : c->source.y0;
}

bool etch_carry_begin(struct etch_carry *c, const struct etch_surface *strip,
                      struct etch_surface *source)
{
    const struct etch_rect need = grown(c, strip->window);

    if (etch_rect_is_empty(need)) { /* a strip outside the frame */
        c->source = (struct etch_rect){0, 0, 0, 0};
        source->window = source->clip = c->source;
        return false;
    }
    const bool continues = need.x0 == c->source.x0 && need.x1 == c->source.x1 &&
                           need.y0 >= first_kept(c) && need.y0 <= c->source.y1 &&
                           need.y1 >= c->source.y1;

    if (!continues)
        c->source = (struct etch_rect){need.x0, need.y0, need.x1, need.y0};
    source->window = (struct etch_rect){need.x0, c->source.y1, need.x1, need.y1};
    source->clip = source->window;
    source->stride = (uint16_t)(need.x1 - need.x0);
    c->source.y1 = need.y1;
    return !etch_rect_is_empty(source->window);
}

/* Where row y is kept. */
static uint16_t *slot(const struct etch_carry *c, int32_t y)
{
    const size_t width = (size_t)(c->frame.x1 - c->frame.x0);

    return c->kept + (size_t)(y % (2 * c->rows)) * width;
}

const uint16_t *etch_carry_row(const struct etch_carry *c, const struct etch_surface *source,
                               int32_t y)
{
    if (y < c->frame.y0)
        y = c->frame.y0;
    if (y >= c->frame.y1)
        y = c->frame.y1 - 1;
    if (y < source->window.y0)
        return slot(c, y);
    return source->pixels + (size_t)(y - source->window.y0) * source->stride;
}

void etch_carry_end(struct etch_carry *c, const struct etch_surface *source)
{
    const int32_t last = source->window.y1 - 2 * c->rows;
    const int32_t first = last > source->window.y0 ? last : source->window.y0;

    for (int32_t y = first; y < source->window.y1; y++) {
        const uint16_t *from = etch_carry_row(c, source, y);
        uint16_t *to = slot(c, y);

        for (uint16_t i = source->stride; i != 0; i--)
            *to++ = *from++;
    }
}
