# The screen shows each pixel four times as wide and high.
BOARDS += lm3s6965evb
lm3s6965evb_CC := arm-none-eabi-gcc -mcpu=cortex-m3 -mthumb
lm3s6965evb_SOURCES = ports/lm3s6965evb/board.c $(CORTEX_M) $(CORTEX_M_IDLE) $(SPI_LCD)
lm3s6965evb_LINK := -nostdlib -Llinker -T lm3s6965evb.ld
lm3s6965evb_STRIP := 2048
lm3s6965evb_BUFFERS := 1
lm3s6965evb_FRAME := 128 64 ssd0323
lm3s6965evb_FLAGS := -DTEST_CANVAS_WORDS=2400
lm3s6965evb_UNIT := bus channel clip clip_inverted clip_line fixed fog lamp light line line_clip matrix \
    matrix_angle matrix_camera mesh_small rect shade stencil texture_environment triangle varying vertex \
    weights
lm3s6965evb_RUN = $(CORTEX_M_RUN) -M lm3s6965evb -kernel
lm3s6965evb_SHOW := python3 tests/targets/qemu_screen.py 4 qemu-system-arm -M lm3s6965evb \
    -semihosting-config enable=on,target=native -kernel
lm3s6965evb_SPEED := 12 6 cpu 40008008
