/* tests/unit: the settings of panels, and restarting them. */
#include "panel_parts.h"

void suite_panel_set(void);

static struct etch_panel_port port;

static bool open_port(const char *name, uint8_t turn)
{
    return CHECK_EQ(etch_panel_port_open(&port, name, turn), 0);
}

static uint32_t corner(void)
{
    return etch_panel_view(&port.panel, 0, port.lcd.display.width - 1, 0);
}

/* Off and asleep the glass is dark, inverted it is the complement, and all of it comes back. */
static void settings_work(void)
{
    for (const struct etch_panel_type *t = etch_panel_types; t->name != NULL; t++) {
        uint32_t seen;

        if (!open_port(t->name, 0))
            return;
        CHECK_EQ(panel_frame(&port, 0, 16, 1), 0);
        seen = corner();
        CHECK_EQ(etch_lcd_invert(&port.lcd, true), 0);
        CHECK_EQ(corner(), seen ^ 0xFFFFFF);
        CHECK_EQ(etch_lcd_sleep(&port.lcd, true), 0);
        CHECK(port.panel.asleep && corner() == 0);
        CHECK_EQ(etch_lcd_sleep(&port.lcd, false), 0);
        CHECK_EQ(corner(), seen ^ 0xFFFFFF);
        CHECK_EQ(etch_lcd_invert(&port.lcd, false), 0);
        CHECK_EQ(etch_lcd_show(&port.lcd, false), 0);
        CHECK_EQ(corner(), 0);
        CHECK_EQ(etch_lcd_show(&port.lcd, true), 0);
        panel_check(&port, 0);
        CHECK_EQ(etch_lcd_brightness(&port.lcd, 200),
                 port.lcd.panel->controller->brightness != 0 ? 0 : ETCH_EINVAL);
        CHECK(port.panel.error[0] == 0);
        etch_panel_port_close(&port);
    }
}

/* "Off" and "asleep" are two wishes, whichever comes first and whether or not the controller has
 * one command for both: the glass is lit only while neither holds. */
static void off_and_asleep_are_apart(void)
{
    for (const struct etch_panel_type *t = etch_panel_types; t->name != NULL; t++) {
        uint32_t seed = 0x0FF;
        bool on = true, asleep = false;

        if (!open_port(t->name, 0))
            return;
        CHECK_EQ(panel_frame(&port, 0, 16, 1), 0);
        for (int i = 0; i < 40; i++) {
            if (test_range(&seed, 0, 1) != 0) {
                on = !on;
                CHECK_EQ(etch_lcd_show(&port.lcd, on), 0);
            } else {
                asleep = !asleep;
                CHECK_EQ(etch_lcd_sleep(&port.lcd, asleep), 0);
            }
            CHECK_EQ(etch_panel_glass(&port.panel, 65, 20) != 0, on && !asleep);
        }
        CHECK(port.panel.error[0] == 0);
        etch_panel_port_close(&port);
    }
}

/* The supply sags: the controller is as after power-up, with noise in its memory. */
static void brown_out(void)
{
    for (int i = 0; i < port.panel.type->memory_width * port.panel.type->memory_height; i++)
        port.panel.memory[i] = (uint32_t)i * 77 & 0xFFFFFF;
    etch_panel_reset(&port.panel, true);
    etch_panel_reset(&port.panel, false);
    etch_panel_elapse(&port.panel, 130000000);
}

/* Restarted after it lost its settings, each panel has those that were asked for last, shows no
 * noise, and then the frame. */
static void a_panel_restarts_as_it_was(void)
{
    for (const struct etch_panel_type *t = etch_panel_types; t->name != NULL; t++) {
        const bool dims = etch_panel_driver(t->name)->controller->brightness != 0;

        for (uint8_t turn = 0; turn < 4; turn++) {
            if (!open_port(t->name, (uint8_t)(turn ^ 1)))
                return;
            CHECK_EQ(etch_lcd_turn(&port.lcd, turn), 0);
            port.turn = turn;
            CHECK_EQ(panel_frame(&port, 1, 16, 2), 0);
            CHECK_EQ(etch_lcd_invert(&port.lcd, turn == 2), 0);
            CHECK_EQ(etch_lcd_show(&port.lcd, turn != 3), 0);
            CHECK_EQ(etch_lcd_brightness(&port.lcd, 100), dims ? 0 : ETCH_EINVAL);
            CHECK_EQ(etch_lcd_sleep(&port.lcd, turn == 1), 0);
            brown_out();
            CHECK_EQ(etch_lcd_restart(&port.lcd), 0);
            CHECK_EQ(port.panel.inverted, (turn == 2) != etch_panel_driver(t->name)->inverted);
            CHECK_EQ(corner(), turn == 2 ? 0xFFFFFF : 0);
            CHECK(port.panel.asleep == (turn == 1 || (turn == 3 && port.panel.asleep)));
            CHECK_EQ(port.panel.brightness,
                     !dims ? 0 : 100 >> etch_panel_driver(t->name)->controller->brightness_shift);
            CHECK_EQ(etch_lcd_invert(&port.lcd, false), 0);
            CHECK_EQ(etch_lcd_show(&port.lcd, true), 0);
            CHECK_EQ(etch_lcd_sleep(&port.lcd, false), 0);
            CHECK_EQ(panel_frame(&port, 2, 16, 2), 0);
            panel_check(&port, 2);
            etch_panel_port_close(&port);
        }
    }
}

/* Faults while it restarts are told; the next try succeeds. */
static void restarting_reports_faults(void)
{
    for (uint32_t k = 1; k < 40; k += 3) {
        if (!open_port("ili9488", 1))
            return;
        port.bus.fault = k % 2 != 0 ? ETCH_PANEL_FAILS : ETCH_PANEL_COMMAND_FAILS;
        port.bus.fault_at = k;
        CHECK_EQ(etch_lcd_restart(&port.lcd), ETCH_PANEL_FAULT_STATUS);
        CHECK(!port.bus.taken && !etch_transfer_runs(&port.bus.transfer));
        CHECK_EQ(etch_lcd_restart(&port.lcd), 0);
        CHECK_EQ(panel_frame(&port, 3, 40, 2), 0);
        panel_check(&port, 3);
        etch_panel_port_close(&port);
    }
}

void suite_panel_set(void)
{
    RUN(settings_work);
    RUN(off_and_asleep_are_apart);
    RUN(a_panel_restarts_as_it_was);
    RUN(restarting_reports_faults);
}
