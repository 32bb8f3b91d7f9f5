/* ports/cortex_m/start.c: from reset to main on any Cortex-M. Boards with
 * such a core link it; the symbols link_* are those of linker/cortex_m.ld. */
#include "../board.h"

extern uint32_t link_stack_top, link_data_start, link_data_end, link_data_load;
extern uint32_t link_bss_start, link_bss_end;

int main(void);
void reset(void);

static void stop(void)
{
    for (;;) {
    }
}

void reset(void)
{
    const uint32_t *from = &link_data_load;

    for (uint32_t *p = &link_data_start; p < &link_data_end; p++)
        *p = *from++;
    for (uint32_t *p = &link_bss_start; p < &link_bss_end; p++)
        *p = 0;
    board_exit(main());
    stop();
}

/* The sixteen vectors of the core. A board with interrupts puts its own into the section
 * .vectors.interrupts, which the linker script places right behind. */
__attribute__((section(".vectors"), used)) static const struct {
    uint32_t *stack;
    void (*handler[15])(void);
} vectors = {
    &link_stack_top,
    {reset, stop, stop, stop, stop, stop, NULL, NULL, NULL, NULL, stop, stop, NULL, stop, stop}};
