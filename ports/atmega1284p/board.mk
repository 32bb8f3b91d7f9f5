BOARDS += atmega1284p
atmega1284p_CC := avr-gcc -mmcu=atmega1284p -Os
atmega1284p_SOURCES = ports/atmega1284p/board.c ports/atmega1284p/exit.S $(SPI_LCD)
atmega1284p_LINK :=
atmega1284p_STRIP := 1280
atmega1284p_BUFFERS := 1
atmega1284p_FRAME := 160 128
atmega1284p_SCENES := shapes torus floor
atmega1284p_FLAGS := -DTEST_CANVAS_WORDS=400
atmega1284p_UNIT := bus channel clip_inverted fog kernel_user matrix pictures
atmega1284p_RUN = sh tests/targets/simavr.sh
atmega1284p_SPEED := 16 8 cpu -
atmega1284p_SHOW = sh tests/targets/simavr.sh st7735-red 1 byte=4e data.level=25:2 \
    select.level=25:10 reset.level=25:1
$(BUILD)/targets/simavr: tests/targets/simavr.c
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS_HOST) $< -o $@ -lsimavr -lelf
run-atmega1284p unit-atmega1284p $(BUILD)/targets/atmega1284p/speed: $(BUILD)/targets/simavr
