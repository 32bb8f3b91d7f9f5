@ bench/model.S: code whose Cortex-M0+ cycles are known by hand (manual's table of timings), for
@ selftest.sh. Instructions and cycles between the markers, the sum of the columns:
@ EXPECT 24 55
    .syntax unified
    .cpu cortex-m0plus
    .thumb
    .section .vectors, "a"
    .word 0x20001000, reset

    .text
    .thumb_func
    .type bench_counted, %function
bench_counted:              @ runs cycles
    push {r4, r5, lr}       @  1   1 + 3
    ldr r4, =0x20000100     @  1   2
    movs r0, #3             @  1   1
    movs r1, #7             @  1   1
    muls r1, r0             @  1   1
    stmia r4!, {r0-r3}      @  1   1 + 4
    subs r4, #16            @  1   1
    ldmia r4!, {r0-r3}      @  1   1 + 4
    ldr r5, [sp, #4]        @  1   2
    strb r1, [r4]           @  1   2
1:  subs r0, #1             @  3   1
    bne 1b                  @  3   2 + 2 + 1
    mrs r2, PRIMASK         @  1   3
    bl leaf                 @  1   3
    ldr r3, =2f             @  1   2
    mov pc, r3              @  1   2
    nop
2:  b 3f                    @  1   2
    nop
3:  pop {r4, r5, pc}        @  1   3 + 3
    .size bench_counted, . - bench_counted

    .thumb_func
    .type leaf, %function
leaf:
    bx lr                   @  1   2
    .size leaf, . - leaf

    .thumb_func
    .type bench_done, %function
bench_done:
    bx lr
    .size bench_done, . - bench_done

    .global reset
    .thumb_func
    .type reset, %function
reset:
    bl bench_counted
    bl bench_done           @  1   3
    ldr r1, =stop
    movs r0, #0x20
    bkpt 0xAB
    b .
    .size reset, . - reset
    .balign 4
stop: .word 0x20026, 0
