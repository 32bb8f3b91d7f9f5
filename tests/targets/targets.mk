# Boards under emulation: every scene of scenes.c on every board of ports/*/board.mk, compared bit
# for bit with the host's frame by what reached the display. A board.mk says
#
#   BOARDS += NAME
#   NAME_CC      compiler, with what chooses the CPU        NAME_LINK     linker script and flags
#   NAME_SOURCES start-up, bus, panel                        NAME_STRIP    pixels in a strip
#   NAME_BUFFERS 1 or 2                                      NAME_FRAME    "WIDTH HEIGHT" it shows
#   NAME_RUN     command that runs the unit tests, unit.elf, and prints what they say
#   NAME_UNIT    names of their suites; without it all that need no C library
#   NAME_LIBS    to link with, -lgcc                         NAME_AR       ar
#   NAME_FLAGS   more for the compiler, behind what all boards have
#   NAME_SHOW    command that runs an ELF file and writes what the display shows, big-endian RGB565:
#                it is called as  NAME_SHOW ELF >FRAME  in the top folder, with BUILD set


FREESTANDING := ports/freestanding/memory.c
CORTEX_M := $(addprefix ports/cortex_m/,start.c print.c) $(FREESTANDING)
CORTEX_M_EXIT := ports/cortex_m/exit.c # ends the emulation
CORTEX_M_IDLE := ports/cortex_m/idle.c # goes on to show the screen
SPI_LCD := $(sort $(wildcard ports/spi_lcd/*.c))


TARGET_DIR := $(BUILD)/targets
TARGET_SCENES := shapes torus floor
TARGET_MAIN := tests/targets/scenes.c
TARGET_FLAGS := $(WARN) -ffreestanding -DTEST_DIVISOR=100 -O2 -g -ffunction-sections -fdata-sections -I.

$(TARGET_DIR)/reference: $(call obj,tests/targets/reference.c tests/targets/scenes.c $(SPI_LCD)) \
    $(SIMLIB) $(LIB)
	@mkdir -p $(@D)
	$(Q)$(CC) $(OPT) $(EXTRA) $^ -o $@
$(TARGET_DIR)/glass: $(call obj,tests/targets/glass.c) $(SIMLIB) $(LIB)
	@mkdir -p $(@D)
	$(Q)$(CC) $(OPT) $(EXTRA) $^ -o $@

# The files of core that the scenes link, so that a board compiles no others for them.
$(TARGET_DIR)/core.list: $(call obj,tests/targets/reference.c tests/targets/scenes.c $(SPI_LCD)) \
    $(SIMLIB) $(LIB)
	@mkdir -p $(@D)
	$(Q)rm -f $(TARGET_DIR)/thin.a && $(AR) rcsT $(TARGET_DIR)/thin.a $(call obj,$(CORE) $(HAL))
	$(Q)$(CC) $(OPT) $(EXTRA) $(filter %.o,$^) $(SIMLIB) $(TARGET_DIR)/thin.a \
	    -Wl,-Map=$(TARGET_DIR)/thin.map -o $(TARGET_DIR)/thin
	$(Q)sed -n 's|^[^ ]*/\(core/[a-z0-9_/]*\)\.o$$|\1.c|p' $(TARGET_DIR)/thin.map | sort -u >$@
USED :=

# The suites that need neither a C library nor the simulated panel, and what they are linked with.
TARGET_UNIT := $(basename $(notdir $(shell grep -L \
    'ports/\|panel_parts\|test_trips\|<stdio\|<stdlib\|<string' tests/unit/*.c)))
TARGET_HARNESS := $(filter-out tests/harness/host.c tests/harness/asserts.c,$(wildcard tests/harness/*.c tests/oracle/*.c)) \
    tests/exhaustive/triangles.c tests/exhaustive/clipped.c

# $(call board,NAME): objects, a library of core and hal, a firmware for each scene.
define board
$(1)_LIBS ?= -lgcc
$(1)_AR ?= $(AR)
$(1)_OBJ := $$(patsubst %,$(TARGET_DIR)/$(1)/%.o,$$(basename $$($(1)_SOURCES) $(TARGET_MAIN)))
$(TARGET_DIR)/$(1)/%.o: %.c
	@mkdir -p $$(@D)
	$(Q)$$($(1)_CC) $(TARGET_FLAGS) $$($(1)_FLAGS) -MMD -MP -c $$< -o $$@
$(TARGET_DIR)/$(1)/%.o: %.S
	@mkdir -p $$(@D)
	$(Q)$$($(1)_CC) -I. -c $$< -o $$@
$(TARGET_DIR)/$(1)/libetch.a: $$(patsubst %.c,$(TARGET_DIR)/$(1)/%.o,$(CORE) $(HAL))
	@rm -f $$@
	$(Q)$$($(1)_AR) rcs $$@ $$^
$(TARGET_DIR)/$(1)/used.a: $$(patsubst %.c,$(TARGET_DIR)/$(1)/%.o,$$(USED) $(HAL))
	@rm -f $$@
	$(Q)$$($(1)_AR) rcs $$@ $$^
$(TARGET_DIR)/$(1)/%.elf: tests/targets/firmware.c $$($(1)_OBJ) $(TARGET_DIR)/$(1)/used.a
	$(Q)$$($(1)_CC) $(TARGET_FLAGS) $$($(1)_FLAGS) -DSCENE=$$* -DSTRIP=$$($(1)_STRIP) -DBUFFERS=$$($(1)_BUFFERS) \
	    $$($(1)_LINK) -Wl,--gc-sections -Wl,--fatal-warnings $$^ $$($(1)_LIBS) -o $$@
run-$(1): $(TARGET_DIR)/reference $(TARGET_DIR)/glass $(TARGET_DIR)/core.list
	+$(Q)$(MAKE1) $(foreach n,0 1 2,$(TARGET_DIR)/$(1)/$(n).elf) \
	    USED="$$$$(cat $(TARGET_DIR)/core.list)"
	$(Q)BUILD=$(BUILD) sh tests/targets/compare.sh $(1) "$$($(1)_FRAME)" "$$($(1)_SHOW)" \
	    $(TARGET_SCENES)
$(TARGET_DIR)/$(1)/suites.c: $(TARGET_DIR)/$(1)/core/base/surface.o FORCE
	$(Q)sh tests/targets/suites.sh $$@ $$(or $$($(1)_UNIT),$(TARGET_UNIT))
$(TARGET_DIR)/$(1)/suites.o: $(TARGET_DIR)/$(1)/suites.c
	$(Q)$$($(1)_CC) $(TARGET_FLAGS) $$($(1)_FLAGS) -c $$< -o $$@
$(1)_UNIT_OBJ := $$(patsubst %.c,$(TARGET_DIR)/$(1)/%.o,$$(patsubst %,tests/unit/%.c,\
    $$(or $$($(1)_UNIT),$(TARGET_UNIT))) $(TARGET_HARNESS) tests/targets/unit.c $$($(1)_SOURCES:.S=.c))
$(TARGET_DIR)/$(1)/unit.elf: $$($(1)_UNIT_OBJ) $(TARGET_DIR)/$(1)/suites.o \
    $(TARGET_DIR)/$(1)/libetch.a
	$(Q)$$($(1)_CC) $$($(1)_LINK) -Wl,--gc-sections $$^ $$($(1)_LIBS) -o $$@
unit-$(1): $(TARGET_DIR)/$(1)/unit.elf
	$(Q)python3 tests/targets/until.py $$($(1)_RUN) $$<
.PHONY: run-$(1) unit-$(1)
.PRECIOUS: $(TARGET_DIR)/$(1)/%.o $(TARGET_DIR)/$(1)/%.elf
-include $$(patsubst %.o,%.d,$$($(1)_OBJ))
endef
$(foreach b,$(BOARDS),$(eval $(call board,$(b))))

CHECK_STEPS += test-targets
.PHONY: test-targets
test-targets: ## every board under emulation
	$(call steps,targets,$(addprefix run-,$(BOARDS)) $(TARGET_STEPS) \
	    $(foreach b,$(BOARDS),$(if $($(b)_RUN),unit-$(b))))
