BOARDS += stm32vldiscovery
stm32vldiscovery_CC := arm-none-eabi-gcc -mcpu=cortex-m3 -mthumb
stm32vldiscovery_SOURCES = ports/stm32vldiscovery/board.c $(CORTEX_M) $(CORTEX_M_EXIT) $(SPI_LCD)
stm32vldiscovery_LINK := -nostdlib -Llinker -T stm32vldiscovery.ld
stm32vldiscovery_STRIP := 640
stm32vldiscovery_BUFFERS := 1
stm32vldiscovery_FRAME := 320 240
stm32vldiscovery_SCENES := shapes torus floor
stm32vldiscovery_FLAGS := -DTEST_CANVAS_WORDS=400
stm32vldiscovery_UNIT := bus channel clip clip_inverted clip_line fixed fog lamp line_clip matrix matrix_angle \
    matrix_camera shade stencil texture_environment vertex weights
stm32vldiscovery_RUN = $(CORTEX_M_RUN) -M stm32vldiscovery -kernel
stm32vldiscovery_SPEED := 8 4 cpu 4001300c
stm32vldiscovery_SHOW := sh tests/targets/qemu_trace.sh qemu-system-arm stm32vldiscovery ili9341 1 \
    byte=4001300c data.set=40010c10:2 data.clear=40010c10:20000 select.set=40010c10:1 \
    select.clear=40010c10:10000 reset.set=40010c10:20 reset.clear=40010c10:200000
