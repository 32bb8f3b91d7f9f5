BOARDS += microbit
microbit_CC := arm-none-eabi-gcc -mcpu=cortex-m0 -mthumb
microbit_SOURCES = ports/microbit/board.c $(CORTEX_M) $(CORTEX_M_EXIT) $(SPI_LCD)
microbit_LINK := -nostdlib -Llinker -T microbit.ld
microbit_STRIP := 1280
microbit_BUFFERS := 1
microbit_FRAME := 320 240
microbit_SCENES := shapes torus floor
microbit_FLAGS := -DTEST_CANVAS_WORDS=400
microbit_UNIT := bus channel clip clip_inverted clip_line fixed fog kernel_user lamp line_clip matrix \
    matrix_angle matrix_camera pictures shade stencil texture_environment vertex weights
microbit_RUN = $(CORTEX_M_RUN) -M microbit -kernel
microbit_SHOW := sh tests/targets/qemu_trace.sh qemu-system-arm microbit ili9341 1 byte=4000351c \
    data.set=50000508:2 data.clear=5000050c:2 select.set=50000508:4 select.clear=5000050c:4 \
    reset.set=50000508:8 reset.clear=5000050c:8
microbit_SPEED := 16 8 cpu 4000351c
