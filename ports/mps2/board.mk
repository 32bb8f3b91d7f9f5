# One machine with other FPGA images: Cortex-M3, M4, and again M3 and M7 with panels that take other
# pixels than RGB565: 18 bits, and black and white.
MPS2 := mps2-an385 mps2-an386 mps2-ili9488 mps2-ssd1306
BOARDS += $(MPS2)
mps2_PINS := byte=40021008 data.level=4002804c:10 select.level=4002804c:1 reset.level=4002804c:8

mps2-an385_CC := arm-none-eabi-gcc -mcpu=cortex-m3 -mthumb
mps2-an386_CC := arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb
mps2-ili9488_CC := $(mps2-an385_CC)
mps2-ssd1306_CC := arm-none-eabi-gcc -mcpu=cortex-m7 -mthumb
mps2-ili9488_MACHINE := mps2-an385
mps2-ssd1306_MACHINE := mps2-an500
mps2-ili9488_FLAGS := -DMPS2_PANEL=etch_ili9488 -DMPS2_TURN=0
mps2-ssd1306_FLAGS := -DMPS2_PANEL=etch_ssd1306 -DMPS2_TURN=0
mps2-ili9488_FRAME := 320 480
mps2-ssd1306_FRAME := 128 64 ssd1306
mps2-ili9488_GLASS := ili9488 0
mps2-ssd1306_GLASS := ssd1306 0
mps2-ili9488_UNIT := kernel line pictures triangle
mps2-ssd1306_UNIT := kernel line pictures triangle
$(foreach b,$(MPS2),\
    $(eval $(b)_MACHINE ?= $(b))\
    $(eval $(b)_FRAME ?= 320 240)\
    $(eval $(b)_GLASS ?= ili9341 1)\
    $(eval $(b)_SOURCES = ports/mps2/board.c $$(CORTEX_M) $$(CORTEX_M_EXIT) $$(SPI_LCD))\
    $(eval $(b)_LINK := -nostdlib -Llinker -T mps2_lcd.ld)\
    $(eval $(b)_SPEED := 25 12.5 cpu 40021008)\
    $(eval $(b)_STRIP := 5120)\
    $(eval $(b)_BUFFERS := 1)\
    $(eval $(b)_RUN = $$(CORTEX_M_RUN) -M $$($(b)_MACHINE) -kernel)\
    $(eval $(b)_SHOW := sh tests/targets/qemu_trace.sh qemu-system-arm $$($(b)_MACHINE) $$($(b)_GLASS) \
        $(mps2_PINS)))
