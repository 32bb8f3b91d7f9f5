/* ports/pthread/pthread_monitor.c: a mutex, and a condition on the clock that nobody sets. hal
 * calls it through struct etch_monitor. */
#define _POSIX_C_SOURCE 200809L
#include "pthread_monitor.h"

#include <errno.h>
#include <time.h>

static struct etch_pthread_monitor *self(const struct etch_monitor *monitor)
{
    return monitor->context;
}

static void enter(const struct etch_monitor *monitor)
{
    (void)pthread_mutex_lock(&self(monitor)->mutex);
}

static void leave(const struct etch_monitor *monitor)
{
    (void)pthread_mutex_unlock(&self(monitor)->mutex);
}

static int wait(const struct etch_monitor *monitor, uint16_t limit_ms)
{
    struct etch_pthread_monitor *m = self(monitor);
    struct timespec end;

    if (limit_ms == 0) {
        return pthread_cond_wait(&m->changed, &m->mutex) == 0 ? ETCH_OK : ETCH_EIO;
    }
    if (clock_gettime(CLOCK_MONOTONIC, &end) != 0) {
        return ETCH_EIO;
    }
    end.tv_sec += limit_ms / 1000;
    end.tv_nsec += limit_ms % 1000 * 1000000L;
    if (end.tv_nsec >= 1000000000L) {
        end.tv_nsec -= 1000000000L;
        end.tv_sec++;
    }
    return pthread_cond_timedwait(&m->changed, &m->mutex, &end) == 0 ? ETCH_OK : ETCH_EIO;
}

static void signal(const struct etch_monitor *monitor)
{
    (void)pthread_cond_broadcast(&self(monitor)->changed);
}

bool etch_pthread_monitor_open(struct etch_pthread_monitor *m)
{
    pthread_condattr_t attributes;
    bool ok;

    m->monitor = (struct etch_monitor){
        .context = m, .enter = enter, .leave = leave, .wait = wait, .signal = signal};
    if (pthread_condattr_init(&attributes) != 0) {
        return false;
    }
    ok = pthread_condattr_setclock(&attributes, CLOCK_MONOTONIC) == 0 &&
         pthread_cond_init(&m->changed, &attributes) == 0;
    (void)pthread_condattr_destroy(&attributes);
    if (ok && pthread_mutex_init(&m->mutex, NULL) != 0) {
        (void)pthread_cond_destroy(&m->changed);
        ok = false;
    }
    return ok;
}

void etch_pthread_monitor_close(struct etch_pthread_monitor *m)
{
    (void)pthread_cond_destroy(&m->changed);
    (void)pthread_mutex_destroy(&m->mutex);
}
