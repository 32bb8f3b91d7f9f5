/* ports/esp32/etch_esp32.h: panels on the SPI of an ESP32 (any of its family), by ESP-IDF's driver
 * spi_master, whose DMA sends a strip while the next is drawn.
 *
 *      spi_bus_initialize(SPI2_HOST, &pins, SPI_DMA_CH_AUTO);
 *      static struct etch_esp32_bus bus;
 *      static struct etch_lcd lcd;
 *      int status = etch_esp32_bus_open(&bus, (struct etch_esp32_setup){
 *          .host = SPI2_HOST, .limit = 320 * 16 * 2, .hz = 40000000,
 *          .select = 5, .data = 16, .reset = 17});
 *      status = etch_lcd_open(&lcd, &etch_ili9341, &bus.bus, (struct etch_lcd_setup){.turn = 1});
 *
 * Strips and scratch buffers are to lie in memory that DMA reaches: MALLOC_CAP_DMA, or a static
 * array marked DMA_ATTR; the driver copies others, which costs time and heap. */
#ifndef ETCH_PORTS_ESP32_H
#define ETCH_PORTS_ESP32_H

#include "driver/spi_master.h"
#include "../../hal/bus.h"

struct etch_esp32_setup {
    spi_host_device_t host; /* initialised by the application, which knows what else is on it */
    uint32_t limit; /* max_transfer_sz of the bus, in bytes; best at least that of a strip */
    int hz;
    int select, data, reset; /* GPIO numbers: CS, D/C, RESET; reset -1: not wired */
};

/* The caller's; stays valid as long as the panel is used. */
struct etch_esp32_bus {
    struct etch_bus bus; /* for etch_lcd_open */
    spi_device_handle_t device;
    spi_transaction_t job[2]; /* one runs, one is prepared */
    uint8_t running;          /* jobs that are queued: 0 or 1 between calls */
    int select, data, reset;
};

/* 0, or the negative of the esp_err_t of the driver. */
int etch_esp32_bus_open(struct etch_esp32_bus *bus, struct etch_esp32_setup setup);

#endif
