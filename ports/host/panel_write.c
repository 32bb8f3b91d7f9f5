/* ports/host/panel_write.c: pixels into the memory of a simulated controller: formats, windows,
 * and where an address is. panel.c and panel_commands.c call it. */
#include "panel.h"

static bool is_dcs(const struct etch_panel *p)
{
    return p->type->family == ETCH_PANEL_DCS;
}

/* How many addresses there are across and down. */
static void get_extent(const struct etch_panel *p, int *across, int *down)
{
    const struct etch_panel_type *t = p->type;
    const bool swap = is_dcs(p) && (p->orient & 0x20) != 0;
    const int pair = t->family == ETCH_PANEL_SSD0323 ? 2 : 1;
    const int page = t->family == ETCH_PANEL_SSD1306 ? 8 : 1;

    *across = (swap ? t->memory_height : t->memory_width) / pair;
    *down = (swap ? t->memory_width : t->memory_height) / page;
}

/* Which of the two addresses counts first is the controller's setting. */
static bool counts_down_first(const struct etch_panel *p)
{
    switch (p->type->family) {
    case ETCH_PANEL_SSD1351: return (p->orient & 0x01) != 0;
    case ETCH_PANEL_SSD0323: return (p->orient & 0x04) != 0;
    case ETCH_PANEL_SSD1306: return (p->mode & 3) == 1;
    default: return false;
    }
}

/* Refuses a wrong window; data are pixels from here on, as many as are left from (x, y) on. */
static void begin_window(struct etch_panel *p)
{
    const int width = p->x1 - p->x0 + 1, height = p->y1 - p->y0 + 1;
    const bool inside = p->x >= p->x0 && p->x <= p->x1 && p->y >= p->y0 && p->y <= p->y1;
    int across, down;

    if (p->type->family == ETCH_PANEL_SSD1306 && (p->mode & 3) > 1) {
        etch_panel_refuse(p, "a window while addressing by pages");
    }
    get_extent(p, &across, &down);
    if (width < 1 || height < 1) {
        etch_panel_refuse(p, "window %d..%d x %d..%d is upside down", p->x0, p->x1, p->y0, p->y1);
    }
    if (p->x1 >= across || p->y1 >= down) {
        etch_panel_refuse(p, "window %d..%d x %d..%d is outside a memory of %d x %d", p->x0, p->x1,
                          p->y0, p->y1, across, down);
    }
    p->parts = 0;
    p->room = !inside ? 0
              : counts_down_first(p)
                  ? (uint32_t)(width * height - (p->x - p->x0) * height - (p->y - p->y0))
                  : (uint32_t)(width * height - (p->y - p->y0) * width - (p->x - p->x0));
    p->writes = true;
    p->has_window = true;
}

void etch_panel_window(struct etch_panel *p)
{
    p->x = p->x0;
    p->y = p->y0;
    begin_window(p);
}

void etch_panel_range(struct etch_panel *p, bool columns)
{
    if (columns) {
        p->x = p->x0;
    } else {
        p->y = p->y0;
    }
    begin_window(p);
}

/* Puts a colour at a place of the memory, and notes when its row changed. */
static void put(struct etch_panel *p, int column, int row, uint32_t color)
{
    uint32_t *at = &p->memory[row * p->type->memory_width + column];

    p->pixels++;
    if (*at != color) {
        if (p->changed_first[row] == 0) {
            p->changed_first[row] = p->now_ns;
        }
        p->changed_last[row] = p->now_ns;
        *at = color;
    }
}

static void put_dcs(struct etch_panel *p, uint32_t color)
{
    const bool swap = (p->orient & 0x20) != 0;
    int column = swap ? p->y : p->x, row = swap ? p->x : p->y;

    if ((p->orient & 0x40) != 0) {
        column = p->type->memory_width - 1 - column;
    }
    if ((p->orient & 0x80) != 0) {
        row = p->type->memory_height - 1 - row;
    }
    put(p, column, row, color);
}

/* To the next address, and from the last to the first. */
static void advance(struct etch_panel *p)
{
    p->room--;
    if (counts_down_first(p)) {
        if (++p->y > p->y1) {
            p->y = p->y0;
            p->x = p->x == p->x1 ? p->x0 : p->x + 1;
        }
    } else if (++p->x > p->x1) {
        p->x = p->x0;
        p->y = p->y == p->y1 ? p->y0 : p->y + 1;
    }
}

static void write_color(struct etch_panel *p, uint8_t byte)
{
    const int size = is_dcs(p) && p->format == 6 ? 3 : 2;
    uint32_t r, g, b;

    p->part[p->parts++] = byte;
    if (p->parts < size) {
        return;
    }
    p->parts = 0;
    if (size == 3) {
        r = p->part[0] >> 2, g = p->part[1] >> 2, b = p->part[2] >> 2;
        r = r << 2 | r >> 4, b = b << 2 | b >> 4;
    } else {
        r = p->part[0] >> 3, b = p->part[1] & 31;
        g = (p->part[0] & 7U) << 3 | p->part[1] >> 5;
        r = r << 3 | r >> 2, b = b << 3 | b >> 2;
    }
    g = g << 2 | g >> 4;
    if (is_dcs(p)) {
        put_dcs(p, r << 16 | g << 8 | b);
    } else {
        if ((p->orient & 0xC0) != 0x40) {
            etch_panel_refuse(p, "pixels of 16 bits, but command A0 set another format");
        }
        put(p, (p->orient & 0x02) != 0 ? 127 - p->x : p->x, p->y, r << 16 | g << 8 | b);
    }
    advance(p);
}

static void write_mono(struct etch_panel *p, uint8_t byte)
{
    const int column = (p->orient & 1) != 0 ? 127 - p->x : p->x;

    for (int i = 0; i < 8; i++) {
        put(p, column, p->y * 8 + i, (byte >> i & 1) != 0 ? 0xFFFFFF : 0);
    }
    if ((p->mode & 3) == 2) { /* by pages: round and round in one */
        p->x = (p->x + 1) & 0x7F;
    } else {
        advance(p);
    }
}

static void write_gray(struct etch_panel *p, uint8_t byte)
{
    const int column = ((p->orient & 1) != 0 ? 63 - p->x : p->x) * 2;
    const uint32_t high = byte >> 4, low = byte & 15;
    const bool high_left = (p->orient & 2) != 0;

    put(p, column, p->y, (high_left ? high : low) * 0x111111);
    put(p, column + 1, p->y, (high_left ? low : high) * 0x111111);
    advance(p);
}

void etch_panel_write(struct etch_panel *p, uint8_t byte)
{
    const bool pages = p->type->family == ETCH_PANEL_SSD1306 && (p->mode & 3) == 2;

    if (p->room == 0 && !pages) {
        etch_panel_refuse(p, "more pixels than the window %d..%d x %d..%d holds", p->x0, p->x1,
                          p->y0, p->y1);
    } else if (p->type->family == ETCH_PANEL_SSD1306) {
        write_mono(p, byte);
    } else if (p->type->family == ETCH_PANEL_SSD0323) {
        write_gray(p, byte);
    } else {
        write_color(p, byte);
    }
}
