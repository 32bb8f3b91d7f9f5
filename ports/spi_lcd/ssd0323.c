/* ports/spi_lcd/ssd0323.c: SSD0323, OLED of 128 x 64 with 16 grey levels. Tables for lcd.c.
 * Values as TI's driver for the EK-LM3S6965 and u8g2 set them. A byte is two pixels of a row;
 * addresses always name the memory, and flipping the columns exchanges the pixels of a byte, too.
 */
#include "panels.h"

/* clang-format off */
static const uint8_t init[] = {
    0, 0xAE,       /* off while the supply is set */
    1, 0xA1, 0x00, /* the first line is 0 */
    1, 0xA8, 0x3F, /* 64 lines */
    1, 0xAD, 0x02, /* external supply */
    1, 0xB1, 0x22, /* phases of 2 clocks */
    1, 0xB2, 0x46, /* 70 clocks a line */
    1, 0xB3, 0x41, /* clock, divided by 2 */
    1, 0xBC, 0x0D, /* pre-charge voltage, */
    1, 0xBE, 0x0D, /* VCOMH */
    1, 0xBF, 0x0D, /* and low voltage */
    8, 0xB8, 0x01, 0x11, 0x22, 0x32, 0x43, 0x54, 0x65, 0x76,/* currents of the 16 levels */
    1, 0x81, 0x40, /* contrast */
    0, 0x86,       /* whole current range */
    0, 0xA4,       /* show the memory */
    ETCH_LCD_END,
};
/* clang-format on */

/* The controller has 80 lines, the glass 64, on lines 12 to 75; which memory row is at its top (A2)
 * depends on where the scan begins. As u8g2 has it for both directions. */
static int turn(struct etch_lcd *lcd)
{
    const bool flipped = (lcd->orientation & ETCH_LCD_FLIP_ROWS) != 0;
    const uint8_t offset = flipped ? 80 - 12 : 12 + 64;
    int status = etch_lcd_orient(lcd);

    return status < 0 ? status : etch_lcd_command(lcd, 0xA2, &offset, 1);
}

static const struct etch_lcd_controller ssd0323 = {
    .column = 0x15,
    .row = 0x75,
    .address_bytes = 1,
    .column_pixels = 2,
    .row_pixels = 1,
    .parameters_are_commands = true,
    .nop = 0xE3,
    .orient = 0xA0,
    .base = 0x52, /* odd and even lines apart, scanned from the last; left pixel in the high bits */
    .flip_columns = 0x03,
    .flip_rows = 0x10,
    .swap = 0x04,
    .sleep = 0xAE,
    .wake = 0xAF,
    .off = 0xAE,
    .on = 0xAF,
    .straight = 0xA4,
    .inverted = 0xA7,
    .brightness = 0x81,
    .brightness_shift = 1, /* 7 bits */
    .turn = turn,
    .convert = etch_lcd_gray4,
};

const struct etch_lcd_panel etch_ssd0323 = {
    .controller = &ssd0323,
    .init = init,
    .width = 128,
    .height = 64,
    .memory_width = 128,
    .memory_height = 80,
    .align_x = 2,
};
