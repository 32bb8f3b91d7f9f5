# Three screens as a product would ship (product.h): on the simulated panel against frozen pictures, and as
# firmware of the RP2040: within 24 KB of RAM, and the same pictures in its emulator. Included by the
# Makefile.
TEST_STEPS  += product
CHECK_STEPS += product-ram product-run

PRODUCT_DIR     := $(BUILD)/product
PRODUCT_SCREENS := cluster:20 chart:52 menu:16 # NAME:TICK of the frozen pictures
PRODUCT_PARTS   := $(addprefix tests/product/,cluster.c chart.c plot.c menu.c parts.c symbols.c)

$(PRODUCT_DIR)/photo.c: $(BUILD)/etch-image tests/scenes/lake.ppm
	@mkdir -p $(@D)
	$(Q)$(RUN) $(BUILD)/etch-image -f rgb565 -n product_photo tests/scenes/lake.ppm >$@ 2>$@.said || \
	    { cat $@.said; rm -f $@; exit 1; }
$(PRODUCT_DIR)/photo.o: $(PRODUCT_DIR)/photo.c
	$(Q)$(CC) $(CFLAGS_HOST) -c $< -o $@
$(PRODUCT_DIR)/show: $(call obj,$(PRODUCT_PARTS) tests/product/show.c) $(PRODUCT_DIR)/photo.o \
    $(SIMLIB) $(LIB)
	$(Q)$(CC) $(OPT) $(EXTRA) $^ -o $@
-include $(patsubst %.o,%.d,$(call obj,$(PRODUCT_PARTS) tests/product/show.c))

PRODUCT = $(Q)BUILD=$(BUILD) RUN="$(RUN)" sh tests/product/run
.PHONY: product product-update product-demo
product: $(PRODUCT_DIR)/show $(PICTURES) ## the three product screens on the simulated panel
	$(PRODUCT) test $(PRODUCT_SCREENS)
product-update: $(PRODUCT_DIR)/show ## takes what they show now as frozen
	$(PRODUCT) update $(PRODUCT_SCREENS)
product-demo: $(PRODUCT_DIR)/show
	$(PRODUCT) demo $(PRODUCT_SCREENS)
demo: product-demo

# ---- the same as firmware: two strips by DMA ------------------------------------------------------
# Objects with gcc's call graphs beside them, as `make stack` has them for core and hal.
PRODUCT_BOARD := $(PRODUCT_PARTS) $(PRODUCT_DIR)/photo.c $(sort $(wildcard ports/spi_lcd/*.c)) \
    ports/freestanding/memory.c ports/cortex_m/start.c \
    $(addprefix ports/rp2040/,boot2.S board.c clocks.c cores.c)
PRODUCT_CORE  := $(patsubst %.c,$(BUILD)/stack/%.o,$(CORE) $(HAL))
PRODUCT_OBJ    = $(PRODUCT_DIR)/board/$(basename $(patsubst $(BUILD)/%,%,$(1))).o
PRODUCT_CC    := $(rp2040_CC) $(WARN) -ffreestanding -O2 -g -I. -ffunction-sections -fdata-sections \
                 -fcallgraph-info=su
PRODUCT_ELF   := $(foreach s,$(PRODUCT_SCREENS),$(PRODUCT_DIR)/$(firstword $(subst :, ,$(s))).elf)

$(foreach f,$(PRODUCT_BOARD),$(eval $(call PRODUCT_OBJ,$(f)): $(f)))
$(foreach f,$(PRODUCT_BOARD),$(call PRODUCT_OBJ,$(f))):
	@mkdir -p $(@D)
	$(Q)$(PRODUCT_CC) -c $< -o $@
$(PRODUCT_DIR)/core.a: $(PRODUCT_CORE)
	@mkdir -p $(@D) && rm -f $@
	$(Q)$(AR) rcs $@ $^
$(foreach s,$(PRODUCT_SCREENS),$(eval \
    $(PRODUCT_DIR)/$(firstword $(subst :, ,$(s))).o: PRODUCT_SCREEN = $(subst :, ,$(s))))
$(PRODUCT_ELF:.elf=.o): tests/product/firmware.c
	@mkdir -p $(@D)
	$(Q)$(PRODUCT_CC) -DSCREEN=product_$(word 1,$(PRODUCT_SCREEN)) -DTICK=$(word 2,$(PRODUCT_SCREEN)) \
	    -c $< -o $@
$(PRODUCT_ELF): %.elf: %.o $(foreach f,$(PRODUCT_BOARD),$(call PRODUCT_OBJ,$(f))) \
    $(PRODUCT_DIR)/core.a
	$(Q)$(rp2040_CC) $(rp2040_LINK) -Wl,--gc-sections -Wl,--fatal-warnings $^ -lgcc -o $@

.PHONY: product-ram product-run
product-ram: $(PRODUCT_ELF) ## their RAM on the RP2040, all counted, against 24 KB
	$(Q)if python3 tests/product/ram.py 16000 $(BUILD)/stack $(PRODUCT_DIR) $(PRODUCT_ELF) \
	    >$(PRODUCT_DIR)/ram.log; then echo "ram.py accepts programs above its limit"; exit 1; fi
	$(Q)python3 tests/product/ram.py 24576 $(BUILD)/stack $(PRODUCT_DIR) $(PRODUCT_ELF)
product-run: $(PRODUCT_ELF) $(PRODUCT_DIR)/show $(BUILD)/targets/glass ## they run in rp2040js
	$(PRODUCT) firmware $(PRODUCT_SCREENS)
