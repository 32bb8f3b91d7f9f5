/* ports/freertos/freertos_monitor.h: hal/monitor.h on FreeRTOS. Inside is a critical section, which
 * keeps out interrupts up to configMAX_SYSCALL_INTERRUPT_PRIORITY; waiting is sleeping on the
 * task's notification.
 *
 *      static struct etch_freertos_monitor m;
 *      etch_freertos_monitor_open(&m);          .. &m.monitor for hal/guarded.h and hal/workers.h
 *
 *      void DMA_IRQHandler(void) { .. etch_guarded_done(&transfer, number, 0); }
 *
 * Interrupts that use it have at most that priority. Needs configUSE_TASK_NOTIFICATIONS, and
 * xPortIsInsideInterrupt of the kernel's port. Tested with kernel V11 on Cortex-M3.
 */
#ifndef ETCH_PORTS_FREERTOS_MONITOR_H
#define ETCH_PORTS_FREERTOS_MONITOR_H

#include "FreeRTOS.h"
#include "task.h"

#include "../../hal/monitor.h"

/* Tasks that may wait at the same time: workers, and one for a transfer. */
#ifndef ETCH_FREERTOS_MOST_WAITING
#define ETCH_FREERTOS_MOST_WAITING 8
#endif

/* Which of a task's notifications is used (configTASK_NOTIFICATION_ARRAY_ENTRIES of them). A task
 * may find one too many given when it comes back from etch. */
#ifndef ETCH_FREERTOS_NOTIFICATION
#define ETCH_FREERTOS_NOTIFICATION 0
#endif

/* Set up by open; then `monitor` is for hal, and the rest private. Must stay where it is. */
struct etch_freertos_monitor {
    struct etch_monitor monitor;
    TaskHandle_t waiting[ETCH_FREERTOS_MOST_WAITING];
    uint8_t waits;     /* how many */
    bool signalled;    /* they are woken when whoever is inside leaves */
    UBaseType_t saved; /* mask of an interrupt that is inside */
};

void etch_freertos_monitor_open(struct etch_freertos_monitor *m);

#endif
