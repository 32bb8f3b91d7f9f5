@ leaf/armv6m/circle_whole.S: etch_circle_whole for ARMv6-M, in place of raster/circle_whole.c.
@
@ One decision for four pixels, at two pointers to rows and two offsets. Offsets are what the
@ decision needs anyhow, 2 x - 1 or 2 y - 2; the pointers are off by their constant.

    .syntax unified
    .cpu cortex-m0plus
    .thumb

    .macro four right, left
    strh r6, [r0, \right]
    strh r6, [r0, \left]
    strh r6, [r1, \right]
    strh r6, [r1, \left]
    .endm

    @ r2 = 2 x - 1, r3 = -2 x - 1, r4 = d, r5 = 2 y - 2
    .macro flat_step
    subs r3, #2
    adds r2, #2
    adds r4, r2
    bmi 9f
    subs r4, r5
    subs r5, #2
    add r0, r9
    add r1, r8
9:  four r2, r3
    .endm

    @ r2 = 2 x - 1, r3 = -2 y - 2, r4 = d, r5 = 2 y - 2
    .macro steep_step
    add r0, r8
    add r1, r9
    adds r2, #2
    adds r4, r2
    bmi 9f
    subs r4, r5
    subs r5, #2
    adds r3, #2
9:  four r5, r3
    .endm

    @ r7 steps, two at a time; an odd number begins in the middle.
    .macro steps step
    movs r2, #0
    mvns r2, r2             @ x = 0
    mov r4, r10
    rsbs r4, #0             @ d = -r
    cmp r7, #0
    beq 3f
    lsrs r7, #1
    bcc 1f
    adds r7, #1
    b 2f
1:  \step
2:  \step
    subs r7, #1
    bne 1b
3:
    .endm

    .section .text.etch_circle_whole, "ax"
    .global etch_circle_whole
    .thumb_func
    .type etch_circle_whole, %function
etch_circle_whole:          @ centre, row, r, end, [steep_end, color]
    push {r4-r7, lr}
    mov r4, r8
    mov r5, r9
    mov r6, r10
    mov r7, r11
    push {r4-r7}
    add r6, sp, #40
    ldrh r6, [r6]           @ color
    movs r7, r3
    mov r10, r2             @ r
    mov r11, r0             @ centre
    lsls r1, #1
    mov r8, r1              @ a row in bytes, down
    rsbs r4, r1, #0
    mov r9, r4              @ and up

    muls r1, r2
    adds r0, r1             @ below
    mov r4, r11
    subs r1, r4, r1         @ above
    strh r6, [r0]
    strh r6, [r1]
    adds r0, #1
    adds r1, #1
    subs r5, r2, #1
    lsls r5, #1             @ 2 r - 2
    movs r3, #0
    mvns r3, r3
    steps flat_step

    ldr r7, [sp, #36]       @ steep_end
    mov r0, r11
    adds r0, #2
    movs r1, r0
    mov r5, r10
    subs r5, #1
    lsls r5, #1
    mvns r3, r5
    subs r3, #3             @ -2 r - 2
    strh r6, [r0, r5]
    strh r6, [r0, r3]
    steps steep_step

    pop {r4-r7}
    mov r8, r4
    mov r9, r5
    mov r10, r6
    mov r11, r7
    pop {r4-r7, pc}
    .size etch_circle_whole, . - etch_circle_whole
