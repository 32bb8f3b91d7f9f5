# Both cores of the RP2040 draw a frame, in rp2040js with a second core in lock step; the torus is
# that of tests/workers with fewer triangles. Included by the Makefile.
CORES_DIR   := $(BUILD)/targets/rp2040-cores
CORES_TORUS := -DTORUS_AROUND=60 -DTORUS_ALONG=30
CORES_SRC   := tests/targets/cores.c tests/workers/torus.c core/draw/retained_rows.c

$(CORES_DIR)/reference: tests/targets/cores_reference.c tests/workers/torus.c $(LIB)
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS_HOST) $(CORES_TORUS) $^ -o $@

$(CORES_DIR)/%.elf: $(CORES_SRC) $(BUILD)/targets/rp2040/used.a
	@mkdir -p $(@D)
	$(Q)$(rp2040_CC) $(TARGET_FLAGS) $(CORES_TORUS) -DCORES=$* $(rp2040_LINK) -Wl,--gc-sections \
	    $(CORES_SRC) $(rp2040_SOURCES) $(filter %.a,$^) -lgcc -o $@

.PHONY: run-rp2040-cores
run-rp2040-cores: $(CORES_DIR)/reference $(BUILD)/targets/glass $(BUILD)/targets/core.list
	+$(Q)$(MAKE1) $(CORES_DIR)/1.elf $(CORES_DIR)/2.elf
	$(Q)BUILD=$(BUILD) sh tests/targets/cores.sh $(CORES_DIR) "$(rp2040_SHOW)"

TARGET_STEPS += run-rp2040-cores
