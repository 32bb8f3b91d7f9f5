/* ports/host/panel_scan.c: tearing, by the times at which rows changed and were read. Tests call
 * it. See panel_scan.h. */
#include "panel_scan.h"

uint64_t etch_panel_until_pulse(const struct etch_panel *panel, const struct etch_panel_scan *scan)
{
    return scan->period_ns - panel->now_ns % scan->period_ns;
}

void etch_panel_begin_changes(struct etch_panel *panel)
{
    for (int row = 0; row < panel->type->memory_height; row++) {
        panel->changed_first[row] = panel->changed_last[row] = 0;
    }
}

/* When pass `pass` begins to read the row that is `at`-th in its order. */
static uint64_t read_time(const struct etch_panel_scan *s, uint64_t pass, int at)
{
    return pass * s->period_ns +
           s->period_ns * (uint64_t)(s->blank + at) / (uint64_t)(s->blank + s->lines);
}

static bool is_torn(const struct etch_panel *p, const struct etch_panel_scan *s, uint64_t pass)
{
    bool shows_old = false, shows_new = false;

    for (int at = 0; at < s->lines; at++) {
        const int row = s->first + (s->up ? s->lines - 1 - at : at);
        const uint64_t begin = read_time(s, pass, at), end = read_time(s, pass, at + 1);

        if (p->changed_first[row] != 0) {
            shows_old = shows_old || begin < p->changed_last[row];
            shows_new = shows_new || end > p->changed_first[row];
        }
    }
    return shows_old && shows_new;
}

int etch_panel_torn(const struct etch_panel *panel, const struct etch_panel_scan *scan)
{
    uint64_t from = panel->now_ns, to = 0;
    int torn = 0;

    for (int row = scan->first; row < scan->first + scan->lines; row++) {
        if (panel->changed_first[row] != 0) {
            from = panel->changed_first[row] < from ? panel->changed_first[row] : from;
            to = panel->changed_last[row] > to ? panel->changed_last[row] : to;
        }
    }
    for (uint64_t pass = from / scan->period_ns; pass <= to / scan->period_ns; pass++) {
        torn += is_torn(panel, scan, pass);
    }
    return torn;
}
