# Two boards of one folder: Cortex-M3 and Cortex-M4.
BOARDS += mps2-an385 mps2-an386
mps2_GLASS := ili9341 1 byte=40021008 data.level=4002804c:10 select.level=4002804c:1 \
    reset.level=4002804c:8

mps2-an385_CC := arm-none-eabi-gcc -mcpu=cortex-m3 -mthumb
mps2-an386_CC := arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb
$(foreach b,mps2-an385 mps2-an386,\
    $(eval $(b)_SOURCES = ports/mps2/board.c $$(CORTEX_M) $$(CORTEX_M_EXIT) $$(SPI_LCD))\
    $(eval $(b)_LINK := -nostdlib -Llinker -T mps2_lcd.ld)\
    $(eval $(b)_STRIP := 5120)\
    $(eval $(b)_BUFFERS := 1)\
    $(eval $(b)_FRAME := 320 240)\
    $(eval $(b)_SHOW := sh tests/targets/qemu_trace.sh qemu-system-arm $(b) $(mps2_GLASS)))
mps2-an385_RUN := qemu-system-arm -M mps2-an385 -display none -monitor none -serial null \
    -semihosting-config enable=on,target=native -kernel
