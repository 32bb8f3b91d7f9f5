# Boards under emulation: scenes of scenes.c and unit tests on every board of ports/*/board.mk. Scenes
# are compared bit for bit with the host's frame by what reached the display. A board.mk says
#
#   BOARDS += NAME
#   NAME_CC      compiler, with what chooses the CPU        NAME_LINK     linker script and flags
#   NAME_SOURCES start-up, bus, panel                       NAME_STRIP    pixels in a strip
#   NAME_BUFFERS 1 or 2                                     NAME_FRAME    "WIDTH HEIGHT" it shows
#   NAME_SHOW    command that runs an ELF file and writes what the display shows, big-endian RGB565:
#                it is called as  NAME_SHOW ELF >FRAME  in the top folder, with BUILD set
#   NAME_RUN     command that runs the unit tests, unit.elf, and prints what they say
# and, where it differs,
#   NAME_SCENES  without those that need more memory        NAME_FLAGS    more for its own C files
#   NAME_UNIT    suites, where not all fit into its memory  NAME_LIBS     to link with, -lgcc
#   NAME_AR      ar                                         NAME_SPEED    see throughput.py
# BUILT_BOARDS are boards that nothing here can run.
# A third word of NAME_FRAME is the panel, where it shows other colours than RGB565.

FREESTANDING := ports/freestanding/memory.c
CORTEX_M := $(addprefix ports/cortex_m/,start.c print.c) $(FREESTANDING)
CORTEX_M_EXIT := ports/cortex_m/exit.c # ends the emulation
CORTEX_M_IDLE := ports/cortex_m/idle.c # goes on to show the screen
CORTEX_M_RUN := qemu-system-arm -display none -monitor none -serial null \
    -semihosting-config enable=on,target=native
SPI_LCD := $(sort $(wildcard ports/spi_lcd/*.c))

TARGET_DIR    := $(BUILD)/targets
TARGET_SCENES := shapes torus floor mesh
TARGET_FLAGS  := $(WARN) -ffreestanding -DTEST_DIVISOR=100 -O2 -ffunction-sections -fdata-sections -I.

# ---- the host's side -----------------------------------------------------------------------------

$(TARGET_DIR)/reference: $(call obj,$(addprefix tests/targets/,reference.c scenes.c torus.c) $(SPI_LCD)) \
    $(SIMLIB) $(LIB)
	@mkdir -p $(@D)
	$(Q)$(CC) $(OPT) $(EXTRA) $^ -o $@
$(TARGET_DIR)/glass: $(call obj,tests/targets/glass.c) $(SIMLIB) $(LIB)
	@mkdir -p $(@D)
	$(Q)$(CC) $(OPT) $(EXTRA) $^ -o $@

# Lists of the files that programs link, so that a board compiles no others: the host links the same
# program and says what it took. core.list is of the scenes, NAME/unit.list of a board's suites.
$(TARGET_DIR)/thin.a: $(call obj,$(CORE) $(HAL) $(filter-out $(UNIT),$(TEST)))
	@mkdir -p $(@D)
	$(Q)rm -f $@ && $(AR) rcsT $@ $^
$(TARGET_DIR)/core.list: $(call obj,$(addprefix tests/targets/,reference.c scenes.c torus.c) $(SPI_LCD)) \
    $(SIMLIB) $(TARGET_DIR)/thin.a
	$(Q)sh tests/targets/list.sh $@ $(CC) $(OPT) $(EXTRA) $^
TARGET_USED = $(shell cat $(TARGET_DIR)/core.list 2>/dev/null)

# The suites that need neither a C library nor the simulated panel, and what they are linked with.
TARGET_UNIT := $(basename $(notdir $(shell grep -L \
    'ports/\|panel_parts\|test_trips\|<stdio\|<stdlib\|<string' tests/unit/*.c)))
TARGET_HARNESS := $(filter-out tests/harness/host.c tests/harness/asserts.c,$(wildcard tests/harness/*.c tests/oracle/*.c)) \
    tests/exhaustive/triangles.c tests/exhaustive/clipped.c

# ---- objects -------------------------------------------------------------------------------------

# Boards of one compiler and CPU share the objects of core, hal and the panels. A board's own flags for
# the CPU come last, so that they win.
empty :=
target_cpu = $(TARGET_DIR)/cpu/$(subst =,-,$(subst $(empty) $(empty),,$($(1)_CC)))
target_cc = $(firstword $($(1)_CC)) $(TARGET_FLAGS) $(wordlist 2,99,$($(1)_CC))
# $(call target_obj,NAME,FILES)
target_obj = $(foreach f,$(basename $(2)),$(if $(filter core/% hal/% ports/spi_lcd/% ports/framebuffer/%,\
    $(f)),$(call target_cpu,$(1)),$(TARGET_DIR)/$(1))/$(f).o)

define cpu
$(call target_cpu,$(1))/%.o: %.c
	@mkdir -p $$(@D)
	$(Q)$(call target_cc,$(1)) -MMD -MP -c $$< -o $$@
endef
ALL_BOARDS = $(BOARDS) $(BUILT_BOARDS)
$(foreach c,$(sort $(foreach b,$(ALL_BOARDS),$(call target_cpu,$(b)))),$(eval $(call cpu,$(firstword \
    $(foreach b,$(ALL_BOARDS),$(if $(filter $(c),$(call target_cpu,$(b))),$(b)))))))

# ---- programs ------------------------------------------------------------------------------------

# $(call board,NAME): a firmware for each scene, one of unit tests; how they are run.
define board
$(1)_LIBS ?= -lgcc
$(1)_AR ?= $(AR)
$(1)_SCENES ?= $(TARGET_SCENES)
$(1)_ELFS := $$($(1)_SCENES:%=$(TARGET_DIR)/$(1)/%.elf)
$(1)_SUITES := $$(or $$($(1)_UNIT),$(TARGET_UNIT))
$(1)_CORE = $$(sort $(HAL) $$(if $$($(1)_UNIT),$$(shell cat $(TARGET_DIR)/$(1)/unit.list 2>/dev/null),\
    $(CORE) $(TARGET_HARNESS)))
$(1)_OBJ = $$(call target_obj,$(1),$$($(1)_SOURCES) tests/targets/scenes.c tests/targets/torus.c)
$(1)_UNIT_OBJ = $$(call target_obj,$(1),$$($(1)_SOURCES) tests/targets/unit.c $$($(1)_SUITES:%=tests/unit/%.c))
$(TARGET_DIR)/$(1)/%.o: %.c
	@mkdir -p $$(@D)
	$(Q)$$(call target_cc,$(1)) $$($(1)_FLAGS) -MMD -MP -c $$< -o $$@
$(TARGET_DIR)/$(1)/%.o: %.S
	@mkdir -p $$(@D)
	$(Q)$$($(1)_CC) -I. -c $$< -o $$@
$(TARGET_DIR)/$(1)/used.a: $$(call target_obj,$(1),$$(sort $$(TARGET_USED) $(HAL))) $(TARGET_DIR)/core.list
	@mkdir -p $$(@D) && rm -f $$@
	$(Q)$$($(1)_AR) rcs $$@ $$(filter %.o,$$^)
$(TARGET_DIR)/$(1)/%.elf: tests/targets/firmware.c $$($(1)_OBJ) $(TARGET_DIR)/$(1)/used.a
	$(Q)$$(call target_cc,$(1)) -DSCENE=target_$$* -DSTRIP=$$($(1)_STRIP) -DBUFFERS=$$($(1)_BUFFERS) \
	    $$($(1)_LINK) -Wl,--gc-sections -Wl,--fatal-warnings $$^ $$($(1)_LIBS) -o $$@
$(TARGET_DIR)/$(1)/spin-%.elf: tests/targets/spin.c $$($(1)_OBJ) $(TARGET_DIR)/$(1)/used.a
	$(Q)$$(call target_cc,$(1)) -DFRAMES=$$* -DSTRIP=$$($(1)_STRIP) -DBUFFERS=$$($(1)_BUFFERS) \
	    $$($(1)_LINK) -Wl,--gc-sections -Wl,--fatal-warnings $$^ $$($(1)_LIBS) -o $$@
$(TARGET_DIR)/$(1)/speed: $(TARGET_DIR)/$(1)/spin-0.elf $(TARGET_DIR)/$(1)/spin-8.elf $(BUILD)/bench/plugin.so
	$(Q)BUILD=$(BUILD) NM=$$(subst -gcc,-nm,$$(firstword $$($(1)_CC))) python3 \
	    tests/targets/throughput.py $(BUILD) $(1) $$($(1)_SPEED) $$($(1)_RUN) >$$@.new && mv $$@.new $$@
firmware-$(1): $$($(1)_ELFS)
build-$(1): $(TARGET_DIR)/core.list
	+$(Q)$(MAKE1) firmware-$(1)
	@echo "$(1): $$($(1)_SCENES) are built, not run"
run-$(1): $(TARGET_DIR)/reference $(TARGET_DIR)/glass $(TARGET_DIR)/core.list
	+$(Q)$(MAKE1) firmware-$(1)
	$(Q)BUILD=$(BUILD) sh tests/targets/compare.sh $(1) "$$($(1)_FRAME)" "$$($(1)_SHOW)" $$($(1)_SCENES)
$(TARGET_DIR)/$(1)/suites.c: FORCE
	@mkdir -p $$(@D)
	$(Q)sh tests/targets/suites.sh $$@ $$($(1)_SUITES)
$(TARGET_DIR)/$(1)/suites.o: $(TARGET_DIR)/$(1)/suites.c
	$(Q)$$(call target_cc,$(1)) -c $$< -o $$@
$(TARGET_DIR)/$(1)/unit.list: $(TARGET_DIR)/$(1)/suites.c $(BUILD)/tests/harness/host.o \
    $$(call obj,$$($(1)_SUITES:%=tests/unit/%.c)) $(TARGET_DIR)/thin.a
	$(Q)sh tests/targets/list.sh $$@ $(CC) -I. $(OPT) $(EXTRA) $$^
$(TARGET_DIR)/$(1)/unit.a: $$(call target_obj,$(1),$$($(1)_CORE)) $$(if $$($(1)_UNIT),$(TARGET_DIR)/$(1)/unit.list)
	@mkdir -p $$(@D) && rm -f $$@
	$(Q)$$($(1)_AR) rcs $$@ $$(filter %.o,$$^)
$(TARGET_DIR)/$(1)/unit.elf: $$($(1)_UNIT_OBJ) $(TARGET_DIR)/$(1)/suites.o $(TARGET_DIR)/$(1)/unit.a
	$(Q)$$($(1)_CC) $$($(1)_LINK) -Wl,--gc-sections $$^ $$($(1)_LIBS) -o $$@
unit-$(1): $$(if $$($(1)_UNIT),$(TARGET_DIR)/$(1)/unit.list)
	+$(Q)$(MAKE1) $(TARGET_DIR)/$(1)/unit.elf
	$(Q)BUILD=$(BUILD) python3 tests/targets/until.py $$($(1)_RUN) $(TARGET_DIR)/$(1)/unit.elf
.PHONY: firmware-$(1) build-$(1) run-$(1) unit-$(1)
.PRECIOUS: $(TARGET_DIR)/$(1)/%.o $(TARGET_DIR)/$(1)/%.elf
endef
$(foreach b,$(ALL_BOARDS),$(eval $(call board,$(b))))

# What objects depend on, read only for the boards that are made: the files are thousands.
TARGET_MADE := $(foreach b,$(ALL_BOARDS),$(if $(filter %-$(b) $(TARGET_DIR)/$(b)/%,$(MAKECMDGOALS)),\
    $(TARGET_DIR)/$(b) $(call target_cpu,$(b))))
-include $(if $(TARGET_MADE),$(shell find $(sort $(TARGET_MADE)) -name '*.d' 2>/dev/null))

# ---- all of them ---------------------------------------------------------------------------------

# Everything is compiled first; then boards run beside each other under make -j.
TESTED_BOARDS := $(foreach b,$(BOARDS),$(if $($(b)_RUN),$(b)))
TARGET_STEPS += $(BOARDS:%=run-%) $(TESTED_BOARDS:%=unit-%) $(BUILT_BOARDS:%=build-%)
$(TARGET_DIR)/%.step: FORCE
	@mkdir -p $(@D)
	+@$(MAKE1) $* >$@ 2>&1; echo $$? >$@.status

CHECK_STEPS += test-targets
.PHONY: test-targets
test-targets: $(TARGET_DIR)/reference $(TARGET_DIR)/glass $(TARGET_DIR)/core.list \
    $(foreach b,$(BOARDS),$(if $($(b)_UNIT),$(TARGET_DIR)/$(b)/unit.list)) ## every board under emulation
	+$(Q)$(MAKE1) -k $(ALL_BOARDS:%=firmware-%) $(TESTED_BOARDS:%=$(TARGET_DIR)/%/unit.elf) || true
	+$(Q)$(MAKE1) $(TARGET_STEPS:%=$(TARGET_DIR)/%.step)
	$(Q)$(STEPS) $(TARGET_DIR)/steps $(foreach t,$(TARGET_STEPS),$(t) \
	    'cat $(TARGET_DIR)/$(t).step; exit $$(cat $(TARGET_DIR)/$(t).step.status)') \
	    same-frames "sh tests/targets/same_frames.sh $(BOARDS:%=$(TARGET_DIR)/%/hashes)" \
	    broken-pixel "BUILD=$(BUILD) sh tests/targets/broken.sh"

# ---- the table of throughput in ports/README.md ----------------------------------------------------

TARGET_SPEEDS = $(foreach b,$(BOARDS),$(if $($(b)_SPEED),$(TARGET_DIR)/$(b)/speed))
.PHONY: throughput throughput-check speeds
speeds: $(TARGET_SPEEDS)
throughput: $(TARGET_DIR)/core.list ## frames a second on every board: writes the table in ports/README.md
	+$(Q)$(MAKE1) speeds
	$(Q)sh tests/targets/throughput.sh update $(BUILD) "$(TARGET_SPEEDS)"
throughput-check: $(TARGET_DIR)/core.list ## .. checks it: instructions within 5 %, bytes exactly
	+$(Q)$(MAKE1) speeds
	$(Q)sh tests/targets/throughput.sh check $(BUILD) "$(TARGET_SPEEDS)"
