/* ports/host/panel_commands.c: the commands of the simulated controllers. panel.c calls it with
 * each that is complete. Counts of parameters as public drivers of these controllers send them. */
#include "panel.h"

#include <string.h>

/* {command, count of parameters}; -1: any number, -2: pixels. */
struct command {
    uint8_t code;
    int8_t count;
};

static const struct command dcs[] = {
    {0x00, 0}, {0x01, 0}, {0x10, 0}, {0x11, 0}, {0x12, 0}, {0x13, 0}, {0x20, 0},
    {0x21, 0}, {0x26, 1}, {0x28, 0}, {0x29, 0}, {0x2A, 4}, {0x2B, 4}, {0x2C, -2},
    {0x30, 4}, {0x33, 6}, {0x34, 0}, {0x35, 1}, {0x36, 1}, {0x37, 2}, {0x38, 0},
    {0x39, 0}, {0x3A, 1}, {0x44, 2}, {0x51, 1}, {0x53, 1}, {0x55, 1}, {0, 0},
};

static const struct command ssd1351[] = {
    {0x15, 2}, {0x75, 2}, {0x5C, -2}, {0xA0, 1}, {0xA1, 1}, {0xA2, 1},  {0xA4, 0},
    {0xA5, 0}, {0xA6, 0}, {0xA7, 0},  {0xAB, 1}, {0xAE, 0}, {0xAF, 0},  {0xB1, 1},
    {0xB2, 3}, {0xB3, 1}, {0xB4, 3},  {0xB5, 1}, {0xB6, 1}, {0xB8, 63}, {0xB9, 0},
    {0xBB, 1}, {0xBE, 1}, {0xC1, 3},  {0xC7, 1}, {0xCA, 1}, {0xFD, 1},  {0, 0},
};

static const struct command ssd1306[] = {
    {0x20, 1}, {0x21, 2}, {0x22, 2}, {0x2E, 0}, {0x40, 0}, {0x81, 1}, {0x8D, 1},
    {0xA0, 0}, {0xA1, 0}, {0xA4, 0}, {0xA5, 0}, {0xA6, 0}, {0xA7, 0}, {0xA8, 1},
    {0xAE, 0}, {0xAF, 0}, {0xC0, 0}, {0xC8, 0}, {0xD3, 1}, {0xD5, 1}, {0xD9, 1},
    {0xDA, 1}, {0xDB, 1}, {0xE3, 0}, {0, 0},
};

static const struct command ssd0323[] = {
    {0x15, 2}, {0x75, 2}, {0x81, 1}, {0x84, 0}, {0x85, 0}, {0x86, 0}, {0xA0, 1},
    {0xA1, 1}, {0xA2, 1}, {0xA4, 0}, {0xA5, 0}, {0xA6, 0}, {0xA7, 0}, {0xA8, 1},
    {0xAD, 1}, {0xAE, 0}, {0xAF, 0}, {0xB0, 1}, {0xB1, 1}, {0xB2, 1}, {0xB3, 1},
    {0xB4, 1}, {0xB8, 8}, {0xBC, 1}, {0xBE, 1}, {0xBF, 1}, {0xE3, 0}, {0, 0},
};

int etch_panel_parameters(const struct etch_panel *panel, uint8_t command)
{
    static const struct command *const tables[] = {dcs, ssd1351, ssd1306, ssd0323};
    const struct command *c = tables[panel->type->family];

    if (panel->type->family == ETCH_PANEL_DCS && command > 0x5F) {
        return panel->type->has_c0 && command == 0xC0 ? 1 : -1; /* the makers' own */
    }
    if (panel->type->family == ETCH_PANEL_SSD1306 &&
        (command < 0x20 || (command >= 0x40 && command < 0x80) || (command & 0xF8) == 0xB0)) {
        return 0; /* a number is part of the command */
    }
    if (c->code == command) {
        return c->count;
    }
    do {
        c++;
    } while (c->code != command && c->code != 0);
    return c->code == 0 ? -3 : c->count;
}

void etch_panel_initial(struct etch_panel *p)
{
    const struct etch_panel_type *t = p->type;

    p->asleep = true;
    p->on = p->inverted = p->all_off = p->pumped = p->unlocked = false;
    p->orient = t->family == ETCH_PANEL_SSD1351 ? 0x40 : 0;
    p->lcm = 0x2C;
    p->mode = 2; /* SSD1306: by pages; bit 3 is the direction of the lines */
    p->mux = (uint8_t)(t->memory_height < 256 ? t->memory_height - 1 : 255);
    p->format = 6;
    p->brightness = p->offset = p->start = 0;
    p->command = -1;
    p->count = p->wanted = p->parts = 0;
    p->writes = p->has_window = p->broken = false;
    p->x0 = p->y0 = p->x1 = p->y1 = p->x = p->y = 0;
    p->room = 0;
    p->pulses = false;
}

static void sleep(struct etch_panel *p, bool asleep)
{
    if (!asleep && p->now_ns < p->wake_ns) {
        etch_panel_refuse(p, "woken up too soon after reset or sleep");
    }
    p->asleep = asleep;
    if (p->type->family == ETCH_PANEL_DCS) {
        p->ready_ns = p->now_ns + 5000000;
        p->wake_ns = p->now_ns + (asleep ? 120000000 : 0);
    }
}

static int word(const uint8_t *bytes)
{
    return bytes[0] << 8 | bytes[1];
}

static void execute_dcs(struct etch_panel *p)
{
    const uint8_t *v = p->parameter;

    switch (p->command) {
    case 0x01:
        etch_panel_initial(p);
        p->command = 0x01;
        p->ready_ns = p->now_ns + 5000000;
        p->wake_ns = p->now_ns + 120000000;
        break;
    case 0x10:
    case 0x11: sleep(p, p->command == 0x10); break;
    case 0x20:
    case 0x21: p->inverted = p->command == 0x21; break;
    case 0x28:
    case 0x29: p->on = p->command == 0x29; break;
    case 0x2A: p->x0 = word(v), p->x1 = word(v + 2); break;
    case 0x2B: p->y0 = word(v), p->y1 = word(v + 2); break;
    case 0x34: p->pulses = false; break;
    case 0x35: p->pulses = true; break;
    case 0x36: p->orient = v[0]; break;
    case 0x3A:
        p->format = v[0] & 7;
        if (p->format != 6 && (p->format != 5 || p->type->only_rgb666)) {
            etch_panel_refuse(p, "no pixel format %02X on this bus", (unsigned)v[0]);
        }
        break;
    case 0x51: p->brightness = v[0]; break;
    case 0xC0: p->lcm = v[0]; break;
    default: break;
    }
}

static void execute_ssd1351(struct etch_panel *p)
{
    static const char locked[] = "\xA2\xB1\xB3\xBB\xBE\xC1";
    const uint8_t *v = p->parameter;

    if (!p->unlocked && strchr(locked, p->command) != NULL) {
        etch_panel_refuse(p, "command %02X is locked", (unsigned)p->command);
    }
    switch (p->command) {
    case 0x15: p->x0 = v[0], p->x1 = v[1]; break;
    case 0x75: p->y0 = v[0], p->y1 = v[1]; break;
    case 0xA0: p->orient = v[0]; break;
    case 0xA4: p->all_off = true; break;
    case 0xA6:
    case 0xA7: p->all_off = false, p->inverted = p->command == 0xA7; break;
    case 0xAE:
    case 0xAF: p->on = p->command == 0xAF, p->asleep = !p->on; break;
    case 0xA1: p->start = v[0] & 0x7F; break;
    case 0xC7:
        if (v[0] > 0x0F) {
            etch_panel_refuse(p, "contrast %02X has more than 4 bits", (unsigned)v[0]);
        }
        p->brightness = v[0];
        break;
    case 0xCA: p->mux = v[0]; break;
    case 0xFD: p->unlocked = v[0] == 0xB1 || (p->unlocked && v[0] == 0x12); break;
    default: break;
    }
}

/* Commands that hold a number: the first line, and a page and column for addressing by pages. */
static void execute_number(struct etch_panel *p)
{
    const int code = p->command;

    if (code >= 0x40 && code < 0x80) {
        p->start = (uint8_t)(code & 0x3F);
        return;
    }
    if ((p->mode & 3) != 2) {
        etch_panel_refuse(p, "command %02X is for addressing by pages", (unsigned)code);
    }
    if (code < 0x10) {
        p->x = (p->x & 0x70) | code;
    } else if (code < 0x20) {
        p->x = (p->x & 0x0F) | (code & 0x07) << 4;
    } else {
        p->y = code & 7;
        p->writes = p->has_window = true;
    }
}

static void execute_ssd1306(struct etch_panel *p)
{
    const uint8_t *v = p->parameter;

    if (p->command < 0x20 || (p->command >= 0x40 && p->command < 0x80) ||
        (p->command & 0xF8) == 0xB0) {
        execute_number(p);
        return;
    }
    switch (p->command) {
    case 0x20: p->mode = (uint8_t)((p->mode & 0x08) | (v[0] & 3)); break;
    case 0x21: p->x0 = v[0], p->x1 = v[1], etch_panel_range(p, true); break;
    case 0x22: p->y0 = v[0], p->y1 = v[1], etch_panel_range(p, false); break;
    case 0x81: p->brightness = v[0]; break;
    case 0x8D: p->pumped = v[0] == 0x14; break;
    case 0xA0:
    case 0xA1: p->orient = p->command & 1; break;
    case 0xA6:
    case 0xA7: p->inverted = p->command == 0xA7; break;
    case 0xA8: p->mux = v[0]; break;
    case 0xAE:
    case 0xAF: p->on = p->command == 0xAF, p->asleep = !p->on; break;
    case 0xC0:
    case 0xC8: p->mode = (uint8_t)((p->mode & 3) | (p->command & 0x08)); break;
    default: break;
    }
}

static void execute_ssd0323(struct etch_panel *p)
{
    const uint8_t *v = p->parameter;

    switch (p->command) {
    case 0x15: p->x0 = v[0], p->x1 = v[1], etch_panel_range(p, true); break;
    case 0x75: p->y0 = v[0], p->y1 = v[1], etch_panel_range(p, false); break;
    case 0x81:
        if (v[0] > 0x7F) {
            etch_panel_refuse(p, "contrast %02X has more than 7 bits", (unsigned)v[0]);
        }
        p->brightness = v[0];
        break;
    case 0xA0: p->orient = v[0]; break;
    case 0xA2: p->offset = v[0]; break;
    case 0xA4:
    case 0xA7: p->all_off = false, p->inverted = p->command == 0xA7; break;
    case 0xA6: p->all_off = true; break;
    case 0xA8: p->mux = v[0]; break;
    case 0xAE:
    case 0xAF: p->on = p->command == 0xAF, p->asleep = !p->on; break;
    default: break;
    }
}

void etch_panel_execute(struct etch_panel *panel)
{
    switch (panel->type->family) {
    case ETCH_PANEL_SSD1351: execute_ssd1351(panel); break;
    case ETCH_PANEL_SSD1306: execute_ssd1306(panel); break;
    case ETCH_PANEL_SSD0323: execute_ssd0323(panel); break;
    default: execute_dcs(panel); break;
    }
}
