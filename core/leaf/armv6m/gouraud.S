@ leaf/armv6m/gouraud.S: etch_kernel_gouraud for ARMv6-M, in place of fragment/gouraud.c, which it
@ equals bit for bit. See fragment/gouraud_rows.h for the cursor.
@
@ A pixel is 11 instructions: seven to shift and join the channels, a store, three sums. The steps
@ stay in high registers, which an addition reads at no cost. Eight pixels are unrolled, and a
@ row enters them so that it ends with the last. Blocks whose middle run has 32 pixels or more go
@ another way, with the same pixels: gouraud_wide.inc.

    .syntax unified
    .cpu cortex-m0plus
    .thumb

#define SURFACE_PIXELS 0
#define SURFACE_STRIDE 8
#define SURFACE_X0 10
#define SURFACE_Y0 12
#define PAINT_R 16 /* origin, dx, dy */
#define PAINT_G 28
#define PAINT_B 40

    .macro shade at
    lsrs r4, r0, #27
    add r0, r8
    lsls r4, r4, #6
    lsrs r5, r1, #26
    add r1, r9
    orrs r4, r5
    lsls r4, r4, #5
    lsrs r5, r2, #27
    add r2, r10
    orrs r4, r5
    strh r4, [r3, #2 * \at]
    .endm

    @ r0 = the plane at r7, in column 0 of row r1; its dx to \step, its dy to the stack
    .macro plane at, step, slot
    ldr r3, [r7, #\at + 4]
    mov \step, r3
    ldr r3, [r7, #\at + 8]
    str r3, [sp, #\slot]
    muls r3, r1
    ldr r0, [r7, #\at]
    adds r0, r3
    .endm

    .section .text.etch_kernel_gouraud, "ax"
    .global etch_kernel_gouraud
    .thumb_func
    .type etch_kernel_gouraud, %function
etch_kernel_gouraud:        @ surface, y0, runs, n, [paint]
    push {r4-r7, lr}
    mov r4, r8
    mov r5, r9
    mov r6, r10
    mov r7, r11
    push {r4-r7}
    ldr r7, [sp, #36]       @ paint
    lsrs r4, r3, #1         @ the run in the middle
    lsls r4, #2
    adds r4, r2
    ldrh r5, [r4, #2]
    ldrh r4, [r4]
    subs r5, r4
    cmp r5, #32
    blo 1f
    b .Lwide
1:  sub sp, #16             @ 0, 4, 8: dy of r, g, b; 12: end of the runs
    movs r6, r2
    lsls r3, #2
    adds r3, r2
    str r3, [sp, #12]

    ldrh r4, [r0, #SURFACE_STRIDE]
    lsls r4, #1
    mov r11, r4             @ stride in bytes
    ldrh r5, [r0, #SURFACE_Y0]
    subs r5, r1, r5
    muls r4, r5
    ldrh r5, [r0, #SURFACE_X0]
    lsls r5, #1
    subs r4, r5
    ldr r5, [r0, #SURFACE_PIXELS]
    add r4, r5
    mov r12, r4             @ address of column 0

    plane PAINT_B, r10, 8
    mov r2, r0
    plane PAINT_R, r8, 0
    mov r5, r0
    plane PAINT_G, r9, 4
    mov r1, r0
    mov r0, r5
    movs r3, #0
    mov lr, r3              @ the cursor's column
    b .Lrow

.Lnext:
    add r12, r11
    ldr r3, [sp, #0]
    adds r0, r3
    ldr r3, [sp, #4]
    adds r1, r3
    ldr r3, [sp, #8]
    adds r2, r3
    adds r6, #4
    ldr r3, [sp, #12]
    cmp r6, r3
    beq .Ldone
.Lrow:                      @ r0-r2: r, g, b at column lr; r6: runs
    ldrh r3, [r6]
    ldrh r7, [r6, #2]
    mov r4, lr
    subs r4, r3, r4         @ columns to the right
    mov lr, r7
    mov r5, r8
    muls r5, r4
    adds r0, r5
    mov r5, r9
    muls r5, r4
    adds r1, r5
    mov r5, r10
    muls r5, r4
    adds r2, r5
    subs r7, r3             @ pixels
    beq .Lnext
    lsls r3, #1
    add r3, r12
    subs r7, #1
    movs r5, #7
    movs r4, r7
    bics r5, r4             @ pixels of the first eight to leave out
    lsrs r7, #3             @ eights after the first
    lsls r4, r5, #1
    subs r3, r4
    movs r4, #22
    muls r5, r4
    add pc, r5
    nop
.Leight:
    shade 0
    shade 1
    shade 2
    shade 3
    shade 4
    shade 5
    shade 6
    shade 7
    adds r3, #16
    subs r7, #1
    bcs .Leight
    b .Lnext

.Ldone:
    add sp, #16
.Lpop:
    pop {r4-r7}
    mov r8, r4
    mov r9, r5
    mov r10, r6
    mov r11, r7
    pop {r4-r7, pc}
#include "gouraud_wide.inc"
    .size etch_kernel_gouraud, . - etch_kernel_gouraud
