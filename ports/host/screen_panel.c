/* ports/host/screen_panel.c: a panel of ports/spi_lcd as a screen: its driver, a bus, and a
 * simulated panel whose glass is looked at. screen.c calls it. See screen.h. */
#include <stdlib.h>

#include "screen.h"

int etch_screen_format(const char *name)
{
    return etch_panel_find(name) != NULL ? (int)ETCH_FORMAT_HIGH_BYTE_FIRST : -1;
}

/* The turn that was asked for, or the least that fits; -1, with the error set, if none does. */
static int choose_turn(const struct etch_panel_type *type, const struct etch_display *frame,
                       int turn, const char *path, struct etch_error *error)
{
    const int least = etch_panel_turn_for(type, frame->width, frame->height);
    const bool square = type->width == type->height;

    if (least < 0) {
        (void)etch_error_set(
            error, path, 0, "%s shows %d x %d, or %d x %d on its side, and not %d x %d", type->name,
            type->width, type->height, type->height, type->width, frame->width, frame->height);
        return -1;
    }
    if (turn >= 0 && (turn & 1) != least && !square) {
        (void)etch_error_set(error, path, 0, "%s does not show %d x %d at turn %d", type->name,
                             frame->width, frame->height, turn);
        return -1;
    }
    return turn >= 0 ? turn : least;
}

bool etch_screen_open_panel(struct etch_screen *screen, const struct etch_panel_type *type,
                            const struct etch_display *frame,
                            const struct etch_screen_panel *settings, const char *path,
                            struct etch_error *error)
{
    const int turn = choose_turn(type, frame, settings->turn, path, error);
    struct etch_panel_port *port = turn >= 0 ? malloc(sizeof *port) : NULL;
    int status;

    if (turn < 0) {
        return false;
    }
    status = port == NULL
                 ? ETCH_ENOMEM
                 : etch_panel_port_open(port, type->name, (uint8_t)(turn | settings->mirror));
    if (status < 0) {
        free(port);
        return etch_error_set(error, path, 0, "%s does not open: %d", type->name, status);
    }
    etch_panel_count(&port->panel);
    etch_panel_clock(&port->panel, settings->clock, settings->lanes);
    screen->panel = port;
    screen->opened_ns = port->panel.now_ns;
    screen->buffers = settings->buffers;
    screen->display = port->lcd.display;
    return true;
}

bool etch_screen_look(struct etch_screen *screen, const char *path, struct etch_error *error)
{
    struct etch_panel_port *port = screen->panel;

    if (port == NULL) {
        return true;
    }
    etch_panel_port_shown(port, screen->shown.pixels);
    screen->bytes = port->panel.bytes;
    screen->flushes = port->panel.transactions;
    return port->panel.error[0] == 0 || etch_error_set(error, path, 0, "%s refuses: %s",
                                                       port->panel.type->name, port->panel.error);
}

void etch_screen_close_panel(struct etch_screen *screen)
{
    if (screen->panel != NULL) {
        etch_panel_port_close(screen->panel);
        free(screen->panel);
        screen->panel = NULL;
    }
}
