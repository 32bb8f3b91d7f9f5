/* tests/unit: panels that are not listed, and tables of the user's own. */
#include "panel_parts.h"

void suite_panel_new(void);

static struct etch_panel_port port;

/* A user's own table is what is sent: here one that leaves an ST7789 inverted the other way. */
static void an_init_table_may_be_replaced(void)
{
    static const uint8_t init[] = {ETCH_LCD_DELAY, 0x11, 120, 1, 0x3A, 0x55, ETCH_LCD_END};
    struct etch_lcd_panel own = etch_st7789;

    own.init = init;
    CHECK(etch_panel_open(&port.panel, etch_panel_find("st7789")));
    etch_panel_bus_open(&port.bus, &port.panel);
    port.turn = 0;
    CHECK_EQ(etch_lcd_open(&port.lcd, &own, &port.bus.bus, (struct etch_lcd_setup){0}), 0);
    CHECK_EQ(panel_frame(&port, 3, 16, 2), 0);
    panel_check(&port, 3);
    etch_panel_port_close(&port);
}

/* Panels that are not listed are one table each, as ports/README.md tells: a 1.47" glass on a known
 * controller, and an ILI9486, which takes 18 bits a pixel. All rotations follow. */
static void a_new_panel_is_one_table(void)
{
    static const uint8_t init[] = {ETCH_LCD_DELAY, 0x11, 120, 1, 0x3A, 0x66, ETCH_LCD_END};
    static const struct etch_panel_type types[] = {{"st7789-172x320", ETCH_PANEL_DCS, 172, 320, 240,
                                                    320, 34, 0, false, false, false, true, false,
                                                    false},
                                                   {"ili9486", ETCH_PANEL_DCS, 320, 480, 320, 480,
                                                    0, 0, true, false, true, false, true, false}};
    struct etch_lcd_panel own[2] = {etch_st7789, etch_ili9341};

    own[0].width = 172;
    own[0].column = 34;
    own[1].init = init;
    own[1].controller = &etch_lcd_dcs_rgb666;
    own[1].width = own[1].memory_width = 320;
    own[1].height = own[1].memory_height = 480;
    for (int i = 0; i < 8; i++) {
        const struct etch_lcd_setup setup = {
            .turn = (uint8_t)(i / 2), .scratch = port.scratch, .scratch_size = sizeof port.scratch};

        CHECK(etch_panel_open(&port.panel, &types[i % 2]));
        etch_panel_bus_open(&port.bus, &port.panel);
        port.turn = setup.turn;
        CHECK_EQ(etch_lcd_open(&port.lcd, &own[i % 2], &port.bus.bus, setup), 0);
        CHECK_EQ(panel_frame(&port, i, 16, 2), 0);
        panel_check(&port, i);
        etch_panel_port_close(&port);
    }
}

void suite_panel_new(void)
{
    RUN(an_init_table_may_be_replaced);
    RUN(a_new_panel_is_one_table);
}
