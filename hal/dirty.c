/* hal/dirty.c: dirty rectangles, kept few and apart. The application calls it between frames. See
 * dirty.h. */
#include "dirty.h"

static struct etch_rect join(struct etch_rect a, struct etch_rect b)
{
    const struct etch_rect r = {
        a.x0 < b.x0 ? a.x0 : b.x0,
        a.y0 < b.y0 ? a.y0 : b.y0,
        a.x1 > b.x1 ? a.x1 : b.x1,
        a.y1 > b.y1 ? a.y1 : b.y1,
    };
    return r;
}

/* Sides are at most 65535, so pixels fit 32 bits. */
static uint32_t pixels_of(struct etch_rect r)
{
    return (uint32_t)((int32_t)r.x1 - r.x0) * (uint32_t)((int32_t)r.y1 - r.y0);
}

/* Pixels that the union has and neither of the two; 0 if they overlap by more than it. */
static uint32_t waste_of(struct etch_rect a, struct etch_rect b)
{
    const uint32_t joined = pixels_of(join(a, b));
    const uint32_t first = pixels_of(a), second = pixels_of(b);

    return joined - first > second ? joined - first - second : 0;
}

static struct etch_rect take(struct etch_dirty *dirty, uint8_t i)
{
    const struct etch_rect area = dirty->area[i];

    dirty->area[i] = dirty->area[--dirty->count];
    return area;
}

/* The area that must or should be one with `area`: they overlap, or the union costs less than a
 * transaction. `count` if there is none. */
static uint8_t find_partner(const struct etch_dirty *dirty, struct etch_rect area)
{
    const uint32_t slack = dirty->slack != 0 ? dirty->slack : 32;
    uint8_t i = 0;

    while (i < dirty->count && etch_rect_is_empty(etch_rect_intersect(dirty->area[i], area)) &&
           waste_of(dirty->area[i], area) > slack) {
        i++;
    }
    return i;
}

/* The area whose union with `area` wastes least; there is one. */
static uint8_t find_cheapest(const struct etch_dirty *dirty, struct etch_rect area)
{
    uint8_t best = 0;

    for (uint8_t i = 1; i < dirty->count; i++) {
        if (waste_of(dirty->area[i], area) < waste_of(dirty->area[best], area)) {
            best = i;
        }
    }
    return best;
}

void etch_dirty_add(struct etch_dirty *dirty, struct etch_rect area)
{
    ETCH_ASSERT(dirty != NULL && dirty->count <= ETCH_DIRTY_MOST);
    if (etch_rect_is_empty(area)) {
        return;
    }
    /* A union may reach others: each turn takes one area away, so it ends. */
    for (;;) {
        uint8_t i = find_partner(dirty, area);

        if (i == dirty->count) {
            if (dirty->count < ETCH_DIRTY_MOST) {
                break;
            }
            i = find_cheapest(dirty, area);
        }
        area = join(area, take(dirty, i));
    }
    dirty->area[dirty->count++] = area;
}
