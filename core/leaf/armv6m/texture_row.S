@ leaf/armv6m/texture_row.S: etch_texel_row for ARMv6-M, in place of fragment/texture_row.c.

#include "texel.inc"

    .section .text.etch_texel_row, "ax"
    .global etch_texel_row
    .thumb_func
    .type etch_texel_row, %function
etch_texel_row:             @ pixel, n, walk, map
    push {r4-r7, lr}
    mov r4, r8
    mov r5, r9
    mov r6, r10
    push {r4-r6}
    subs r7, r1, #1
    bcc none
    ldr r1, [r3]
    mov r10, r1
    ldr r5, [r3, #4]
    ldr r6, [r3, #8]
    ldmia r2, {r1, r2, r3, r4} @ u, v, du, dv
    mov r8, r3
    mov r9, r4
    movs r3, r1
    movs r4, r2
    texel_row 3
none:
    pop {r4-r6}
    mov r8, r4
    mov r9, r5
    mov r10, r6
    pop {r4-r7, pc}
