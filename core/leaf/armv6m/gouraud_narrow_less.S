@ leaf/armv6m/gouraud_narrow_less.S: etch_gouraud_narrow_less for ARMv6-M, in place of
@ fragment/gouraud_narrow_less.c.

#include "gouraud_narrow.inc"

    .section .text.etch_gouraud_narrow_less, "ax"
    .global etch_gouraud_narrow_less
    .thumb_func
    .type etch_gouraud_narrow_less, %function
etch_gouraud_narrow_less: @ surface, y0, runs, n, [paint]
    gouraud_narrow bhs
    .size etch_gouraud_narrow_less, . - etch_gouraud_narrow_less
