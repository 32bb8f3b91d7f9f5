/* ports/host/panel.c: the pins of a simulated panel: bytes become commands, parameters and pixels.
 * A bus calls it; panel_commands.c and panel_write.c do what the bytes say. See panel.h. */
#include "panel.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

void etch_panel_refuse(struct etch_panel *panel, const char *format, ...)
{
    va_list values;

    if (panel->error[0] == 0) {
        va_start(values, format);
        (void)vsnprintf(panel->error, sizeof panel->error, format, values);
        va_end(values);
    }
}

bool etch_panel_open(struct etch_panel *panel, const struct etch_panel_type *type)
{
    const size_t rows = (size_t)type->memory_height;
    const int32_t cells = (int32_t)type->memory_height * type->memory_width;
    const size_t size = (size_t)cells;
    uint32_t noise = 1;

    *panel = (struct etch_panel){.type = type};
    panel->memory = malloc(size * sizeof *panel->memory);
    panel->changed_first = calloc(rows, sizeof *panel->changed_first);
    panel->changed_last = calloc(rows, sizeof *panel->changed_last);
    if (panel->memory == NULL || panel->changed_first == NULL || panel->changed_last == NULL) {
        etch_panel_close(panel);
        return false;
    }
    for (size_t i = 0; i < size; i++) {
        noise = (uint32_t)((noise * (uint64_t)48271) % 2147483647);
        panel->memory[i] = noise & 0xFFFFFF;
    }
    etch_panel_initial(panel);
    panel->in_reset = true;
    return true;
}

void etch_panel_close(struct etch_panel *panel)
{
    free(panel->memory);
    free(panel->changed_first);
    free(panel->changed_last);
    panel->memory = NULL;
    panel->changed_first = panel->changed_last = NULL;
}

void etch_panel_count(struct etch_panel *panel)
{
    panel->transactions = panel->commands = panel->parameters = 0;
    panel->pixels = panel->bytes = 0;
}

/* ---- time ---------------------------------------------------------------------------------- */

void etch_panel_clock(struct etch_panel *panel, uint32_t clock, uint8_t bits)
{
    panel->byte_ps = UINT64_C(8000000000000) / clock / bits;
}

void etch_panel_elapse(struct etch_panel *panel, uint64_t ns)
{
    panel->now_ns += ns;
}

static void byte_passes(struct etch_panel *panel)
{
    panel->bytes++;
    panel->picoseconds += panel->byte_ps;
    panel->now_ns += panel->picoseconds / 1000;
    panel->picoseconds %= 1000;
}

/* ---- pins ---------------------------------------------------------------------------------- */

void etch_panel_reset(struct etch_panel *panel, bool active)
{
    if (panel->in_reset && !active) {
        etch_panel_initial(panel);
        panel->ready_ns = panel->now_ns + 5000000;
        panel->wake_ns = panel->now_ns + 120000000;
    }
    panel->in_reset = active;
}

/* The parameters of the last command are all there, and no pixel is half sent. */
static void check_complete(struct etch_panel *panel)
{
    if (panel->count < panel->wanted && !panel->broken) {
        etch_panel_refuse(panel, "command %02X has %d parameters and got %d",
                          (unsigned)panel->command, panel->wanted, panel->count);
    }
    if (panel->parts != 0) {
        etch_panel_refuse(panel, "a pixel of %d bytes was cut off", panel->parts);
    }
}

void etch_panel_select(struct etch_panel *panel, bool selected)
{
    if (selected == panel->selected) {
        etch_panel_refuse(panel, selected ? "selected twice" : "deselected twice");
    }
    if (!selected) {
        check_complete(panel);
    }
    panel->selected = selected;
    panel->transactions += selected;
}

static bool may_talk(struct etch_panel *panel, const char *what, unsigned byte)
{
    if (!panel->selected) {
        etch_panel_refuse(panel, "%s %02X without select", what, byte);
    }
    if (panel->in_reset) {
        etch_panel_refuse(panel, "%s %02X during reset", what, byte);
    }
    if (panel->now_ns < panel->ready_ns) {
        etch_panel_refuse(panel, "%s %02X too soon after reset, sleep or waking up", what, byte);
    }
    return panel->error[0] == 0;
}

static void take_parameter(struct etch_panel *panel, uint8_t byte)
{
    if (panel->count < ETCH_PANEL_PARAMETERS) {
        panel->parameter[panel->count] = byte;
    }
    panel->count++;
    panel->parameters++;
    if (panel->count == panel->wanted) {
        if (!panel->broken) {
            etch_panel_execute(panel);
        }
        panel->broken = false;
    }
}

static bool parameters_are_commands(const struct etch_panel *panel)
{
    return panel->type->family == ETCH_PANEL_SSD1306 || panel->type->family == ETCH_PANEL_SSD0323;
}

/* Where parameters are commands, the controller goes on waiting for them. */
void etch_panel_interrupt(struct etch_panel *panel)
{
    panel->parts = 0;
    if (panel->count < panel->wanted) {
        panel->broken = parameters_are_commands(panel);
        panel->wanted = panel->broken ? panel->wanted : panel->count;
    }
}

void etch_panel_command(struct etch_panel *panel, uint8_t byte)
{
    byte_passes(panel);
    if (!may_talk(panel, "command", byte)) {
        return;
    }
    if (parameters_are_commands(panel) && panel->count < panel->wanted) {
        take_parameter(panel, byte);
        return;
    }
    check_complete(panel);
    panel->commands++;
    panel->command = byte;
    panel->count = 0;
    panel->wanted = etch_panel_parameters(panel, byte);
    panel->writes = panel->writes && parameters_are_commands(panel);
    if (panel->wanted == -3) {
        etch_panel_refuse(panel, "there is no command %02X", (unsigned)byte);
    } else if (panel->wanted == -2) {
        panel->wanted = 0;
        etch_panel_window(panel);
    } else if (panel->wanted == 0) {
        etch_panel_execute(panel);
    }
}

void etch_panel_data(struct etch_panel *panel, uint8_t byte)
{
    byte_passes(panel);
    if (!may_talk(panel, "data", byte)) {
        return;
    }
    if (parameters_are_commands(panel)) {
        check_complete(panel);
    }
    if (panel->writes) {
        if (panel->error[0] == 0) {
            etch_panel_write(panel, byte);
        }
    } else if (panel->command < 0) {
        etch_panel_refuse(panel, "data %02X before any command", (unsigned)byte);
    } else if (parameters_are_commands(panel)) {
        etch_panel_refuse(panel, "pixels before a window");
    } else if (panel->wanted >= 0 && panel->count >= panel->wanted) {
        etch_panel_refuse(panel, "command %02X has %d parameters and got more",
                          (unsigned)panel->command, panel->wanted);
    } else {
        take_parameter(panel, byte);
    }
}
