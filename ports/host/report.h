/* ports/host/report.h: what etch-sim prints about a frame, to stdout, `name value` a line. */
#ifndef ETCH_HOST_REPORT_H
#define ETCH_HOST_REPORT_H

#include "simulate.h"

/* --stats: what drawing this frame took. */
void etch_report_stats(const struct etch_simulation *simulation);

/* --needs: what a program that draws this scene in strips of simulation->rows rows links and
 * holds, and what of that the scene would look the same without; no output is written. False
 * without memory. */
bool etch_report_needs(const struct etch_simulation *simulation);

/* Also --needs: the scene, read once more from `path`, in other modes against the exact one. */
bool etch_report_modes(const struct etch_simulation *simulation, const char *path);

#endif
