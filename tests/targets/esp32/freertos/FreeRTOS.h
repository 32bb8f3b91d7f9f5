/* tests/targets/esp32: as much of FreeRTOS as ports/esp32 uses, a tick of 10 ms. See spi_master.h.
 */
#ifndef TESTS_TARGETS_ESP32_FREERTOS_H
#define TESTS_TARGETS_ESP32_FREERTOS_H

#include <stdint.h>

#define portMAX_DELAY UINT32_MAX
#define pdMS_TO_TICKS(ms) ((uint32_t)(ms) / 10)

#endif
