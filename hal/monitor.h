/* hal/monitor.h: what etch needs of a system with threads, or of a chip with several cores: one
 * lock, and waiting for what somebody else does.
 *
 *      enter | look, change, signal | leave       one thread or interrupt at a time
 *      enter | while (not yet) wait | .. | leave  wait lets the others in while it sleeps
 *
 * A port fills it: ports/pthread, ports/freertos, ports/rp2040 (two cores, no system). A program
 * of one thread and interrupts on the same core needs none: hal/transfer.h does without.
 *
 * Users: hal/guarded.h (a transfer whose interrupt may run on another core, or beside a task that
 * sleeps) and hal/workers.h (a frame drawn by several). Both stay inside for some dozen
 * instructions, never while they draw, send or call a display; a piece that is converted is the
 * exception (hal/bus.h), so entering may stop interrupts.
 * Sources: C. A. R. Hoare, "Monitors", 1974; that a woken thread looks again: B. Lampson and
 * D. Redell, "Experience with processes and monitors in Mesa", 1980.
 */
#ifndef ETCH_HAL_MONITOR_H
#define ETCH_HAL_MONITOR_H

#include "../core/base/fixed.h"

struct etch_monitor {
    /* The port's own, handed to nobody else. May be NULL. */
    void *context;

    /* Returns when nobody else is inside; what they wrote there is then seen. Not nested. */
    void (*enter)(const struct etch_monitor *monitor);
    void (*leave)(const struct etch_monitor *monitor);

    /* Threads only, inside: leaves, sleeps until a signal that is given from now on, or sooner, and
     * enters again. 0; or a negative number (ETCH_EIO) if limit_ms milliseconds passed without
     * one. limit_ms 0: no limit. */
    int (*wait)(const struct etch_monitor *monitor, uint16_t limit_ms);

    /* Inside, and from an interrupt too: all that wait look again. */
    void (*signal)(const struct etch_monitor *monitor);
};

ETCH_INLINE void etch_monitor_enter(const struct etch_monitor *monitor)
{
    monitor->enter(monitor);
}

ETCH_INLINE void etch_monitor_leave(const struct etch_monitor *monitor)
{
    monitor->leave(monitor);
}

ETCH_INLINE int etch_monitor_wait(const struct etch_monitor *monitor, uint16_t limit_ms)
{
    return monitor->wait(monitor, limit_ms);
}

ETCH_INLINE void etch_monitor_signal(const struct etch_monitor *monitor)
{
    monitor->signal(monitor);
}

#endif
