# etch: `make help` lists the targets. Output goes to build/ only.
#
# Variables: CC=clang, BUILD=dir (one directory per configuration), OPT="-Os -g",
# EXTRA="more flags for everything", CORE_EXTRA="more flags for core and hal",
# RUN="qemu-s390x ..." (what starts a test program), SUITE=line (one suite of the unit tests).

ifeq ($(origin CC),default)
CC := gcc
endif
BUILD ?= build
OPT   ?= -O2 -g
WARN  := -std=c11 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wvla -Wmissing-prototypes \
         -Wdouble-promotion -Werror
CFLAGS_CORE = $(WARN) -ffreestanding $(OPT) $(EXTRA) $(CORE_EXTRA)
CFLAGS_HOST = $(WARN) -I. $(OPT) $(EXTRA)

CORE := $(sort $(wildcard core/*/*.c core/*/*/*.c))
HAL  := $(sort $(wildcard hal/*.c ports/framebuffer/*.c))
SIM  := $(sort $(wildcard ports/host/*.c))
UNIT := $(sort $(wildcard tests/unit/*.c))
TEST := $(UNIT) $(sort $(wildcard tests/harness/*.c tests/oracle/*.c))

obj = $(patsubst %.c,$(BUILD)/%.o,$(1))

LIB       := $(BUILD)/libetch.a
SIMLIB    := $(BUILD)/libetchsim.a
ETCH_SIM  := $(if $(wildcard ports/host/etch_sim.c),$(BUILD)/etch-sim)
UNIT_TEST := $(BUILD)/unit-test
STEPS     := sh tests/tools/steps.sh

.PHONY: all
all: $(LIB) $(ETCH_SIM) ## the library and the simulator

# ---- compiling: core and hal freestanding, the rest hosted ------------------------------------

$(LIB): $(call obj,$(CORE) $(HAL))
	@rm -f $@
	$(AR) rcs $@ $^

$(SIMLIB): $(call obj,$(filter-out ports/host/etch_sim.c,$(SIM)))
	@rm -f $@
	$(AR) rcs $@ $^

$(BUILD)/etch-sim: $(call obj,ports/host/etch_sim.c) $(SIMLIB) $(LIB)
	$(CC) $(OPT) $(EXTRA) $^ -o $@

$(UNIT_TEST): $(call obj,$(TEST)) $(BUILD)/tests/suites.o $(LIB)
	$(CC) $(OPT) $(EXTRA) $^ -o $@

$(call obj,$(CORE) $(HAL)): $(BUILD)/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(CFLAGS_CORE) -MMD -MP -c $< -o $@

$(BUILD)/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(CFLAGS_HOST) -MMD -MP -c $< -o $@

$(BUILD)/tests/suites.o: $(BUILD)/tests/suites.c
	$(CC) $(CFLAGS_HOST) -c $< -o $@

# The list of suites, from the names of the files in tests/unit; rewritten only if it changed.
SUITES := $(notdir $(UNIT:.c=))
$(BUILD)/tests/suites.c: FORCE
	@mkdir -p $(@D)
	@{ echo '/* Generated from the files in tests/unit. */'; \
	   echo '#include "tests/harness/harness.h"'; \
	   for s in $(SUITES); do echo "void suite_$$s(void);"; done; \
	   echo 'extern const struct test_suite test_suites[];'; \
	   echo 'const struct test_suite test_suites[] = {'; \
	   for s in $(SUITES); do echo "    {\"$$s\", suite_$$s},"; done; \
	   echo '    {0, 0}};'; } >$@.new
	@if cmp -s $@.new $@; then rm $@.new; else mv $@.new $@; fi
.PHONY: FORCE
FORCE:

-include $(patsubst %.o,%.d,$(call obj,$(CORE) $(HAL) $(SIM) $(TEST)))

# ---- tests --------------------------------------------------------------------------------------

.PHONY: unit
unit: $(UNIT_TEST) ## the unit tests alone (SUITE=name for one suite)
	$(RUN) $(UNIT_TEST) $(SUITE)

# Core compiled so that every store calls tests/harness/stores.c, which looks it up on the canvas.
STORES = BUILD=$(BUILD)/stores EXTRA="$(EXTRA) -DTEST_STORES=1 -DTEST_DIVISOR=10" \
         CORE_EXTRA="-fsanitize=thread -fno-tree-dse -fno-tree-loop-distribute-patterns"
.PHONY: stores
stores: ## the unit tests with every store of core counted: no overdraw, none outside the clip
	@$(MAKE) --no-print-directory $(STORES) unit

.PHONY: test
test: $(UNIT_TEST) $(ETCH_SIM) ## everything that needs only gcc and make
	$(RUN) $(UNIT_TEST)

# ---- the rest -------------------------------------------------------------------------------------

.PHONY: help
help: ## this list
	@sed -n 's/^\([a-z0-9-]*\):.*## \(.*\)/  make \1|\2/p' $(MAKEFILE_LIST) | \
	    awk -F'|' '{ printf "%-24s%s\n", $$1, $$2 }'

.PHONY: clean
clean: ## removes build/
	rm -rf $(BUILD)
