@ leaf/armv6m/flat.S: etch_kernel_flat for ARMv6-M, in place of fragment/flat.c.

#include "fill_row.inc"

    .section .text.etch_kernel_flat, "ax"
    .global etch_kernel_flat
    .thumb_func
    .type etch_kernel_flat, %function
etch_kernel_flat:           @ surface, y0, runs, n, [paint]
    push {r4-r7, lr}
    mov r4, r8
    mov r5, r9
    push {r4, r5}

    lsls r3, #2
    adds r3, r2
    mov lr, r3              @ end of the runs
    ldrh r4, [r0, #8]       @ surface->stride
    lsls r4, #1
    mov r9, r4
    ldrh r5, [r0, #12]      @ window.y0
    subs r5, r1, r5
    muls r4, r5
    ldrh r5, [r0, #10]      @ window.x0
    lsls r5, #1
    subs r4, r5
    ldr r5, [r0]            @ pixels
    adds r4, r5
    mov r8, r4              @ address of column 0
    ldr r3, [sp, #28]
    ldrh r3, [r3, #4]       @ paint->color
    spread
    ldr r7, =.Lend_of_short
    mov r12, r7

.Lrow:                      @ r2: runs, r8: address of column 0
    ldrh r0, [r2]
    ldrh r1, [r2, #2]
    subs r1, r0, r1         @ less the pixels
    lsls r0, #1
    add r0, r8
    adds r7, r1, #7
    bmi .Lwide
    lsls r7, r1, #1         @ at most 7: into a chain of single stores
    add r7, r12
    mov pc, r7
    strh r3, [r0, #12]
    strh r3, [r0, #10]
    strh r3, [r0, #8]
    strh r3, [r0, #6]
    strh r3, [r0, #4]
    strh r3, [r0, #2]
    strh r3, [r0]
.Lend_of_short:
    add r8, r9
    adds r2, #4
    cmp r2, lr
    bne .Lrow

.Lexit:
    pop {r4, r5}
    mov r8, r4
    mov r9, r5
    pop {r4-r7, pc}

.Lwide:
    negs r1, r1
    lsls r7, r0, #31        @ C = bit 1
    bcc .Leven
    strh r3, [r0]
    adds r0, #2
    subs r1, #1
.Leven:
    lsrs r7, r1, #3
    cmp r7, #64
    bhi .Llong
.Ljump:
    negs r7, r7
    adds r7, #64            @ stores to leave out
    lsls r7, #1
    add pc, r7
    nop
    store_chain .Lend_of_chain
    store_rest
    add r8, r9
    adds r2, #4
    cmp r2, lr
    bne .Lrow
    b .Lexit

.Llong:                     @ more than 64 stores: down to 64
    stmia r0!, {r3-r6}
    subs r1, #8
    subs r7, #1
    cmp r7, #64
    bhi .Llong
    b .Ljump
    .size etch_kernel_flat, . - etch_kernel_flat
    .ltorg
