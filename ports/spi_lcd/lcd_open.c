/* ports/spi_lcd/lcd_open.c: a panel is started and turned. The application calls it before lcd.c
 * sends frames. See lcd.h. */
#include "lcd.h"

int etch_lcd_orient(struct etch_lcd *lcd)
{
    const struct etch_lcd_controller *c = lcd->panel->controller;
    const bool rows = (lcd->orientation & ETCH_LCD_FLIP_ROWS) != 0;
    const bool follows = (lcd->setup.turn & ETCH_LCD_FOLLOW_SCAN) != 0;
    const unsigned bits = ((lcd->orientation & ETCH_LCD_FLIP_COLUMNS) != 0 ? c->flip_columns : 0U) ^
                          (rows ? c->flip_rows : 0U) ^
                          ((lcd->orientation & ETCH_LCD_SWAP) != 0 ? c->swap : 0U) ^
                          (rows && follows ? c->scan_up : 0U) ^ (lcd->panel->bgr ? c->bgr : 0U);
    const uint8_t value = (uint8_t)(c->base ^ bits);

    return etch_lcd_command(lcd, c->orient, &value, 1);
}

static uint8_t orientation_of(uint8_t mount, uint8_t turn)
{
    static const uint8_t turned[4] = {0, ETCH_LCD_SWAP | ETCH_LCD_FLIP_COLUMNS,
                                      ETCH_LCD_FLIP_COLUMNS | ETCH_LCD_FLIP_ROWS,
                                      ETCH_LCD_SWAP | ETCH_LCD_FLIP_ROWS};
    const uint8_t orientation = (uint8_t)(mount ^ turned[turn & 3]);
    const bool swap = (orientation & ETCH_LCD_SWAP) != 0;
    const uint8_t along_x = swap ? ETCH_LCD_FLIP_ROWS : ETCH_LCD_FLIP_COLUMNS;
    const uint8_t along_y = swap ? ETCH_LCD_FLIP_COLUMNS : ETCH_LCD_FLIP_ROWS;

    return (uint8_t)(orientation ^ ((turn & ETCH_LCD_MIRROR_X) != 0 ? along_x : 0) ^
                     ((turn & ETCH_LCD_MIRROR_Y) != 0 ? along_y : 0));
}

/* Width, height, alignment and offsets of the turned frame. */
static void place(struct etch_lcd *lcd, uint8_t turn)
{
    const struct etch_lcd_panel *p = lcd->panel;
    const uint8_t orientation = orientation_of(p->mount, turn);
    const bool swap = (orientation & ETCH_LCD_SWAP) != 0;
    const bool addresses = p->controller->addresses_turn;
    const bool from_right = addresses && (orientation & ETCH_LCD_FLIP_COLUMNS) != 0;
    const bool from_bottom = addresses && (orientation & ETCH_LCD_FLIP_ROWS) != 0;
    const int16_t column = from_right ? (int16_t)(p->memory_width - p->width - p->column)
                                      : p->column;
    const int16_t row = from_bottom ? (int16_t)(p->memory_height - p->height - p->row) : p->row;

    lcd->setup.turn = turn;
    lcd->orientation = orientation;
    lcd->column = addresses && swap ? row : column;
    lcd->row = addresses && swap ? column : row;
    lcd->display.width = swap ? p->height : p->width;
    lcd->display.height = swap ? p->width : p->height;
    lcd->display.align_x = swap ? p->align_y : p->align_x;
    lcd->display.align_y = swap ? p->align_x : p->align_y;
}

int etch_lcd_turn(struct etch_lcd *lcd, uint8_t turn)
{
    int status = lcd->bus->begin(lcd->bus);

    if (status >= 0) {
        place(lcd, turn);
        lcd->window = (struct etch_rect){0, 0, 0, 0};
        status = lcd->panel->controller->turn(lcd);
        lcd->bus->end(lcd->bus);
    }
    return status;
}

static int run_table(struct etch_lcd *lcd, const uint8_t *at)
{
    int status = ETCH_OK;

    while (status >= 0 && *at != ETCH_LCD_END) {
        const uint8_t n = (uint8_t)(*at & ~ETCH_LCD_DELAY);
        const bool delay = (*at & ETCH_LCD_DELAY) != 0;

        status = etch_lcd_command(lcd, at[1], at + 2, n);
        at += 2 + n;
        if (delay) {
            lcd->bus->delay(lcd->bus, *at++);
        }
    }
    return status;
}

/* Black is 0 in every format. Columns of 32 pixels, each row out of the same black one. */
static int clear(struct etch_lcd *lcd)
{
    static const uint16_t black[32] = {0};
    const struct etch_display *d = &lcd->display;
    int status = ETCH_OK;

    for (int16_t x = 0; x < d->width && status >= 0; x = (int16_t)(x + 32)) {
        const int16_t x1 = d->width - x < 32 ? d->width : (int16_t)(x + 32);

        status = d->flush(d, (struct etch_rect){x, 0, x1, d->height}, black, 0);
        status = status < 0 ? status : d->wait(d);
    }
    return status;
}

/* The controller's own settings, in one transaction. */
static int prepare(struct etch_lcd *lcd)
{
    const struct etch_lcd_controller *c = lcd->panel->controller;
    const uint8_t tearing = 0; /* a pulse a frame, none a line */
    int status = lcd->bus->begin(lcd->bus);

    if (status < 0) {
        return status;
    }
    status = run_table(lcd, lcd->panel->init);
    if (status >= 0) {
        status = c->turn(lcd);
    }
    if (status >= 0) {
        status = etch_lcd_command(
            lcd, lcd->panel->inverted != lcd->inverted ? c->inverted : c->straight, NULL, 0);
    }
    if (status >= 0 && lcd->setup.sync != NULL && c->tearing != 0) {
        status = etch_lcd_command(lcd, c->tearing, &tearing, 1);
    }
    lcd->bus->end(lcd->bus);
    return status;
}

/* The settings that were asked for; the panel is awake and off. */
static int restore(struct etch_lcd *lcd)
{
    const bool asleep = lcd->asleep;
    int status = ETCH_OK;

    lcd->asleep = false;
    if (lcd->dimmed) {
        status = etch_lcd_brightness(lcd, lcd->brightness);
    }
    if (status >= 0 && !lcd->hidden) {
        status = etch_lcd_show(lcd, true);
    }
    lcd->asleep = asleep;
    return status >= 0 && asleep ? etch_lcd_sleep(lcd, true) : status;
}

int etch_lcd_restart(struct etch_lcd *lcd)
{
    const struct etch_bus *bus = lcd->bus;
    int status;

    bus->reset(bus, true);
    bus->delay(bus, 10);
    bus->reset(bus, false);
    bus->delay(bus, 120);
    lcd->window = (struct etch_rect){0, 0, 0, 0};
    status = prepare(lcd);
    if (status >= 0) {
        status = clear(lcd);
    }
    return status < 0 ? status : restore(lcd);
}

int etch_lcd_open(struct etch_lcd *lcd, const struct etch_lcd_panel *panel,
                  const struct etch_bus *bus, struct etch_lcd_setup setup)
{
    ETCH_ASSERT(lcd != NULL && panel != NULL && bus != NULL);
    ETCH_ASSERT((panel->align_x <= 1 || panel->width % panel->align_x == 0) &&
                (panel->align_y <= 1 || panel->height % panel->align_y == 0));
    *lcd = (struct etch_lcd){.panel = panel, .bus = bus, .setup = setup};
    lcd->display = (struct etch_display){.context = lcd,
                                         .format = ETCH_FORMAT_HIGH_BYTE_FIRST,
                                         .flush = etch_lcd_flush,
                                         .wait = etch_lcd_wait,
                                         .sync = setup.sync};
    place(lcd, setup.turn);
    if (panel->controller->convert != NULL && (setup.scratch == NULL || setup.scratch_size < 12)) {
        return ETCH_ENOMEM;
    }
    return etch_lcd_restart(lcd);
}
