@ leaf/armv6m/line_walk.S: etch_line_walk for ARMv6-M, in place of raster/line_walk.c.
@
@ Eight double steps unrolled. One that runs straight on is 5 instructions for two pixels, on a line
@ of code of its own; the others have theirs, 8 instructions, and each goes on in either.

    .syntax unified
    .cpu cortex-m0plus
    .thumb

    @ The double step NAME, straight on unless e reaches 0.
    .macro straight name
    adds r4, r6
    bpl .Laside_\name
.Lstraight_\name:
    strh r5, [r0, r2]
    add r0, r9
    strh r5, [r0]
    .endm

    @ e >= 0 after 2 dv: the first of both goes aside if e >= dv. Then `next`, whose test it makes.
    .macro aside name, next
.Laside_\name:
    cmp r4, r7
    add r4, r8              @ leaves the flags
    bge 1f
    strh r5, [r0, r2]
    add r0, r10
    strh r5, [r0]
    adds r4, r6
    bmi .Lstraight_\next
    b .Laside_\next
1:  strh r5, [r0, r3]
    add r0, r10
    strh r5, [r0]
    adds r4, r6
    bmi .Lstraight_\next
    .endm                   @ the code of `next` follows, or a branch to it

    @ The same where a test of the count comes next.
    .macro aside_then name, next
.Laside_\name:
    cmp r4, r7
    add r4, r8
    bge 1f
    strh r5, [r0, r2]
    add r0, r10
    strh r5, [r0]
    b .L\next
1:  strh r5, [r0, r3]
    add r0, r10
    strh r5, [r0]
    b .L\next
    .endm

    .section .text.etch_line_walk, "ax"
    .global etch_line_walk
    .thumb_func
    .type etch_line_walk, %function
etch_line_walk:             @ p, n, along, aside, [e, du, dv, color]
    push {r4-r7, lr}
    mov r4, r8
    mov r5, r9
    mov r6, r10
    push {r4-r6}
    lsls r2, #1             @ in bytes
    lsls r3, #1
    adds r4, r2, r2
    mov r9, r4              @ two along
    adds r4, r2, r3
    mov r10, r4             @ one of each
    add r7, sp, #32
    ldmia r7!, {r4-r6}       @ e, du, dv
    rsbs r5, #0
    mov r8, r5              @ -du
    ldrh r5, [r7]      @ color
    movs r7, r6
    lsls r6, #1
    strh r5, [r0]

    lsrs r1, #1
    bcc .Lpairs
    adds r4, r7             @ an odd step
    bpl 1f
    adds r0, r2
    b 2f
1:  add r4, r8
    adds r0, r3
2:  strh r5, [r0]
.Lpairs:
    lsrs r1, #1
    bcc .Ltwos
    straight a
.Ltwos:
    lsrs r1, #1
    bcc .Lfours
    straight b
    straight c
.Lfours:
    lsrs r1, #1
    bcc .Leights
    straight d
    straight e
    straight f
    straight g
.Leights:
    cmp r1, #0
    beq .Ldone
    b .Lloop
.Ldone:
    pop {r4-r6}
    mov r8, r4
    mov r9, r5
    mov r10, r6
    pop {r4-r7, pc}

    aside_then a, twos
    aside b, c
    aside_then c, fours
    aside d, e
    aside e, f
    aside f, g
    aside_then g, eights
    aside h, i
    aside i, j
    aside j, k
    aside k, l
    b .Laside_l
.Lloop:
    straight h
    straight i
    straight j
    straight k
    straight l
    straight m
    straight n
    straight o
.Lnext:
    subs r1, #1
    bne .Lloop
    b .Ldone

    aside l, m
    aside m, n
    aside n, o
    aside_then o, next
    .size etch_line_walk, . - etch_line_walk
