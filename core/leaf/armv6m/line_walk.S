@ leaf/armv6m/line_walk.S: etch_line_walk for ARMv6-M, in place of raster/line_walk.c.
@
@ Four double steps unrolled. A double step without a step aside runs straight on: 6 instructions
@ for two pixels; one with it leaves the line of code and comes back: 11.

    .syntax unified
    .cpu cortex-m0plus
    .thumb

    .macro along
    adds r0, r2
    strh r5, [r0]
    .endm

    .macro aside
    adds r0, r3
    strh r5, [r0]
    .endm

    .macro two_steps to
    adds r4, r6
    bpl .L\to
    along
    along
.Lback_\to:
    .endm

    @ e >= 0 after 2 dv: the first step goes aside if e >= dv
    .macro step_aside at
.L\at:
    cmp r4, r7
    add r4, r8              @ leaves the flags
    blt 1f
    aside
    along
    b .Lback_\at
1:  along
    aside
    b .Lback_\at
    .endm

    .section .text.etch_line_walk, "ax"
    .global etch_line_walk
    .thumb_func
    .type etch_line_walk, %function
etch_line_walk:             @ p, n, along, aside, [e, du, dv, color]
    push {r4-r7, lr}
    mov r4, r8
    push {r4}
    lsls r2, #1             @ in bytes
    lsls r3, #1
    ldr r4, [sp, #28]
    negs r4, r4
    mov r8, r4              @ -du
    ldr r4, [sp, #24]       @ e
    ldr r7, [sp, #32]       @ dv
    lsls r6, r7, #1
    add r5, sp, #36
    ldrh r5, [r5]           @ color
    strh r5, [r0]

    lsrs r1, #1
    bcc .Lpairs
    adds r4, r7             @ an odd step
    bpl 1f
    along
    b .Lpairs
1:  add r4, r8
    aside
.Lpairs:
    lsrs r1, #1
    bcc .Lfours
    two_steps a
.Lfours:
    lsrs r1, #1
    bcc .Leights
    two_steps b
    two_steps c
.Leights:
    cmp r1, #0
    beq .Ldone
.Lloop:
    two_steps d
    two_steps e
    two_steps f
    two_steps g
    subs r1, #1
    bne .Lloop
.Ldone:
    pop {r4}
    mov r8, r4
    pop {r4-r7, pc}

    step_aside a
    step_aside b
    step_aside c
    step_aside d
    step_aside e
    step_aside f
    step_aside g
    .size etch_line_walk, . - etch_line_walk
