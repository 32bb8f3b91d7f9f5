/* ports/host/panel_port.c: panel drivers on simulated panels, by name. etch-sim and the tests call
 * it. See panel_port.h. */
#include "panel_port.h"

#include <string.h>

static const struct {
    const char *name;
    const struct etch_lcd_panel *driver;
} drivers[] = {
    {"ili9341", &etch_ili9341},
    {"st7789", &etch_st7789},
    {"st7789-240x240", &etch_st7789_240x240},
    {"st7789-135x240", &etch_st7789_135x240},
    {"st7735-black", &etch_st7735_black},
    {"st7735-red", &etch_st7735_red},
    {"st7735-green", &etch_st7735_green},
    {"st7735-128x128", &etch_st7735_128x128},
    {"st7735-80x160", &etch_st7735_80x160},
    {"gc9a01", &etch_gc9a01},
    {"ili9488", &etch_ili9488},
    {"st7796", &etch_st7796},
    {"ssd1351", &etch_ssd1351},
    {"ssd1306", &etch_ssd1306},
    {"ssd1306-128x32", &etch_ssd1306_128x32},
    {"ssd0323", &etch_ssd0323},
};

const struct etch_lcd_panel *etch_panel_driver(const char *name)
{
    for (size_t i = 0; i < sizeof drivers / sizeof drivers[0]; i++) {
        if (strcmp(drivers[i].name, name) == 0) {
            return drivers[i].driver;
        }
    }
    return NULL;
}

int etch_panel_turn_for(const struct etch_panel_type *type, int16_t width, int16_t height)
{
    return type->width == width && type->height == height   ? 0
           : type->width == height && type->height == width ? 1
                                                            : -1;
}

int etch_panel_port_open(struct etch_panel_port *port, const char *name, uint8_t turn)
{
    const struct etch_panel_type *type = etch_panel_find(name);
    const struct etch_lcd_panel *driver = etch_panel_driver(name);
    int status;

    if (type == NULL || driver == NULL) {
        return ETCH_EINVAL;
    }
    if (!etch_panel_open(&port->panel, type)) {
        return ETCH_ENOMEM;
    }
    etch_panel_bus_open(&port->bus, &port->panel);
    port->turn = turn;
    status = etch_lcd_open(&port->lcd, driver, &port->bus.bus,
                           (struct etch_lcd_setup){.turn = turn,
                                                   .scratch = port->scratch,
                                                   .scratch_size = sizeof port->scratch});
    if (status < 0) {
        etch_panel_close(&port->panel);
    }
    return status;
}

void etch_panel_port_close(struct etch_panel_port *port)
{
    etch_panel_close(&port->panel);
}

void etch_panel_port_shown(const struct etch_panel_port *port, uint16_t *pixels)
{
    for (int16_t y = 0; y < port->lcd.display.height; y++) {
        for (int16_t x = 0; x < port->lcd.display.width; x++) {
            const uint32_t c = etch_panel_view(&port->panel, port->turn, x, y);

            *pixels++ = (uint16_t)((c >> 8 & 0xF800) | (c >> 5 & 0x07E0) | (c >> 3 & 0x1F));
        }
    }
}
