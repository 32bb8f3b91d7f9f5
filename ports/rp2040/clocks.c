/* ports/rp2040/clocks.c: from the ring oscillator to 125 MHz by crystal and PLL. Called once by
 * board_open. Source: Raspberry Pi, RP2040 data sheet, 2.14 to 2.18. */
#include "rp2040.h"

#define XOSC_CTRL REGISTER(0x40024000)
#define XOSC_STATUS REGISTER(0x40024004)
#define XOSC_STARTUP REGISTER(0x4002400C)
#define PLL_CS REGISTER(0x40028000)
#define PLL_PWR REGISTER(0x40028004)
#define PLL_FBDIV REGISTER(0x40028008)
#define PLL_PRIM REGISTER(0x4002800C)
#define CLK_REF_CTRL REGISTER(0x40008030)
#define CLK_REF_SELECTED REGISTER(0x40008038)
#define CLK_SYS_CTRL REGISTER(0x4000803C)
#define CLK_SYS_SELECTED REGISTER(0x40008044)
#define CLK_PERI_CTRL REGISTER(0x40008048)
#define WATCHDOG_TICK REGISTER(0x4005802C)
#define RESETS_RESET REGISTER(0x4000C000)
#define RESETS_DONE REGISTER(0x4000C008)

void rp2040_unreset(uint32_t blocks)
{
    RESETS_RESET &= ~blocks;
    while ((~RESETS_DONE & blocks) != 0) {
    }
}

void rp2040_clocks_start(void)
{
    enum {
        RESET_PLL_SYS = 1 << 12
    };

    XOSC_STARTUP = 47; /* 1 ms in units of 256 periods of 12 MHz */
    XOSC_CTRL = 0xFABAA0;
    while ((XOSC_STATUS & UINT32_C(0x80000000)) == 0) {
    }
    CLK_REF_CTRL = 2; /* crystal */
    while ((CLK_REF_SELECTED & 4) == 0) {
    }
    CLK_SYS_CTRL = 0; /* reference, while the PLL is set up */
    while ((CLK_SYS_SELECTED & 1) == 0) {
    }
    WATCHDOG_TICK = 1 << 9 | 12; /* a microsecond for the timer */

    rp2040_unreset(RESET_PLL_SYS);
    PLL_CS = 1;
    PLL_FBDIV = 125; /* 12 MHz * 125 = 1500 MHz .. */
    PLL_PWR = 1 << 3 | 1 << 2;
    while ((PLL_CS & UINT32_C(0x80000000)) == 0) {
    }
    PLL_PRIM = UINT32_C(6) << 16 | UINT32_C(2) << 12; /* .. / 6 / 2 = 125 MHz */
    PLL_PWR = 1 << 2;
    CLK_SYS_CTRL = 1; /* PLL */
    while ((CLK_SYS_SELECTED & 2) == 0) {
    }
    CLK_PERI_CTRL = 1 << 11; /* SPI and UART by the system clock */
}
