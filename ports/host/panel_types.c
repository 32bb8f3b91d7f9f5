/* ports/host/panel_types.c: the panels that can be simulated, and what their glasses show. Tests
 * and etch-sim call it. See panel.h. */
#include "panel.h"

#include <string.h>

/* name, family, glass, memory, first column and row, columns and rows from the far end, BGR,
 * inverting, RGB666 only, exclusive-or in C0 */
const struct etch_panel_type etch_panel_types[] = {
    {"ili9341", ETCH_PANEL_DCS, 240, 320, 240, 320, 0, 0, true, false, true, false, false, false},
    {"st7789", ETCH_PANEL_DCS, 240, 320, 240, 320, 0, 0, false, false, false, true, false, true},
    {"st7789-240x240", ETCH_PANEL_DCS, 240, 240, 240, 320, 0, 0, false, false, false, true, false,
     true},
    {"st7789-135x240", ETCH_PANEL_DCS, 135, 240, 240, 320, 52, 40, false, false, false, true, false,
     true},
    {"st7735-black", ETCH_PANEL_DCS, 128, 160, 128, 160, 0, 0, true, true, false, false, false,
     false},
    {"st7735-red", ETCH_PANEL_DCS, 128, 160, 128, 160, 0, 0, true, true, true, false, false, false},
    {"st7735-green", ETCH_PANEL_DCS, 128, 160, 132, 162, 2, 1, true, true, true, false, false,
     false},
    {"st7735-128x128", ETCH_PANEL_DCS, 128, 128, 132, 132, 2, 1, true, true, true, false, false,
     false},
    {"st7735-80x160", ETCH_PANEL_DCS, 80, 160, 132, 162, 26, 1, true, true, true, true, false,
     false},
    {"gc9a01", ETCH_PANEL_DCS, 240, 240, 240, 240, 0, 0, false, false, true, true, false, false},
    {"ili9488", ETCH_PANEL_DCS, 320, 480, 320, 480, 0, 0, true, false, true, false, true, false},
    {"st7796", ETCH_PANEL_DCS, 320, 480, 320, 480, 0, 0, true, false, true, false, false, false},
    {"ssd1351", ETCH_PANEL_SSD1351, 128, 128, 128, 128, 0, 0, false, false, true, false, false,
     false},
    {"ssd1306", ETCH_PANEL_SSD1306, 128, 64, 128, 64, 0, 0, true, true, false, false, false, false},
    {"ssd1306-128x32", ETCH_PANEL_SSD1306, 128, 32, 128, 64, 0, 0, true, true, false, false, false,
     false},
    {"ssd0323", ETCH_PANEL_SSD0323, 128, 64, 128, 80, 0, 12, false, false, false, false, false,
     false},
    {0},
};

const struct etch_panel_type *etch_panel_find(const char *name)
{
    const struct etch_panel_type *type = etch_panel_types;

    while (type->name != NULL && strcmp(type->name, name) != 0) {
        type++;
    }
    return type->name != NULL ? type : NULL;
}

/* Of its 80 lines some are on the glass, from `row` on, the lowest first; with bit 4 of A0 the
 * memory is read backwards, and from A2 on in any case. */
static int ssd0323_row(const struct etch_panel *p, int y)
{
    const int lines = p->type->memory_height;
    const int line = p->type->row + p->type->height - 1 - y;

    return ((p->orient & 0x10) != 0 ? lines - 1 - line + p->offset : line + p->offset) % lines;
}

/* Memory row behind glass row y. The OLED controllers scan within the lines that they drive,
 * from either end, so there the orientation acts here and not on addresses. */
static int memory_row(const struct etch_panel *p, int y)
{
    const struct etch_panel_type *t = p->type;
    const int line = t->flips_rows ? t->height - 1 - y : y;
    const int last = p->mux;

    switch (t->family) {
    case ETCH_PANEL_SSD1351:
        return (((p->orient & 0x10) != 0 ? line : last - line) + p->start) % 128;
    case ETCH_PANEL_SSD1306: return (((p->mode & 0x08) != 0 ? last - line : line) + p->start) % 64;
    case ETCH_PANEL_SSD0323: return ssd0323_row(p, line);
    default: return t->row + line;
    }
}

static bool swaps_red_and_blue(const struct etch_panel *p)
{
    const uint8_t bit = p->type->family == ETCH_PANEL_DCS       ? 0x08
                        : p->type->family == ETCH_PANEL_SSD1351 ? 0x04
                                                                : 0;
    const bool exchanged = p->type->has_c0 && (p->lcm & 0x20) == 0; /* the reset value has 20 set */

    return (((p->orient & bit) != 0) != p->type->bgr) != exchanged;
}

uint32_t etch_panel_glass(const struct etch_panel *p, int x, int y)
{
    const struct etch_panel_type *t = p->type;
    const int column = t->column + (t->flips_columns ? t->width - 1 - x : x);
    const int row = memory_row(p, y);
    const bool dark = p->asleep || !p->on || p->all_off || p->in_reset ||
                      (t->family == ETCH_PANEL_SSD1306 && !p->pumped);
    uint32_t color;

    if (dark || row < 0 || row >= t->memory_height) {
        return 0;
    }
    color = p->memory[row * t->memory_width + column];
    if (swaps_red_and_blue(p)) {
        color = color >> 16 | (color & 0xFF00) | (color & 0xFF) << 16;
    }
    return p->inverted != t->inverts ? color ^ 0xFFFFFF : color;
}

uint32_t etch_panel_view(const struct etch_panel *p, uint8_t turn, int x, int y)
{
    const int w = p->type->width, h = p->type->height;
    const int frame_w = (turn & 1) != 0 ? h : w, frame_h = (turn & 1) != 0 ? w : h;
    const int u = (turn & 4) != 0 ? frame_w - 1 - x : x;
    const int v = (turn & 8) != 0 ? frame_h - 1 - y : y;

    switch (turn & 3) {
    case 1: return etch_panel_glass(p, w - 1 - v, u);
    case 2: return etch_panel_glass(p, w - 1 - u, h - 1 - v);
    case 3: return etch_panel_glass(p, v, h - 1 - u);
    default: return etch_panel_glass(p, u, v);
    }
}
