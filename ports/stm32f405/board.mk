BOARDS += stm32f405
stm32f405_CC := arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb
stm32f405_SOURCES = ports/stm32f405/board.c $(CORTEX_M) $(CORTEX_M_EXIT) $(SPI_LCD)
stm32f405_LINK := -nostdlib -Llinker -T stm32f405.ld
stm32f405_STRIP := 5120
stm32f405_BUFFERS := 1
stm32f405_FRAME := 320 240
stm32f405_SHOW := sh tests/targets/qemu_trace.sh qemu-system-arm netduinoplus2 ili9341 1 \
    byte=4001300c $(foreach p,data:1:2 select:0:1 reset:2:4,\
    $(word 1,$(subst :, ,$(p))).set=40020418:$(word 3,$(subst :, ,$(p)))\
    $(word 1,$(subst :, ,$(p))).clear=40020418:$(word 3,$(subst :, ,$(p)))0000)
stm32f405_RUN = $(CORTEX_M_RUN) -M netduinoplus2 -kernel
stm32f405_UNIT := bus channel clip clip_inverted clip_line fixed fog lamp light line line_clip matrix \
    matrix_angle matrix_camera mesh_shaded mesh_small mipmap pictures rect shade stencil texture_environment \
    triangle varying vertex weights
stm32f405_SPEED := 16 8 cpu 4001300c
