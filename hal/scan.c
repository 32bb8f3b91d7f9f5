/* hal/scan.c: when to begin a frame. The application or a display's sync calls it. See scan.h. */
#include "scan.h"

/* Times are in units of 1 us / (lines (lines + blank)), in which all of them are whole numbers:
 * below 2^20 2^15 2^16 = 2^51 each. All conditions are linear in the line, so they hold for every
 * line if they hold for the first and the last. */
struct times {
    int64_t unit;                       /* 1 us */
    int64_t line;                       /* of the scan */
    int64_t blank;                      /* before the first line */
    int64_t active;                     /* from the first line's start to the last one's end */
    int64_t period, row, write, jitter; /* row: to write a line */
};

static struct times times_of(const struct etch_scan *s, uint32_t write_us, uint32_t jitter_us)
{
    const int64_t lines = s->lines, all = (int64_t)s->lines + s->blank;
    struct times t = {.unit = lines * all};

    t.line = lines * s->period_us;
    t.blank = t.line * s->blank;
    t.active = t.line * lines;
    t.period = t.line * all;
    t.row = all * write_us;
    t.write = t.row * lines;
    t.jitter = t.unit * jitter_us;
    return t;
}

/* Begun at the pulse, every line is written before it is read. */
static bool stays_ahead(const struct times *t)
{
    return t->row + t->jitter <= t->blank && t->write + t->jitter <= t->blank + t->active - t->line;
}

/* Begun at `delay`, every line is written before the next pass reads it. */
static bool ends_in_time(const struct times *t, int64_t delay)
{
    return delay + t->row + t->jitter <= t->period + t->blank &&
           delay + t->write + t->jitter <= t->period + t->blank + t->active - t->line;
}

int32_t etch_scan_plan(const struct etch_scan *scan, uint32_t write_us, uint32_t jitter_us)
{
    const struct times t = times_of(scan, write_us, jitter_us);
    const int64_t first = t.blank + t.line;                      /* has been read */
    const int64_t last = t.blank + t.active - (t.write - t.row); /* .. when it is written */
    const int64_t behind = first > last ? first : last;
    struct etch_quotient delay;

    if (!scan->along) {
        return t.write + t.jitter <= t.blank ? 0 : ETCH_ERANGE;
    }
    if (stays_ahead(&t)) {
        return 0;
    }
    delay = etch_divide_u64((uint64_t)(behind + t.unit - 1), (uint64_t)t.unit);
    return ends_in_time(&t, (int64_t)delay.quotient * t.unit) ? (int32_t)delay.quotient
                                                              : ETCH_ERANGE;
}
