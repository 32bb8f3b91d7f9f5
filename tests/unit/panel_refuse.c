/* tests/unit: the simulated panel refuses what data sheets forbid: drivers with one planted fault
 * each, as bytes; the sentence says what is wrong. And tables of real drivers with one fault. */
#include "panel_parts.h"

void suite_panel_refuse(void);

static struct etch_panel panel;

/* Plays a script: `<` select, `>` deselect, `R` a reset of 10 ms and 130 ms more, `W` 130 ms, `.`
 * 1 ms; `:XX` a command byte; `XX` data. */
static void play(const char *script)
{
    while (*script != 0) {
        const char c = *script++;
        const bool command = c == ':';

        if (c == '<' || c == '>') {
            etch_panel_select(&panel, c == '<');
        } else if (c == 'R') {
            etch_panel_reset(&panel, true);
            etch_panel_elapse(&panel, 10000000);
            etch_panel_reset(&panel, false);
            etch_panel_elapse(&panel, 130000000);
        } else if (c == 'W') {
            etch_panel_elapse(&panel, 130000000);
        } else if (c == '.') {
            etch_panel_elapse(&panel, 1000000);
        } else if (c != ' ') {
            const char *digits = command ? script : script - 1;
            unsigned byte = 0;

            for (int i = 0; i < 2; i++)
                byte = byte * 16 +
                       (unsigned)(digits[i] <= '9' ? digits[i] - '0' : digits[i] - 'A' + 10);
            script = digits + 2;
            if (command)
                etch_panel_command(&panel, (uint8_t)byte);
            else
                etch_panel_data(&panel, (uint8_t)byte);
        }
    }
}

static bool contains(const char *text, const char *part)
{
    for (; *text != 0; text++) {
        const char *a = text, *b = part;

        while (*b != 0 && *a == *b)
            a++, b++;
        if (*b == 0)
            return true;
    }
    return *part == 0;
}

/* Plays `script` on a panel; the error must contain `words`, or be none if `words` is empty. */
static void expect(const char *name, const char *script, const char *words)
{
    if (!CHECK(etch_panel_open(&panel, etch_panel_find(name))))
        return;
    play(script);
    if (!CHECK(words[0] == 0 ? panel.error[0] == 0 : contains(panel.error, words))) {
        test_print(script);
        test_print(panel.error);
    }
    etch_panel_close(&panel);
}

static void legal_sequences_pass(void)
{
    expect("ili9341", "R<:11>W<:3A 55 :29 :2A 00 00 00 00 :2B 00 00 00 01 :2C 12 34 56 78>", "");
    expect("ili9341", "R<:3A 66 :36 20 :2A 00 00 01 3F :2B 00 00 00 EF :2C 11 22 33>", "");
    expect("ssd1351", "R<:FD B1 :A2 00 :A0 74 :15 00 7F :75 00 7F :5C 01 02>", "");
    expect("ssd1306", "R<:20:00 :21:00:7F :22:00:07 FF FF>", "");
    expect("ssd1306", "R<:B7 :05 :12 FF FF>", "");
    expect("ssd0323", "R<:15:00:3F :75:00:4F 12 34>", "");
    expect("gc9a01", "R<:FE :EF :EB 14 :66 01 02 03 04 05 06 07 08 09 0A>", "");
}

static void bad_sequences_are_refused(void)
{
    expect("ili9341", "R<12>", "before any command");
    expect("ili9341", "R :29", "without select");
    expect("ili9341", "R< <", "selected twice");
    expect("ili9341", "<:29>", "during reset");
    expect("ssd1306", "R<:20:00 FF>", "pixels before a window");
    expect("ssd1306", "R<:20:00 :21:00:7F :22:00 FF>", "22 has 2 parameters and got 1");
    expect("ssd1306", "R<:21:00:7F :22:00:07 FF>", "addressing by pages");
    expect("ssd1306", "R<:20:00 :B3", "B3 is for addressing by pages");
}

/* A driver that addresses by pages, as many for this controller do: column 0x25 of page 7, then
 * round to its first column; with the first line moved to 8 that page is two pages up. */
static void pages_are_addressed(void)
{
    if (!CHECK(etch_panel_open(&panel, etch_panel_find("ssd1306"))))
        return;
    play("R<:8D:14 :A1 :C8 :AF :B7 :05 :12");
    for (int i = 0; i < 0x80 - 0x25 + 1; i++)
        play(i == 0 ? "81" : "00");
    play(">");
    CHECK_EQ(etch_panel_glass(&panel, 0x25, 56), 0xFFFFFF);
    CHECK_EQ(etch_panel_glass(&panel, 0x25, 57), 0);
    CHECK_EQ(etch_panel_glass(&panel, 0x25, 63), 0xFFFFFF);
    CHECK_EQ(etch_panel_glass(&panel, 0x26, 56), 0);
    CHECK_EQ(etch_panel_glass(&panel, 0, 57), 0);
    CHECK(panel.x == 1 && panel.y == 7);
    play("<:48>");
    CHECK_EQ(etch_panel_glass(&panel, 0x25, 48), 0xFFFFFF);
    CHECK(panel.error[0] == 0);
    etch_panel_close(&panel);
}

static void wrong_counts_are_refused(void)
{
    expect("ili9341", "R<:2A 00 00 00 :2B", "2A has 4 parameters and got 3");
    expect("ili9341", "R<:2A 00 00 00 00 00", "2A has 4 parameters and got more");
    expect("ili9341", "R<:36>", "36 has 1 parameters and got 0");
    expect("ili9341", "R<:29 01", "29 has 0 parameters and got more");
    expect("ili9341", "R<:42", "no command 42");
    expect("ssd1351", "R<:15 00 :75", "15 has 2 parameters and got 1");
    expect("ssd0323", "R<:81:40:99", "no command 99");
    expect("ili9341", "R<:3A 55 :2A 00 00 00 01 :2B 00 00 00 01 :2C 12 34 56>", "cut off");
}

static void bad_windows_are_refused(void)
{
    expect("ili9341", "R<:3A 55 :2A 00 00 00 F0 :2B 00 00 00 00 :2C", "outside a memory of 240");
    expect("ili9341", "R<:3A 55 :2A 00 05 00 04 :2B 00 00 00 00 :2C", "upside down");
    expect("ili9341", "R<:36 20 :2A 00 00 01 40 :2B 00 00 00 00 :2C", "outside a memory of 320");
    expect("st7735-red", "R<:2A 00 02 00 81 :2B 00 01 00 A0 :2C", "outside a memory of 128");
    expect("ssd1306", "R<:20:00 :22:00:08", "outside a memory of 128 x 8");
    expect("ssd0323", "R<:15:00:40", "outside a memory of 64 x 80");
    expect("ili9341", "R<:3A 55 :2A 00 00 00 00 :2B 00 00 00 00 :2C 12 34 56 78>",
           "more pixels than the window");
    expect("ssd0323", "R<:15:00:00 :75:00:00 12 34>", "more pixels than the window");
}

static void bad_formats_are_refused(void)
{
    expect("ili9488", "R<:3A 55", "no pixel format 55");
    expect("ili9341", "R<:3A 53", "no pixel format 53");
    expect("ssd1351", "R<:A0 34 :15 00 00 :75 00 00 :5C 01 02", "16 bits");
    expect("ssd0323", "R<:81:80", "7 bits");
    expect("ssd1351", "R<:C7 10", "4 bits");
}

static void haste_is_refused(void)
{
    expect("ili9341", "R<:11.:29", "too soon");
    expect("ili9341", "R<:01...:29", "too soon");
    expect("ili9341", "R<:01......:11", "woken up too soon");
    expect("ili9341", "R<:11>W<:10>......<:11", "woken up too soon");
    expect("ssd1351", "R<:B3 F1", "B3 is locked");
    expect("ssd1351", "R<:FD 12 :A2 00", "A2 is locked");
}

/* A frame by a driver with one field changed: the error contains `words`. */
static void open_faulty(const char *name, const struct etch_lcd_panel *driver, const char *words)
{
    static struct etch_panel_port port;
    const struct etch_lcd_setup setup = {.scratch = port.scratch,
                                         .scratch_size = sizeof port.scratch};

    if (!CHECK(etch_panel_open(&port.panel, etch_panel_find(name))))
        return;
    etch_panel_bus_open(&port.bus, &port.panel);
    port.turn = 0;
    CHECK_EQ(etch_lcd_open(&port.lcd, driver, &port.bus.bus, setup), 0);
    CHECK_EQ(panel_frame(&port, 1, 16, 2), 0);
    if (!CHECK(contains(port.panel.error, words) && port.panel.error[0] != 0))
        test_print(port.panel.error);
    etch_panel_close(&port.panel);
}

/* Whole drivers: an offset too large, the wrong format for the controller, a missing delay, a
 * table with too few parameters, a window command that swaps its words. */
static void faulty_drivers_are_refused(void)
{
    static const uint8_t hasty[] = {0, 0x11, 1, 0x3A, 0x55, ETCH_LCD_END};
    static const uint8_t rgb565[] = {ETCH_LCD_DELAY, 0x11, 120, 1, 0x3A, 0x55, ETCH_LCD_END};
    static const uint8_t short_table[] = {1, 0x2A, 0x00, ETCH_LCD_END};
    struct etch_lcd_controller dcs = etch_lcd_dcs;
    struct etch_lcd_panel p = etch_st7735_80x160;

    p.memory_height = 180;
    open_faulty("st7735-80x160", &p, "outside a memory");
    p = etch_ili9341;
    p.init = hasty;
    open_faulty("ili9341", &p, "too soon");
    p.init = short_table;
    open_faulty("ili9341", &p, "2A has 4 parameters and got 1");
    p = etch_ili9488;
    p.init = rgb565;
    open_faulty("ili9488", &p, "no pixel format");
    p = etch_ili9341;
    p.controller = &dcs;
    dcs.address_bytes = 1;
    open_faulty("ili9341", &p, "2A has 4 parameters and got 2");
}

void suite_panel_refuse(void)
{
    RUN(legal_sequences_pass);
    RUN(bad_sequences_are_refused);
    RUN(pages_are_addressed);
    RUN(wrong_counts_are_refused);
    RUN(bad_windows_are_refused);
    RUN(bad_formats_are_refused);
    RUN(haste_is_refused);
    RUN(faulty_drivers_are_refused);
}
