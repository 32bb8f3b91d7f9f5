/* ports/riscv_virt: QEMU's RISC-V machine "virt", 32 or 64 bits, with the PCI card bochs-display,
 * which shows RGB565 from its own linear memory.
 * Source: QEMU, docs/specs/standard-vga and the PCI local bus specification. */
#include "../board.h"
#include "../framebuffer/framebuffer.h"

#define REGISTER32(address) (*(volatile uint32_t *)(uintptr_t)(address))
#define REGISTER16(address) (*(volatile uint16_t *)(uintptr_t)(address))
#define PCI_CONFIGURATION UINT32_C(0x30000000) /* 32 KB a device */
#define PCI_MEMORY UINT32_C(0x40000000)
#define CARD_REGISTERS (PCI_MEMORY + UINT32_C(0x2000000))
#define VBE(index) REGISTER16(CARD_REGISTERS + 0x500 + 2 * (index))
enum {
    WIDTH = 320,
    HEIGHT = 240,
    BOCHS_DISPLAY = 0x11111234,
    XRES = 1,
    YRES = 2,
    BPP = 3,
    ENABLE = 4,
    VIRTUAL_WIDTH = 6,
    ON_LINEAR = 0x41
};

static uint32_t find_card(void)
{
    for (uint32_t device = 0; device < 32; device++)
        if (REGISTER32(PCI_CONFIGURATION + (device << 15)) == BOCHS_DISPLAY)
            return PCI_CONFIGURATION + (device << 15);
    return 0;
}

const struct etch_display *board_open(void)
{
    static struct etch_framebuffer linear = {NULL, WIDTH};
    static const struct etch_display display = {.context = &linear,
                                                .width = WIDTH,
                                                .height = HEIGHT,
                                                .format = ETCH_FORMAT_RGB565,
                                                .flush = etch_framebuffer_flush,
                                                .wait = etch_framebuffer_wait,
                                                .memory = etch_framebuffer_memory};
    const uint32_t card = find_card();

    if (card == 0)
        return NULL;
    REGISTER32(card + 0x10) = PCI_MEMORY;     /* BAR 0: pixels */
    REGISTER32(card + 0x18) = CARD_REGISTERS; /* BAR 2 */
    REGISTER16(card + 4) = REGISTER16(card + 4) | 2;
    VBE(ENABLE) = 0;
    VBE(XRES) = WIDTH;
    VBE(YRES) = HEIGHT;
    VBE(BPP) = 16;
    VBE(VIRTUAL_WIDTH) = WIDTH;
    VBE(ENABLE) = ON_LINEAR;
    linear.pixels = (uint16_t *)(uintptr_t)PCI_MEMORY;
    return &display;
}

/* Semihosting: three instructions that a debugger knows by their looks. */
void board_print(const char *text)
{
    register uintptr_t a0 __asm__("a0") = 4; /* SYS_WRITE0 */
    register const void *a1 __asm__("a1") = text;

    __asm__ volatile(".balign 16\n"
                     ".option push\n"
                     ".option norvc\n"
                     "slli zero, zero, 0x1f\n"
                     "ebreak\n"
                     "srai zero, zero, 7\n"
                     ".option pop\n"
                     : "+r"(a0)
                     : "r"(a1)
                     : "memory");
}

void board_exit(int status)
{
    (void)status; /* goes on to show the screen */
    for (;;)
        __asm__ volatile("wfi");
}
