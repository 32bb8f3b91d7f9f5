/* ports/host/panel_port.h: the panels of ports/spi_lcd by name, each on a simulated one: what
 * `etch-sim --port ili9341` and the tests draw on. */
#ifndef ETCH_HOST_PANEL_PORT_H
#define ETCH_HOST_PANEL_PORT_H

#include "../spi_lcd/panels.h"
#include "panel_bus.h"

struct etch_panel_port {
    struct etch_lcd lcd; /* .display is for the frame loop */
    struct etch_panel panel;
    struct etch_panel_bus bus;
    uint8_t turn, scratch[128];
};

/* The driver's table behind a name of panel_types.c; NULL if there is none. */
const struct etch_lcd_panel *etch_panel_driver(const char *name);

/* The turn (lcd.h) in which a panel's frame has this size, the least; -1: none has. */
int etch_panel_turn_for(const struct etch_panel_type *type, int16_t width, int16_t height);

/* Opens panel `name`, turned. 0, a status of etch_lcd_open, ETCH_EINVAL: no such name, or
 * ETCH_ENOMEM. Close only what was opened. `port` must stay where it is. */
int etch_panel_port_open(struct etch_panel_port *port, const char *name, uint8_t turn);
void etch_panel_port_close(struct etch_panel_port *port);

/* What the glass shows, as the frame of lcd.display: width x height elements of RGB565. */
void etch_panel_port_shown(const struct etch_panel_port *port, uint16_t *pixels);

#endif
