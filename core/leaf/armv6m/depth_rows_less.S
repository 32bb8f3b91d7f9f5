@ leaf/armv6m/depth_rows_less.S: etch_depth_rows_less for ARMv6-M, in place of
@ fragment/depth_rows_less.c, which it equals bit for bit.

#include "depth_rows.inc"

    .section .text.etch_depth_rows_less, "ax"
    .global etch_depth_rows_less
    .thumb_func
    .type etch_depth_rows_less, %function
etch_depth_rows_less: @ surface, y0, runs, n, [paint, span]
    depth_rows 0
    .size etch_depth_rows_less, . - etch_depth_rows_less
