/* tradeoff/error.h: parts of the host's error program. See error.c. */
#ifndef TRADEOFF_ERROR_H
#define TRADEOFF_ERROR_H

#include <stdbool.h>

#include "../oracle/triangle.h"
#include "tradeoff.h"

__extension__ typedef __int128 wide128; /* host only */

/* One triangle, drawn alone on a clean surface. */
struct error_triangle {
    const struct etch_texture_vertex *v; /* three */
    struct oracle_triangle exact;
    const struct etch_surface *drawn;
    int x0, y0, x1, y1; /* what it can touch of the screen, and two pixels more */
};

/* Fills in x0 .. y1. */
void error_find(struct error_triangle *t);

/* Adds one error to the list of the mode and scene in hand. */
void error_add(double error);

/* D times the varying that is value[i] at vertex i, at a covered pixel; exact. */
wide128 error_value(const struct error_triangle *t, int x, int y, const uint32_t value[3]);

/* Each adds the errors of a triangle, or of a whole scene. */
void error_color(const struct error_triangle *t);
void error_blocks(const struct error_triangle *t);
void error_depth(const struct error_triangle *t);
void error_code(const struct error_triangle *t);
void error_texel(const struct error_triangle *t);
void error_coverage(const struct error_triangle *t);
void error_visible(const struct tradeoff_mode *mode, const struct tradeoff_scene *scene,
                   const struct etch_surface *s);

#endif
