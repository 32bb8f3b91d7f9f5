/* fragment/tile.c: images that repeat. A brush; see pattern.h. */
#include "pattern.h"

/* v modulo n, 0 .. n - 1. */
static uint16_t place(int32_t v, uint32_t n)
{
    const uint32_t rest = (uint32_t)(v < 0 ? -v : v) % n;

    return (uint16_t)(v < 0 && rest != 0 ? n - rest : rest);
}

static void colors(const struct etch_brush *brush, int16_t x, int16_t y, uint16_t n,
                   uint16_t *color)
{
    const struct etch_tile *const t = (const struct etch_tile *)brush;
    const uint16_t *const row = t->texels + (size_t)place((int32_t)y - t->y, t->height) * t->stride;
    uint16_t column = place((int32_t)x - t->x, t->width);

    for (const uint16_t *const end = color + n; color != end;) {
        *color++ = row[column];
        column = (uint16_t)(column + 1 == t->width ? 0 : column + 1);
    }
}

enum etch_status etch_tile_init(struct etch_tile *t, const uint16_t *texels, uint16_t width,
                                uint16_t height, uint16_t stride, int16_t x, int16_t y)
{
    if (texels == NULL || width == 0 || height == 0 || width > INT16_MAX || height > INT16_MAX ||
        stride < width)
        return ETCH_EINVAL;
    t->brush.colors = colors;
    t->texels = texels;
    t->width = width;
    t->height = height;
    t->stride = stride;
    t->x = x;
    t->y = y;
    return ETCH_OK;
}
