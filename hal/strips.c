/* hal/strips.c: areas of a frame cut into strips. frame.c and workers.c call it. See strips.h. */
#include "strips.h"

int16_t etch_strips_rows(const struct etch_display *display, uint32_t size, uint16_t stride)
{
    const uint32_t rows = size / stride;
    const uint8_t align = display->align_y > 1 ? display->align_y : 1;
    const int16_t height = display->height;

    return rows < (uint32_t)height ? (int16_t)(rows / align * align) : height;
}

/* v >= 0 down to a multiple of align; 0 and 1: any. */
static int16_t align_down(int16_t v, uint8_t align)
{
    return align > 1 ? (int16_t)(v / align * align) : v;
}

/* v > 0 up to a multiple of align, but not above the frame's border. */
static int16_t align_up(int16_t v, uint8_t align, int16_t border)
{
    const int16_t down = align_down((int16_t)(v - 1), align);

    return align <= 1 ? v : border - down > align ? (int16_t)(down + align) : border;
}

/* The part of an area that is inside the frame, with borders that the display takes. */
static struct etch_rect fit_area(const struct etch_display *d, struct etch_rect area)
{
    const struct etch_rect frame = {0, 0, d->width, d->height};
    struct etch_rect fit = etch_rect_intersect(area, frame);

    if (!etch_rect_is_empty(fit)) {
        fit.x0 = align_down(fit.x0, d->align_x);
        fit.y0 = align_down(fit.y0, d->align_y);
        fit.x1 = align_up(fit.x1, d->align_x, d->width);
        fit.y1 = align_up(fit.y1, d->align_y, d->height);
    }
    return fit;
}

void etch_strips_begin(struct etch_strips *strips, const struct etch_rect *areas, uint16_t count,
                       int16_t rows)
{
    strips->area = (struct etch_rect){0, 0, 0, 0};
    strips->areas = areas;
    strips->left = count;
    strips->rows = rows;
}

bool etch_strips_next(struct etch_strips *strips, const struct etch_display *display, uint32_t size,
                      uint16_t stride, struct etch_rect *window)
{
    struct etch_rect *const area = &strips->area;
    int16_t rows;

    while (etch_rect_is_empty(*area) && strips->left > 0) {
        *area = fit_area(display, *strips->areas++);
        strips->left--;
    }
    if (etch_rect_is_empty(*area)) {
        return false;
    }
    rows = etch_strips_rows(display, size, stride != 0 ? stride : (uint16_t)(area->x1 - area->x0));
    rows = rows < strips->rows ? rows : strips->rows;
    *window = *area;
    if (area->y1 - area->y0 > rows) {
        window->y1 = (int16_t)(area->y0 + rows);
    }
    area->y0 = window->y1;
    return true;
}
