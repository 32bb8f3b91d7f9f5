@ leaf/armv6m/basis_color.S: etch_basis_color for ARMv6-M, in place of raster/basis_color.c, which it
@ equals bit for bit; the derivation is there. 63 instructions a channel, 75 where vertex 0 is not in
@ the centre of a pixel; gcc's code takes half as many again to keep what fits no register.
@
@   r6 down   r7 basis   r8-r10 vertices 0, 1, 2   r11 factor   r12 value at vertex 0   lr s

    .syntax unified
    .cpu cortex-m0plus
    .thumb

#define BASIS_X1 0
#define BASIS_Y1 4
#define BASIS_X2 8
#define BASIS_Y2 12
#define BASIS_RECIPROCAL 16
#define BASIS_SHIFT 20
#define BASIS_BITS 24
#define BASIS_AX 28
#define BASIS_AY 32
#define BASIS_FX 36
#define BASIS_FY 40
#define TRIANGLE_ORDER 48
#define VERTEX_R 12
#define VERTEX_G 13
#define VERTEX_B 14

#define RED 0 /* on the stack */
#define WIDE 4
#define GREEN 44
#define BLUE 48

    @ r8 + \i = the vertex order[\i]; r1: order, r2: v
    .macro vertex i, to
    ldrb r4, [r1, #\i]
    lsls r4, #2
    ldr r4, [r2, r4]
    mov \to, r4
    .endm

    @ \n factor / 2^down; r2: factor
    .macro slope n
    movs r0, \n
    asrs r0, r6
    movs r1, r0
    lsls r1, r6
    subs \n, r1
    muls \n, r2
    lsrs \n, r6
    muls r0, r2
    adds \n, r0
    .endm

    .macro channel at, unit, half, plane
    mov r3, r8
    ldrb r0, [r3, #\at]
    mov r3, r9
    ldrb r1, [r3, #\at]
    subs r1, r0             @ d1
    mov r3, r10
    ldrb r2, [r3, #\at]
    subs r2, r0             @ d2
    ldr r3, \unit
    muls r0, r3
    movs r3, #1
    lsls r3, #\half
    adds r0, r3
    mov r12, r0
    ldr r3, [r7, #BASIS_Y2]
    muls r3, r1
    ldr r4, [r7, #BASIS_Y1]
    muls r4, r2
    subs r3, r4             @ nx
    ldr r4, [r7, #BASIS_X1]
    muls r4, r2
    ldr r5, [r7, #BASIS_X2]
    muls r5, r1
    subs r4, r5             @ ny
    mov r2, r11
    slope r3
    slope r4
    ldr r0, [r7, #BASIS_FX]
    ldr r1, [r7, #BASIS_FY]
    movs r5, r0
    orrs r5, r1
    beq 1f                  @ r0: 0
    uxtb r2, r3
    muls r2, r0
    uxtb r5, r4
    muls r5, r1
    adds r2, r5
    asrs r2, #8
    asrs r5, r3, #8
    muls r0, r5
    asrs r5, r4, #8
    muls r1, r5
    adds r0, r1
    adds r0, r2
1:  mov r5, lr
    cmp r5, #0
    blt 2f
    lsls r3, r5
    lsls r4, r5
    lsls r0, r5
    b 3f
2:  negs r5, r5
    asrs r3, r5
    asrs r4, r5
    asrs r0, r5
3:  add r0, r12
    ldr r1, [r7, #BASIS_AX]
    muls r1, r3
    subs r0, r1
    ldr r1, [r7, #BASIS_AY]
    muls r1, r4
    subs r0, r1
    ldr r1, [sp, #\plane]
    stmia r1!, {r0, r3, r4}
    .endm

    .section .text.etch_basis_color, "ax"
    .global etch_basis_color
    .thumb_func
    .type etch_basis_color, %function
etch_basis_color:           @ basis, triangle, v, red, [green, blue]
    push {r4-r7, lr}
    mov r4, r8
    mov r5, r9
    mov r6, r10
    mov r7, r11
    push {r4-r7}
    sub sp, #8
    str r3, [sp, #RED]
    movs r7, r0
    movs r0, #0
    ldr r6, [r7, #BASIS_BITS]
    ldr r4, [r7, #BASIS_SHIFT]
    adds r4, r6
    subs r4, #22
    mov lr, r4
    adds r4, r6
    cmp r4, #23
    ble 1f
    b .Ldone
1:  subs r6, #5
    adds r1, #TRIANGLE_ORDER
    vertex 0, r8
    vertex 1, r9
    vertex 2, r10
    ldr r4, [r7, #BASIS_RECIPROCAL]
    asrs r5, r4, #8
    asrs r3, r4, #16
    adds r5, r3             @ r / 255
    lsls r3, r5, #2
    subs r4, r3
    adds r3, r4, r5
    asrs r3, #13
    mov r11, r3             @ r - 3 r / 255
    lsls r3, r5, #2
    subs r4, r3
    adds r4, r5
    asrs r4, #13
    str r4, [sp, #WIDE]     @ r - 7 r / 255
    channel VERTEX_G, .Lunit_q26, 25, GREEN
    ldr r4, [sp, #WIDE]
    mov r11, r4
    channel VERTEX_R, .Lunit_q27, 26, RED
    channel VERTEX_B, .Lunit_q27, 26, BLUE
    movs r0, #1
.Ldone:
    add sp, #8
    pop {r4-r7}
    mov r8, r4
    mov r9, r5
    mov r10, r6
    mov r11, r7
    pop {r4-r7, pc}
    .align 2
.Lunit_q26:
    .word 16579837
.Lunit_q27:
    .word 16316665
    .size etch_basis_color, . - etch_basis_color
