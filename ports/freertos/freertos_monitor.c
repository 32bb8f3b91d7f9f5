/* ports/freertos/freertos_monitor.c: a critical section and notifications. hal calls it through
 * struct etch_monitor, from tasks and interrupts. Tasks are notified by name, not through a
 * counting semaphore, whose count another task could take that begins to wait later. */
#include "freertos_monitor.h"

static struct etch_freertos_monitor *self(const struct etch_monitor *monitor)
{
    return monitor->context;
}

static void enter(const struct etch_monitor *monitor)
{
    if (xPortIsInsideInterrupt() != pdFALSE) {
        const UBaseType_t saved = taskENTER_CRITICAL_FROM_ISR();

        self(monitor)->saved = saved;
    } else {
        taskENTER_CRITICAL();
    }
}

/* Outside again. The kernel wants no calls from a critical section. */
static void wake(const TaskHandle_t *task, uint8_t n, bool in_interrupt)
{
    BaseType_t yield = pdFALSE;

    for (; n != 0; n--, task++) {
        if (in_interrupt) {
            vTaskNotifyGiveIndexedFromISR(*task, ETCH_FREERTOS_NOTIFICATION, &yield);
        } else {
            (void)xTaskNotifyGiveIndexed(*task, ETCH_FREERTOS_NOTIFICATION);
        }
    }
    if (in_interrupt) {
        portYIELD_FROM_ISR(yield);
    }
}

static void leave(const struct etch_monitor *monitor)
{
    const bool in_interrupt = xPortIsInsideInterrupt() != pdFALSE;
    struct etch_freertos_monitor *m = self(monitor);
    TaskHandle_t task[ETCH_FREERTOS_MOST_WAITING];
    uint8_t n = 0;

    if (m->signalled) {
        for (; n < m->waits; n++) {
            task[n] = m->waiting[n];
        }
        m->waits = 0;
        m->signalled = false;
    }
    if (in_interrupt) {
        taskEXIT_CRITICAL_FROM_ISR(m->saved);
    } else {
        taskEXIT_CRITICAL();
    }
    wake(task, n, in_interrupt);
}

/* Inside. A task that nobody signalled is still on the list. */
static void forget(struct etch_freertos_monitor *m, TaskHandle_t task)
{
    for (uint8_t i = 0; i < m->waits; i++) {
        if (m->waiting[i] == task) {
            m->waiting[i] = m->waiting[--m->waits];
        }
    }
}

static int wait(const struct etch_monitor *monitor, uint16_t limit_ms)
{
    struct etch_freertos_monitor *m = self(monitor);
    const TaskHandle_t me = xTaskGetCurrentTaskHandle();
    const TickType_t limit = limit_ms == 0 ? portMAX_DELAY : pdMS_TO_TICKS(limit_ms) + 1;
    uint32_t given;

    configASSERT(m->waits < ETCH_FREERTOS_MOST_WAITING);
    m->waiting[m->waits++] = me;
    leave(monitor);
    given = ulTaskNotifyTakeIndexed(ETCH_FREERTOS_NOTIFICATION, pdTRUE, limit);
    enter(monitor);
    forget(m, me);
    return given != 0 || limit_ms == 0 ? ETCH_OK : ETCH_EIO;
}

static void signal(const struct etch_monitor *monitor)
{
    self(monitor)->signalled = true;
}

void etch_freertos_monitor_open(struct etch_freertos_monitor *m)
{
    *m = (struct etch_freertos_monitor){
        .monitor = {.context = m, .enter = enter, .leave = leave, .wait = wait, .signal = signal}};
}
