# ports/riscv/start.S: from reset to main in flash: initialised data are copied. The symbols link_* are
# those of linker/cortex_m.ld.
    .section .vectors, "ax"
    .global reset
reset:
    la sp, link_stack_top
    la t0, link_data_start
    la t1, link_data_end
    la t2, link_data_load
1:  bgeu t0, t1, 2f
    lw t3, 0(t2)
    sw t3, 0(t0)
    addi t0, t0, 4
    addi t2, t2, 4
    j 1b
2:  la t0, link_bss_start
    la t1, link_bss_end
3:  bgeu t0, t1, 4f
    sw zero, 0(t0)
    addi t0, t0, 4
    j 3b
4:  call main
    call board_exit
