/* ports/spi_lcd/lcd_set.c: the settings of a panel. The application calls them. See lcd.h. */
#include "lcd.h"

/* One command in a transaction of its own; 0 stands for a command that the controller lacks. */
static int set(struct etch_lcd *lcd, uint8_t command, const uint8_t *parameter)
{
    int status;

    if (command == 0) {
        return ETCH_EINVAL;
    }
    status = lcd->bus->begin(lcd->bus);
    if (status >= 0) {
        status = etch_lcd_command(lcd, command, parameter, parameter != NULL ? 1 : 0);
        lcd->bus->end(lcd->bus);
    }
    return status;
}

int etch_lcd_show(struct etch_lcd *lcd, bool on)
{
    const struct etch_lcd_controller *c = lcd->panel->controller;

    return set(lcd, on ? c->on : c->off, NULL);
}

int etch_lcd_sleep(struct etch_lcd *lcd, bool asleep)
{
    const struct etch_lcd_controller *c = lcd->panel->controller;
    const int status = set(lcd, asleep ? c->sleep : c->wake, NULL);

    lcd->bus->delay(lcd->bus, asleep ? 5 : 120);
    return status;
}

int etch_lcd_invert(struct etch_lcd *lcd, bool inverted)
{
    const struct etch_lcd_controller *c = lcd->panel->controller;

    return set(lcd, inverted != lcd->panel->inverted ? c->inverted : c->straight, NULL);
}

int etch_lcd_brightness(struct etch_lcd *lcd, uint8_t value)
{
    const struct etch_lcd_controller *c = lcd->panel->controller;
    const uint8_t parameter = (uint8_t)(value >> c->brightness_shift);

    return set(lcd, c->brightness, &parameter);
}
