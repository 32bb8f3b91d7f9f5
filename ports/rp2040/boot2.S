@ ports/rp2040/boot2.S: second boot stage. The boot ROM copies these 252 bytes (and a checksum, which
@ uf2.py adds) from flash to RAM and runs them: they let the flash be read as memory, by the plain
@ read command 03 that every chip knows, and start the program behind them.
@ Source: Raspberry Pi, RP2040 data sheet, 2.8.1 and 4.10.
    .syntax unified
    .cpu cortex-m0plus
    .thumb
    .section .boot2, "ax"
    ldr r3, =0x18000000     @ SSI, the flash interface
    movs r0, #0
    str r0, [r3, #0x08]     @ SSIENR: off while it is set up
    movs r0, #4
    str r0, [r3, #0x14]     @ BAUDR: system clock / 4
    ldr r0, =0x001F0300     @ CTRLR0: 32 bits a frame, write then read
    str r0, [r3, #0x00]
    movs r0, #0
    str r0, [r3, #0x04]     @ CTRLR1: one frame a read
    ldr r0, =0x03000218     @ SPI_CTRLR0: command 03, 8 bits of it, 24 of address
    ldr r1, =0x180000F4
    str r0, [r1]
    movs r0, #1
    str r0, [r3, #0x08]     @ SSIENR: on
    ldr r0, =0x10000100     @ the program's vectors
    ldr r1, =0xE000ED08
    str r0, [r1]            @ VTOR
    ldr r1, [r0]
    msr msp, r1
    ldr r1, [r0, #4]
    bx r1
    .ltorg
