/* tests/targets/esp32: as much of ESP-IDF's driver as ports/esp32 uses, with the names and types of
 * its header, for board.c to take the place of the driver. */
#ifndef TESTS_TARGETS_ESP32_SPI_MASTER_H
#define TESTS_TARGETS_ESP32_SPI_MASTER_H

#include <stddef.h>
#include <stdint.h>

typedef int esp_err_t;
enum {
    ESP_OK = 0,
    ESP_ERR_INVALID_STATE = 0x103,
    ESP_ERR_TIMEOUT = 0x107
};
typedef enum {
    SPI1_HOST,
    SPI2_HOST,
    SPI3_HOST
} spi_host_device_t;
typedef struct spi_device_t *spi_device_handle_t;

typedef struct {
    uint8_t mode;
    int clock_speed_hz, spics_io_num, queue_size;
} spi_device_interface_config_t;

typedef struct spi_transaction_t {
    uint32_t flags;
    size_t length; /* bits */
    const void *tx_buffer;
} spi_transaction_t;

esp_err_t spi_bus_add_device(spi_host_device_t host, const spi_device_interface_config_t *config,
                             spi_device_handle_t *handle);
esp_err_t spi_device_acquire_bus(spi_device_handle_t device, uint32_t wait);
void spi_device_release_bus(spi_device_handle_t device);
esp_err_t spi_device_polling_transmit(spi_device_handle_t handle, spi_transaction_t *job);
esp_err_t spi_device_queue_trans(spi_device_handle_t handle, spi_transaction_t *job, uint32_t wait);
esp_err_t spi_device_get_trans_result(spi_device_handle_t handle, spi_transaction_t **job,
                                      uint32_t wait);

#endif
