BOARDS += hifive1
hifive1_CC := riscv64-unknown-elf-gcc -march=rv32imac -mabi=ilp32 -msmall-data-limit=0
hifive1_SOURCES = $(addprefix ports/riscv/,start.S semihost.c) ports/hifive1/board.c $(FREESTANDING) $(SPI_LCD)
hifive1_LINK := -nostdlib -Llinker -T hifive1.ld -Wl,--no-warn-rwx-segments
hifive1_STRIP := 1280
hifive1_BUFFERS := 1
hifive1_FRAME := 320 240
hifive1_SCENES := shapes torus floor
hifive1_FLAGS := -DTEST_CANVAS_WORDS=400
hifive1_UNIT := bus channel clip clip_inverted clip_line fixed fog kernel_user lamp line_clip matrix \
    matrix_camera pictures shade stencil texture_environment vertex
hifive1_RUN := qemu-system-riscv32 -M sifive_e -display none -monitor none -serial null \
    -semihosting-config enable=on,target=native -kernel
hifive1_SPEED := 13.8 6.9 cpu 10024048
hifive1_SHOW := sh tests/targets/qemu_trace.sh qemu-system-riscv32 sifive_e ili9341 1 byte=10024048 \
    data.level=1001200c:2 select.level=1001200c:4 reset.level=1001200c:1
