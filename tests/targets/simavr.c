/* tests/targets: simavr MCU ELF: runs a firmware until it sleeps for good, and writes its bytes on
 * SPI and what it does to port B in the form that glass.c reads; what it says goes to standard
 * error. */
#include <stdio.h>
#include <string.h>

#include <simavr/avr_ioport.h>
#include <simavr/avr_spi.h>
#include <simavr/avr_uart.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>

enum {
    CLOCK = 16000000,
    SECONDS = 60
};

static void on_spi(struct avr_irq_t *irq, uint32_t value, void *context)
{
    (void)irq;
    (void)context;
    printf("addr 0x4e value 0x%x\n", (unsigned)value & 0xFF);
}

static void on_port(struct avr_irq_t *irq, uint32_t value, void *context)
{
    (void)irq;
    (void)context;
    printf("addr 0x25 value 0x%x\n", (unsigned)value & 0xFF);
}

static void on_uart(struct avr_irq_t *irq, uint32_t value, void *context)
{
    (void)irq;
    (void)context;
    fputc((int)value, stderr);
}

int main(int argc, char **argv)
{
    elf_firmware_t firmware;
    avr_t *avr = argc == 3 ? avr_make_mcu_by_name(argv[1]) : NULL;
    uint32_t flags = 0;
    int state = cpu_Running;

    memset(&firmware, 0, sizeof firmware);
    if (avr == NULL || elf_read_firmware(argv[2], &firmware) != 0) {
        fputs("usage: simavr MCU ELF\n", stderr);
        return 2;
    }
    avr_init(avr);
    avr->frequency = CLOCK;
    avr_load_firmware(avr, &firmware);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_SPI_GETIRQ(0), SPI_IRQ_OUTPUT), on_spi,
                            NULL);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ('B'), IOPORT_IRQ_PIN_ALL),
                            on_port, NULL);
    avr_ioctl(avr, AVR_IOCTL_UART_GET_FLAGS('0'), &flags);
    flags &= ~(uint32_t)AVR_UART_FLAG_STDIO;
    avr_ioctl(avr, AVR_IOCTL_UART_SET_FLAGS('0'), &flags);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUTPUT),
                            on_uart, NULL);
    while (state != cpu_Done && state != cpu_Crashed &&
           avr->cycle < (avr_cycle_count_t)CLOCK * SECONDS)
        state = avr_run(avr);
    fprintf(stderr, "%llu cycles\n", (unsigned long long)avr->cycle);
    return state == cpu_Done ? 0 : 1;
}
