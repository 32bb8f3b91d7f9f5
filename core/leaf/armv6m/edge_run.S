@ leaf/armv6m/edge_run.S: etch_edge_run for ARMv6-M, in place of raster/edge_run.c. See
@ raster/edge.h.

    .syntax unified
    .cpu cortex-m0plus
    .thumb

    @ x in r5 to the row, then a row down: 5 instructions, or 6 where e falls below 0
    .macro row at
    strh r5, [r2, #\at]
    adds r5, r1
    subs r4, r6
    bpl 1f
    adds r4, r7
    adds r5, #1
1:
    .endm

    .section .text.etch_edge_run, "ax"
    .global etch_edge_run
    .thumb_func
    .type etch_edge_run, %function
etch_edge_run:              @ a.x, a.y, b.x, b.y, [out, n]
    push {r4-r7, lr}
    subs r7, r3, r1         @ dy
    subs r6, r2, r0         @ dx
    subs r0, #128
    movs r5, #128
    subs r5, r1
    uxtb r5, r5             @ k
    asrs r3, r6, #31        @ sign
    movs r1, r3             @ quotient
    eors r6, r3
    cmp r6, r7
    bhs .Lflat
.Lsteep:                    @ r6: rest of dx or of ~dx
    eors r6, r3
    ands r3, r7
    adds r6, r3             @ remainder
    movs r4, r1
    muls r4, r5
    adds r0, r4             @ x in 1/256
    muls r5, r6
    uxtb r4, r0
    muls r4, r7
    adds r4, r5
    asrs r5, r0, #8         @ x
    adds r4, #255
    asrs r4, #8
    ldr r2, [sp, #20]
    ldr r3, [sp, #24]
    negs r4, r4             @ e
    bmi .Lup
.Lrows:
    lsrs r3, #1             @ C: one more than pairs of rows
    bcc 2f
    row 0
    adds r2, #4
2:  lsrs r3, #1
    bcc 2f
    row 0
    row 4
    adds r2, #8
    cmp r3, #0
2:  beq .Ldone
.Lfour:
    row 0
    row 4
    row 8
    row 12
    adds r2, #16
    subs r3, #1
    bne .Lfour
.Ldone:
    movs r0, r2
    pop {r4-r7, pc}

.Lup:                       @ by one or two
    adds r5, #1
    adds r4, r7
    bpl .Lrows
    adds r5, #1
    adds r4, r7
    b .Lrows

.Lflat:                     @ r6 by r7: to 3 by subtraction, then bit by bit; r2, r4 scratch
    movs r1, #1
    subs r6, r7
    cmp r6, r7
    blo .Ldivided
    movs r1, #2
    subs r6, r7
    cmp r6, r7
    blo .Ldivided
    movs r1, #3
    subs r6, r7
    cmp r6, r7
    blo .Ldivided
    movs r2, r7
    lsrs r4, r6, #1
    movs r1, #0
1:  cmp r2, r4
    bhi 2f
    lsls r2, #1
    b 1b
2:  lsls r1, #1
    cmp r6, r2
    blo 3f
    subs r6, r2
    adds r1, #1
3:  lsrs r2, #1
    cmp r2, r7
    bhs 2b
    adds r1, #3
.Ldivided:
    eors r1, r3
    b .Lsteep
    .size etch_edge_run, . - etch_edge_run
