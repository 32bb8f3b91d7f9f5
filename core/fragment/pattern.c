/* fragment/pattern.c: 8 x 8 patterns of two colours. A brush; see pattern.h. */
#include "pattern.h"

static void colors(const struct etch_brush *brush, int16_t x, int16_t y, uint16_t n,
                   uint16_t *color)
{
    const struct etch_pattern *const p = (const struct etch_pattern *)brush;
    const uint32_t row = p->row[y & 7];

    for (uint16_t i = 0; i < n; i++)
        color[i] = p->color[row >> (7 - (((uint16_t)x + i) & 7)) & 1];
}

void etch_pattern_init(struct etch_pattern *p, const uint8_t *row, uint16_t clear, uint16_t set)
{
    p->brush.colors = colors;
    p->row = row;
    p->color[0] = clear;
    p->color[1] = set;
}
