@ leaf/armv6m/fill.S: etch_fill_rows for ARMv6-M, in place of base/fill.c.
@
@ Where a row jumps to depends on its width and on whether it begins at an odd halfword: both
@ jumps are worked out once. Rows above 512 pixels go by 14 pixels a store.

#include "fill_row.inc"

    .section .text.etch_fill_rows, "ax"
    .global etch_fill_rows
    .thumb_func
    .type etch_fill_rows, %function
etch_fill_rows:             @ p, n, value, rows, [stride]
    push {r4-r7, lr}
    mov r4, r8
    mov r5, r9
    mov r6, r10
    mov r7, r11
    push {r4-r7}
    mov r8, r0
    ldr r4, [sp, #36]
    lsls r4, #1
    mov r9, r4
    mov r0, r3
    mov r3, r2
    mov r2, r0              @ rows
    spread
    lsrs r7, r1, #9
    bne .Llong

    ldr r7, =.Lend_of_chain
    mov r10, r1             @ pixels and jump of a row that begins with a whole word
    lsrs r0, r1, #3
    lsls r0, #1
    subs r0, r7, r0
    mov r11, r0
    subs r1, #1
    mov r12, r1             @ the same after an odd halfword
    lsrs r0, r1, #3
    lsls r0, #1
    subs r0, r7, r0
    mov lr, r0

.Lrow:
    mov r0, r8
    add r8, r9
    lsls r7, r0, #31        @ C = bit 1
    bcs .Lodd
    mov r1, r10
    mov pc, r11
.Lodd:
    strh r3, [r0]
    adds r0, #2
    mov r1, r12
    mov pc, lr
    store_chain .Lend_of_chain
    store_rest
    subs r2, #1
    bne .Lrow

.Ldone:
    pop {r4-r7}
    mov r8, r4
    mov r9, r5
    mov r10, r6
    mov r11, r7
    pop {r4-r7, pc}

    .align 2
.Llong:                     @ r1: pixels, at least 512
    mov r10, r2             @ rows
    mov r11, r1
.Llong_row:
    mov r0, r8
    mov r1, r11
    lsls r7, r0, #31
    bcc 1f
    strh r3, [r0]
    adds r0, #2
    subs r1, #1
1:  lsls r7, r1, #1
    adds r7, r0
    mov lr, r7              @ end of the row
    movs r2, #224
    lsls r2, #1
    subs r7, r2
    mov r12, r7             @ the last address where 224 pixels fit
    mov r1, r3
    mov r2, r3
    mov r7, r3
2:  .rept 16
    stmia r0!, {r1-r7}
    .endr
    cmp r0, r12
    bls 2b
    mov r1, lr
    subs r1, r0
    lsrs r1, #1             @ pixels left, below 224
    lsrs r7, r1, #3
    beq 4f
3:  stmia r0!, {r3-r6}
    subs r7, #1
    bne 3b
4:  store_rest
    add r8, r9
    mov r2, r10
    subs r2, #1
    mov r10, r2
    bne .Llong_row
    b .Ldone
    .size etch_fill_rows, . - etch_fill_rows
    .ltorg
