/* ports/pthread/pthread_monitor.h: hal/monitor.h on POSIX threads. What takes the place of an
 * interrupt is a thread, too.
 *
 *      static struct etch_pthread_monitor m;
 *      if (etch_pthread_monitor_open(&m)) .. &m.monitor
 */
#ifndef ETCH_PORTS_PTHREAD_MONITOR_H
#define ETCH_PORTS_PTHREAD_MONITOR_H

#include <pthread.h>

#include "../../hal/monitor.h"

/* Set up by open; then `monitor` is for hal, and the rest private. Must stay where it is. */
struct etch_pthread_monitor {
    struct etch_monitor monitor;
    pthread_mutex_t mutex;
    pthread_cond_t changed;
};

/* False if the system has no more of them; there is nothing to close then. */
bool etch_pthread_monitor_open(struct etch_pthread_monitor *m);

/* Nobody is inside or waits. */
void etch_pthread_monitor_close(struct etch_pthread_monitor *m);

#endif
