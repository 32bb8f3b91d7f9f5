# ports/riscv_virt/start.S: from reset to main on any RISC-V core. Others than the first wait.
    .section .start, "ax"
    .option arch, +zicsr
    .global start
start:
    csrr t0, mhartid
    bnez t0, wait
    la sp, link_stack_top
    la t0, link_bss_start
    la t1, link_bss_end
1:  bgeu t0, t1, 2f
    sw zero, 0(t0)
    addi t0, t0, 4
    j 1b
2:  call main
    call board_exit
wait:
    wfi
    j wait
