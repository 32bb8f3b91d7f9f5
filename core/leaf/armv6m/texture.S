@ leaf/armv6m/texture.S: etch_kernel_texture for ARMv6-M, in place of fragment/texture.c, which it
@ equals bit for bit. u and v walk along the runs as one cursor: from the end of a run to the
@ beginning of the next a row down and some columns left or right, exact modulo 2^32.

#include "texel.inc"

#define SURFACE_PIXELS 0
#define SURFACE_STRIDE 8
#define SURFACE_X0 10
#define SURFACE_Y0 12
#define PAINT_U 16 /* origin, dx, dy */
#define PAINT_V 28
#define PAINT_MAP 40 /* texels, columns, rows */

    .section .text.etch_kernel_texture, "ax"
    .global etch_kernel_texture
    .thumb_func
    .type etch_kernel_texture, %function
etch_kernel_texture:        @ surface, y0, runs, n, [paint]
    push {r4-r7, lr}
    mov r4, r8
    mov r5, r9
    mov r6, r10
    mov r7, r11
    push {r4-r7}
    ldr r7, [sp, #36]       @ paint
    sub sp, #16             @ 0: end of the runs; 4, 8: dy of u, v; 12: stride in bytes
    mov r11, r2
    lsls r3, #2
    adds r3, r2
    str r3, [sp, #0]

    ldrh r4, [r0, #SURFACE_STRIDE]
    lsls r4, #1
    str r4, [sp, #12]
    ldrh r5, [r0, #SURFACE_Y0]
    subs r5, r1, r5
    muls r4, r5
    ldrh r5, [r0, #SURFACE_X0]
    lsls r5, #1
    subs r4, r5
    ldr r5, [r0, #SURFACE_PIXELS]
    adds r4, r5
    mov r12, r4             @ address of column 0

    ldr r3, [r7, #PAINT_U + 4]
    mov r8, r3
    ldr r3, [r7, #PAINT_V + 4]
    mov r9, r3
    ldr r3, [r7, #PAINT_U + 8]
    str r3, [sp, #4]
    muls r3, r1
    ldr r4, [r7, #PAINT_U]
    adds r3, r4
    ldr r4, [r7, #PAINT_V + 8]
    str r4, [sp, #8]
    muls r4, r1
    ldr r5, [r7, #PAINT_V]
    adds r4, r5
    ldr r5, [r7, #PAINT_MAP]
    mov r10, r5
    ldr r5, [r7, #PAINT_MAP + 4]
    ldr r6, [r7, #PAINT_MAP + 8]
    movs r7, #0
    mov lr, r7              @ the cursor's column
    mov r7, r11

    b row
finish:
    add sp, #16
    pop {r4-r7}
    mov r8, r4
    mov r9, r5
    mov r10, r6
    mov r11, r7
    pop {r4-r7, pc}
next:
    ldr r1, [sp, #12]
    add r12, r1
    ldr r1, [sp, #4]
    adds r3, r1
    ldr r1, [sp, #8]
    adds r4, r1
    mov r7, r11
    adds r7, #4
    mov r11, r7
    ldr r1, [sp, #0]
    cmp r7, r1
    beq finish
row:                        @ r3, r4: u, v at column lr; r7 = r11: runs
    ldrh r0, [r7]
    ldrh r7, [r7, #2]
    mov r1, lr
    subs r1, r0, r1         @ columns to the right
    mov lr, r7
    mov r2, r8
    muls r2, r1
    adds r3, r2
    mov r2, r9
    muls r2, r1
    adds r4, r2
    subs r7, r0             @ pixels
    beq next
    lsls r0, #1
    add r0, r12
    subs r7, #1
    texel_row 4
    b next
