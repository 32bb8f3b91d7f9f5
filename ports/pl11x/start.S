@ ports/pl11x/start.S: from reset to main on an Arm core of the classic or the application profile.
    .syntax unified
    .arm
    .section .start, "ax"
    .global start
start:
    ldr sp, =link_stack_top
    ldr r0, =link_bss_start
    ldr r1, =link_bss_end
    mov r2, #0
1:  cmp r0, r1
    strlo r2, [r0], #4
    blo 1b
    bl main
    bl board_exit
2:  b 2b
