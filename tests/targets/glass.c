/* tests/targets: glass PANEL TURN RULE .. <trace: what a panel shows after the register writes of a
 * board, as QEMU logs them (-trace memory_region_ops_write). Writes the frame, as a viewer sees it,
 * as big-endian RGB565 to standard output; an error of the panel ends it, or a panel left selected,
 * which would take what is meant for others on its bus.
 *
 * Rules name what a write to an address means. PIN is data (D/C), select or reset; it is driven by
 * the level of a bit, or by writing ones to a register that sets or clears it:
 *
 *      byte=ADDRESS             a byte goes out on the bus
 *      PIN.level=ADDRESS:MASK   PIN.set=ADDRESS:MASK   PIN.clear=ADDRESS:MASK
 *
 * select and reset are the pins of the chip, active low; select is taken as active if no rule
 * tells. Time passes by the log's order only, so waits are not checked here. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ports/host/panel.h"

enum {
    BYTE,
    DATA,
    SELECT,
    RESET,
    LEVEL = 0,
    SET,
    CLEAR,
    RULES = 16
};

struct rule {
    int pin, how;
    unsigned long address, mask;
};

static struct rule rules[RULES];
static int rule_count;
static struct etch_panel panel;
static bool level[4] = {[DATA] = true, [SELECT] = true, [RESET] = true};

static bool read_rule(const char *text)
{
    static const char *const pins[] = {"byte", "data", "select", "reset"};
    static const char *const hows[] = {".level", ".set", ".clear"};
    struct rule *rule = &rules[rule_count];

    for (int pin = 0; pin < 4; pin++)
        for (int how = 0; how < 3; how++) {
            char name[32];
            char *end;

            snprintf(name, sizeof name, "%s%s=", pins[pin], pin == BYTE ? "" : hows[how]);
            if (rule_count == RULES || strncmp(text, name, strlen(name)) != 0)
                continue;
            rule->pin = pin;
            rule->how = how;
            rule->address = strtoul(text + strlen(name), &end, 16);
            rule->mask = pin == BYTE ? 0xFF : *end == ':' ? strtoul(end + 1, &end, 16) : 0;
            rule_count++;
            return *end == '\0' && rule->mask != 0;
        }
    return false;
}

static void drive(int pin, bool high)
{
    if (level[pin] == high)
        return;
    level[pin] = high;
    etch_panel_elapse(&panel, 1000000000); /* as if the board had waited long enough */
    if (pin == SELECT)
        etch_panel_select(&panel, !high);
    if (pin == RESET)
        etch_panel_reset(&panel, !high);
}

static void written(unsigned long address, unsigned long value)
{
    for (const struct rule *r = rules; r < rules + rule_count; r++) {
        if (r->address != address)
            continue;
        if (r->pin == BYTE && level[DATA])
            etch_panel_data(&panel, (uint8_t)value);
        else if (r->pin == BYTE) {
            etch_panel_elapse(&panel, 1000000000);
            etch_panel_command(&panel, (uint8_t)value);
        } else if (r->how == LEVEL)
            drive(r->pin, (value & r->mask) != 0);
        else if ((value & r->mask) != 0)
            drive(r->pin, r->how == SET);
    }
}

static void read_trace(void)
{
    char line[512];

    while (fgets(line, sizeof line, stdin) != NULL) {
        const char *address = strstr(line, "addr 0x"), *value = strstr(line, "value 0x");

        if (address != NULL && value != NULL)
            written(strtoul(address + 7, NULL, 16), strtoul(value + 8, NULL, 16));
    }
}

static void show(uint8_t turn)
{
    const struct etch_panel_type *type = panel.type;
    const int width = (turn & 1) != 0 ? type->height : type->width;
    const int height = (turn & 1) != 0 ? type->width : type->height;

    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            const uint32_t c = etch_panel_view(&panel, turn, x, y);
            const unsigned pixel = (c >> 19 & 31) << 11 | (c >> 10 & 63) << 5 | (c >> 3 & 31);

            putchar((int)(pixel >> 8));
            putchar((int)(pixel & 0xFF));
        }
}

int main(int argc, char **argv)
{
    const struct etch_panel_type *type = argc > 3 ? etch_panel_find(argv[1]) : NULL;
    bool has_select = false;

    for (int i = 3; i < argc; i++) {
        if (!read_rule(argv[i]))
            type = NULL;
        has_select |= strncmp(argv[i], "select", 6) == 0;
    }
    if (type == NULL || !etch_panel_open(&panel, type)) {
        fputs("usage: glass PANEL TURN RULE .. <trace\n", stderr);
        return 2;
    }
    if (!has_select)
        etch_panel_select(&panel, true);
    read_trace();
    if (panel.error[0] != '\0') {
        fprintf(stderr, "%s: %s\n", argv[1], panel.error);
        return 1;
    }
    if (has_select && !level[SELECT]) {
        fprintf(stderr, "%s: still selected at the end\n", argv[1]);
        return 1;
    }
    show((uint8_t)atoi(argv[2]));
    etch_panel_close(&panel);
    return 0;
}
