/* fragment/stencil.h: the stencil test and its operations as stages (stage.h).
 *
 *      {etch_stage_stencil_equal, &stencil},   the test: on failure the operation `fail`
 *      {etch_stage_depth_less, NULL},          optional, and stages of your own
 *      {etch_stage_stencil_update, &stencil},  what passed the stencil test: `depth_fail` where it
 *                                              was dropped since, else `pass`
 *
 * as in OpenGL, on 8-bit values. The surface must have a stencil plane (base/surface.h).
 */
#ifndef ETCH_FRAGMENT_STENCIL_H
#define ETCH_FRAGMENT_STENCIL_H

#include "stage.h"

/* The new value of a pixel that has `stored`. */
typedef uint8_t etch_stencil_operation(uint8_t stored, uint8_t reference);

etch_stencil_operation etch_stencil_zero;      /* 0 */
etch_stencil_operation etch_stencil_replace;   /* the reference */
etch_stencil_operation etch_stencil_incr;      /* + 1, at most 255 */
etch_stencil_operation etch_stencil_decr;      /* - 1, at least 0 */
etch_stencil_operation etch_stencil_invert;    /* all bits the other way */
etch_stencil_operation etch_stencil_incr_wrap; /* + 1, 0 after 255 */
etch_stencil_operation etch_stencil_decr_wrap; /* - 1, 255 after 0 */

/* Data of the stages; the caller's. */
struct etch_stencil {
    uint8_t reference;
    uint8_t mask;       /* bits that are compared, of the reference and of the stored value */
    uint8_t write_mask; /* bits that operations may change; 255: all */
    etch_stencil_operation *fail, *depth_fail, *pass; /* NULL keeps the value */
};

/* Passes where reference & mask stands so to stored & mask: `less` passes where the reference is
 * less than what is stored. */
etch_stage_function etch_stage_stencil_never;
etch_stage_function etch_stage_stencil_less;
etch_stage_function etch_stage_stencil_equal;
etch_stage_function etch_stage_stencil_lequal;
etch_stage_function etch_stage_stencil_greater;
etch_stage_function etch_stage_stencil_notequal;
etch_stage_function etch_stage_stencil_gequal;
etch_stage_function etch_stage_stencil_always;

/* Ends the test, with the same data. Not needed if depth_fail and pass are NULL. */
etch_stage_function etch_stage_stencil_update;

#endif
