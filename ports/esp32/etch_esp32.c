/* ports/esp32/etch_esp32.c: a bus of hal/bus.h on ESP-IDF's spi_master. Called by ports/spi_lcd in
 * the task that draws. See etch_esp32.h. Source: Espressif, ESP-IDF Programming Guide, SPI Master
 * Driver. */
#include "etch_esp32.h"

#include <string.h>

#include "driver/gpio.h"
#include "freertos/FreeRTOS.h"
#include "freertos/task.h"

enum {
    LIMIT_MS = 500 /* for one piece; a driver that stalls longer cannot be stopped */
};

static struct etch_esp32_bus *bus_of(const struct etch_bus *bus)
{
    return (struct etch_esp32_bus *)bus->context;
}

static int status_of(esp_err_t error)
{
    return error == ESP_OK ? 0 : error > 0 ? -error : error;
}

/* The select line is not the driver's, which would raise it between a command and its parameters.
 */
static int begin(const struct etch_bus *bus)
{
    const int status = status_of(spi_device_acquire_bus(bus_of(bus)->device, portMAX_DELAY));

    if (status == 0)
        (void)gpio_set_level((gpio_num_t)bus_of(bus)->select, 0);
    return status;
}

static void end(const struct etch_bus *bus)
{
    (void)gpio_set_level((gpio_num_t)bus_of(bus)->select, 1);
    spi_device_release_bus(bus_of(bus)->device);
}

static void prepare(spi_transaction_t *job, const uint8_t *bytes, uint32_t n)
{
    memset(job, 0, sizeof *job);
    job->tx_buffer = bytes;
    job->length = (size_t)n * 8;
}

static int command(const struct etch_bus *bus, const uint8_t *bytes, uint16_t n)
{
    struct etch_esp32_bus *b = bus_of(bus);

    (void)gpio_set_level((gpio_num_t)b->data, 0);
    prepare(&b->job[0], bytes, n);
    return status_of(spi_device_polling_transmit(b->device, &b->job[0]));
}

/* Waits until the oldest job is out. */
static int collect(struct etch_esp32_bus *b)
{
    spi_transaction_t *done;
    const esp_err_t error = spi_device_get_trans_result(b->device, &done, pdMS_TO_TICKS(LIMIT_MS));

    b->running--;
    return status_of(error);
}

/* A piece stays as it is until the second call of next after it, so that one is sent while the next
 * is made. The last goes on when this returns: where a strip is one piece, all of it. */
static int data(const struct etch_bus *bus, struct etch_pieces *pieces)
{
    struct etch_esp32_bus *b = bus_of(bus);
    const uint8_t *bytes;
    uint8_t turn = 0;
    int status = 0;
    uint32_t n;

    (void)gpio_set_level((gpio_num_t)b->data, 1);
    while (status == 0 && (bytes = pieces->next(pieces, &n)) != NULL) {
        prepare(&b->job[turn], bytes, n);
        if (b->running != 0)
            status = collect(b);
        if (status == 0)
            status = status_of(spi_device_queue_trans(b->device, &b->job[turn], portMAX_DELAY));
        b->running = (uint8_t)(b->running + (status == 0));
        turn ^= 1;
    }
    if (status != 0 && b->running != 0)
        (void)collect(b);
    return status;
}

static int wait(const struct etch_bus *bus)
{
    struct etch_esp32_bus *b = bus_of(bus);

    return b->running != 0 ? collect(b) : 0;
}

static void reset(const struct etch_bus *bus, bool active)
{
    if (bus_of(bus)->reset >= 0)
        (void)gpio_set_level((gpio_num_t)bus_of(bus)->reset, active ? 0 : 1);
}

static void delay(const struct etch_bus *bus, uint8_t ms)
{
    (void)bus;
    vTaskDelay(pdMS_TO_TICKS(ms) + 1); /* a tick may be nearly over */
}

static void make_output(int pin)
{
    (void)gpio_set_level((gpio_num_t)pin, 1);
    (void)gpio_set_direction((gpio_num_t)pin, GPIO_MODE_OUTPUT);
}

int etch_esp32_bus_open(struct etch_esp32_bus *b, struct etch_esp32_setup setup)
{
    const spi_device_interface_config_t device = {
        .mode = 0, .clock_speed_hz = setup.hz, .spics_io_num = -1, .queue_size = 2};
    const struct etch_bus bus = {.context = b,
                                 .limit = setup.limit,
                                 .begin = begin,
                                 .end = end,
                                 .command = command,
                                 .data = data,
                                 .wait = wait,
                                 .reset = reset,
                                 .delay = delay};

    memset(b, 0, sizeof *b);
    b->bus = bus;
    b->select = setup.select;
    b->data = setup.data;
    b->reset = setup.reset;
    make_output(setup.select);
    make_output(setup.data);
    if (setup.reset >= 0)
        make_output(setup.reset);
    return status_of(spi_bus_add_device(setup.host, &device, &b->device));
}
