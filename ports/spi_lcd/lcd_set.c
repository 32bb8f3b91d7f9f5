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

/* OLED controllers have one command for "awake" and "on", and one for their opposites: it is sent
 * if both are wanted, and neither call undoes the other. */
static bool is_one(const struct etch_lcd_controller *c)
{
    return c->wake == c->on;
}

int etch_lcd_show(struct etch_lcd *lcd, bool on)
{
    const struct etch_lcd_controller *c = lcd->panel->controller;

    lcd->hidden = !on;
    return lcd->asleep && is_one(c) ? ETCH_OK : set(lcd, on ? c->on : c->off, NULL);
}

int etch_lcd_sleep(struct etch_lcd *lcd, bool asleep)
{
    const struct etch_lcd_controller *c = lcd->panel->controller;
    int status = ETCH_OK;

    lcd->asleep = asleep;
    if (!lcd->hidden || !is_one(c)) {
        status = set(lcd, asleep ? c->sleep : c->wake, NULL);
    }
    lcd->bus->delay(lcd->bus, 120);
    return status;
}

int etch_lcd_invert(struct etch_lcd *lcd, bool inverted)
{
    const struct etch_lcd_controller *c = lcd->panel->controller;

    lcd->inverted = inverted;
    return set(lcd, inverted != lcd->panel->inverted ? c->inverted : c->straight, NULL);
}

int etch_lcd_brightness(struct etch_lcd *lcd, uint8_t value)
{
    const struct etch_lcd_controller *c = lcd->panel->controller;
    const uint8_t parameter = (uint8_t)(value >> c->brightness_shift);

    lcd->dimmed = c->brightness != 0;
    lcd->brightness = value;
    return set(lcd, c->brightness, &parameter);
}
