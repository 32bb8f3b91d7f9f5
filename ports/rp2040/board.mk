BOARDS += rp2040
rp2040_CC := arm-none-eabi-gcc -mcpu=cortex-m0plus -mthumb
rp2040_SOURCES = $(addprefix ports/rp2040/,boot2.S board.c clocks.c cores.c) \
    ports/cortex_m/start.c \
    $(FREESTANDING) $(SPI_LCD)
RP2040_PANEL := etch_ili9341
rp2040_FLAGS = -DRP2040_PANEL=$(RP2040_PANEL)
rp2040_LINK := -nostdlib -Llinker -T rp2040.ld
rp2040_STRIP := 5120
rp2040_BUFFERS := 2
rp2040_FRAME := 320 240
rp2040_SHOW = sh tests/targets/rp2040js.sh ili9341 1 byte=1 data.level=2:1 select.level=2:2 \
    reset.level=2:4
rp2040_RUN = sh tests/targets/rp2040js.sh
rp2040_SPEED := 125 31.25 dma -
rp2040_UNIT := channel clip_inverted fog frame kernel_user lamp matrix mesh_small pictures shade \
    staged_user stencil texture_environment varying

# Files to drop on a real Pico: scenes, and what both cores draw (cores.mk).
$(BUILD)/rp2040-%.uf2: $(BUILD)/targets/rp2040/%.elf
	$(Q)arm-none-eabi-objcopy -O binary $< $@.bin
	$(Q)python3 ports/rp2040/uf2.py $@.bin $@
$(BUILD)/rp2040-cores.uf2: $(BUILD)/targets/rp2040-cores/2.elf
	$(Q)arm-none-eabi-objcopy -O binary $< $@.bin
	$(Q)python3 ports/rp2040/uf2.py $@.bin $@
.PHONY: uf2
uf2: $(BUILD)/targets/core.list ## images for a Raspberry Pi Pico
	@rm -f $(BUILD)/targets/rp2040/ports/rp2040/board.o # RP2040_PANEL may be another
	+$(Q)$(MAKE1) $(patsubst %,$(BUILD)/rp2040-%.uf2,$(TARGET_SCENES) cores)
