/* tests/targets/esp32: pins, as in ESP-IDF. See spi_master.h. */
#ifndef TESTS_TARGETS_ESP32_GPIO_H
#define TESTS_TARGETS_ESP32_GPIO_H

#include <stdint.h>

typedef int gpio_num_t;
typedef enum {
    GPIO_MODE_OUTPUT = 2
} gpio_mode_t;

int gpio_set_direction(gpio_num_t pin, gpio_mode_t mode);
int gpio_set_level(gpio_num_t pin, uint32_t level);

#endif
