/* tests/targets/esp32: the component for ESP32 (ports/esp32) on the host, above a driver that only
 * pretends: it writes bytes and pins in the form that glass.c reads, and ends the program where the
 * driver would refuse. A queued transaction is read as late as may be, when its result is fetched,
 * so that memory which was given up too early shows. */
#include "ports/esp32/etch_esp32.h"

#include <stdio.h>
#include <stdlib.h>

#include "driver/gpio.h"
#include "freertos/FreeRTOS.h"
#include "freertos/task.h"
#include "ports/board.h"
#include "ports/spi_lcd/panels.h"

enum {
    PIN_CS = 5,
    PIN_DATA = 16,
    PIN_RESET = 17,
    LIMIT = 320 * 6 * 2 /* three pieces of a strip, not all of one size */
};

static spi_transaction_t *queued;
static uint32_t level[3] = {1, 1, 1}; /* D/C, CS, RESET */
static bool held;

static void demand(bool ok, const char *what)
{
    if (ok)
        return;
    fprintf(stderr, "FAIL: %s\n", what);
    exit(1);
}

static void show_pins(void)
{
    printf("addr 0x2 value 0x%x\n", (unsigned)(level[0] | level[1] << 1 | level[2] << 2));
}

static void send(const spi_transaction_t *job)
{
    const uint8_t *bytes = (const uint8_t *)job->tx_buffer;

    demand(job->length % 8 == 0 && job->length / 8 <= LIMIT, "more than the bus takes at once");
    for (size_t i = 0; i < job->length / 8; i++)
        printf("addr 0x1 value 0x%x\n", bytes[i]);
}

/* ---- what the component calls ------------------------------------------------------------------
 */

esp_err_t spi_bus_add_device(spi_host_device_t host, const spi_device_interface_config_t *config,
                             spi_device_handle_t *handle)
{
    demand(host == SPI2_HOST && config->mode == 0 && config->spics_io_num == -1, "settings");
    *handle = NULL;
    return ESP_OK;
}

esp_err_t spi_device_acquire_bus(spi_device_handle_t device, uint32_t wait)
{
    (void)device;
    demand(!held && wait == portMAX_DELAY, "acquired twice");
    held = true;
    return ESP_OK;
}

void spi_device_release_bus(spi_device_handle_t device)
{
    (void)device;
    demand(held && queued == NULL, "released while a transaction runs");
    held = false;
}

esp_err_t spi_device_polling_transmit(spi_device_handle_t handle, spi_transaction_t *job)
{
    (void)handle;
    demand(held && queued == NULL, "polling while a transaction is queued");
    send(job);
    return ESP_OK;
}

esp_err_t spi_device_queue_trans(spi_device_handle_t handle, spi_transaction_t *job, uint32_t wait)
{
    (void)handle;
    demand(held && queued == NULL && wait == portMAX_DELAY, "queued twice");
    queued = job;
    return ESP_OK;
}

esp_err_t spi_device_get_trans_result(spi_device_handle_t handle, spi_transaction_t **job,
                                      uint32_t wait)
{
    (void)handle;
    (void)wait;
    demand(queued != NULL, "no transaction to wait for");
    send(queued);
    *job = queued;
    queued = NULL;
    return ESP_OK;
}

int gpio_set_direction(gpio_num_t pin, gpio_mode_t mode)
{
    return (pin == PIN_CS || pin == PIN_DATA || pin == PIN_RESET) && mode == GPIO_MODE_OUTPUT
               ? ESP_OK
               : -1;
}

int gpio_set_level(gpio_num_t pin, uint32_t value)
{
    demand(queued == NULL, "a pin changes while a transaction runs");
    demand(pin != PIN_CS || held || value == 1, "selected without the bus");
    level[pin == PIN_DATA ? 0 : pin == PIN_CS ? 1 : 2] = value;
    show_pins();
    return ESP_OK;
}

void vTaskDelay(uint32_t ticks)
{
    demand(ticks != 0, "no delay");
}

/* ---- the board ---------------------------------------------------------------------------------
 */

const struct etch_display *board_open(void)
{
    static struct etch_esp32_bus bus;
    static struct etch_lcd lcd;
    const struct etch_esp32_setup setup = {.host = SPI2_HOST,
                                           .limit = LIMIT,
                                           .hz = 40000000,
                                           .select = PIN_CS,
                                           .data = PIN_DATA,
                                           .reset = PIN_RESET};

    return etch_esp32_bus_open(&bus, setup) == 0 &&
                   etch_lcd_open(&lcd, &etch_ili9341, &bus.bus,
                                 (struct etch_lcd_setup){.turn = 1}) == 0
               ? &lcd.display
               : NULL;
}

void board_print(const char *text)
{
    fputs(text, stderr);
}

void board_exit(int status)
{
    (void)status; /* main returns it */
}
