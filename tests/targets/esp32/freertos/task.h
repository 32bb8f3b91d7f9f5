/* tests/targets/esp32: see FreeRTOS.h. */
#ifndef TESTS_TARGETS_ESP32_TASK_H
#define TESTS_TARGETS_ESP32_TASK_H

#include <stdint.h>

void vTaskDelay(uint32_t ticks);

#endif
