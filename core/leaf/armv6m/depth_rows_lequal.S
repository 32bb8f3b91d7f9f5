@ leaf/armv6m/depth_rows_lequal.S: etch_depth_rows_lequal for ARMv6-M, in place of
@ fragment/depth_rows_lequal.c, which it equals bit for bit.

#include "depth_rows.inc"

    .section .text.etch_depth_rows_lequal, "ax"
    .global etch_depth_rows_lequal
    .thumb_func
    .type etch_depth_rows_lequal, %function
etch_depth_rows_lequal: @ surface, y0, runs, n, [paint, span]
    depth_rows 1
    .size etch_depth_rows_lequal, . - etch_depth_rows_lequal
