@ leaf/armv6m/gouraud_narrow_lequal.S: etch_gouraud_narrow_lequal for ARMv6-M, in place of
@ fragment/gouraud_narrow_lequal.c.

#include "gouraud_narrow.inc"

    .section .text.etch_gouraud_narrow_lequal, "ax"
    .global etch_gouraud_narrow_lequal
    .thumb_func
    .type etch_gouraud_narrow_lequal, %function
etch_gouraud_narrow_lequal: @ surface, y0, runs, n, [paint]
    gouraud_narrow bhi
    .size etch_gouraud_narrow_lequal, . - etch_gouraud_narrow_lequal
