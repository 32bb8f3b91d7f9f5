/* tests/targets: simavr MCU ELF: runs a firmware until it sleeps for good, and writes its bytes on
 * SPI and what it does to port B in the form that glass.c reads; what it says, and what it cost,
 * goes to standard error. WAITING in the environment has pairs of addresses: functions that wait
 * for SPI, for which simavr takes 100 us a byte, whatever its clock. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <simavr/avr_ioport.h>
#include <simavr/avr_spi.h>
#include <simavr/avr_uart.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>

enum {
    CLOCK = 16000000,
    SECONDS = 120,
    RANGES = 8
};

static unsigned long bytes;
static unsigned long ranges[RANGES][2];

static void on_spi(struct avr_irq_t *irq, uint32_t value, void *context)
{
    (void)irq;
    (void)context;
    bytes++;
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

static void read_ranges(const char *text)
{
    for (int i = 0; text != NULL && i < RANGES; i++)
        for (int k = 0; k < 2; k++) {
            char *end;

            ranges[i][k] = strtoul(text, &end, 10);
            if (end == text)
                return;
            text = end;
        }
}

static bool waits(unsigned long pc)
{
    for (int i = 0; i < RANGES; i++)
        if (pc >= ranges[i][0] && pc < ranges[i][1])
            return true;
    return false;
}

int main(int argc, char **argv)
{
    elf_firmware_t firmware;
    avr_t *avr = argc == 3 ? avr_make_mcu_by_name(argv[1]) : NULL;
    uint32_t flags = 0;
    int state = cpu_Running;
    unsigned long long instructions = 0, waiting = 0;

    memset(&firmware, 0, sizeof firmware);
    if (avr == NULL || elf_read_firmware(argv[2], &firmware) != 0) {
        fputs("usage: simavr MCU ELF\n", stderr);
        return 2;
    }
    read_ranges(getenv("WAITING"));
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
           avr->cycle < (avr_cycle_count_t)CLOCK * SECONDS) {
        const avr_cycle_count_t before = avr->cycle;
        const bool waited = waits(avr->pc);

        state = avr_run(avr);
        instructions += !waited;
        waiting += waited ? avr->cycle - before : 0;
    }
    fprintf(stderr, "%llu instructions, %llu cycles of waiting, %llu cycles, %lu bytes\n",
            instructions, waiting, (unsigned long long)avr->cycle, bytes);
    return state == cpu_Done ? 0 : 1;
}
