/* ports/host/panel_scan.h: the scan of a simulated panel, and whether a frame tore. */
#ifndef ETCH_HOST_PANEL_SCAN_H
#define ETCH_HOST_PANEL_SCAN_H

#include "panel.h"

/* The panel reads memory rows first .. first + lines - 1 (or back, if `up`) in each period, after
 * `blank` rows' time of rest, at whose beginning the tearing-effect line rises. */
struct etch_panel_scan {
    uint64_t period_ns;
    int first, lines, blank;
    bool up;
};

/* Time from now until the pulse that comes next; the glass is read by the same clock whether or not
 * the line shows it (panel->pulses: command 35). */
uint64_t etch_panel_until_pulse(const struct etch_panel *panel, const struct etch_panel_scan *scan);

/* Begins a frame: forgets which rows changed, and when. */
void etch_panel_begin_changes(struct etch_panel *panel);

/* The passes that showed rows both as they were before the changes and after, or a row half
 * changed; 0: the frame did not tear. Rows that did not change do not count. */
int etch_panel_torn(const struct etch_panel *panel, const struct etch_panel_scan *scan);

#endif
