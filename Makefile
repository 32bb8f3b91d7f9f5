# etch: `make help` lists the targets. Output goes to build/ only.
#
# Variables: CC=clang, BUILD=dir (one directory for each set of flags), OPT="-Os -g",
# EXTRA="more flags for everything", CORE_EXTRA="more flags for core and hal", V=1 (show commands),
# RUN="qemu-s390x" (what starts a test program), SUITE=line (one suite of `make unit`),
# DIVISOR=10 (a tenth of every seeded loop of the tests).

ifeq ($(origin CC),default)
CC := gcc
endif
BUILD   ?= build
OPT     ?= -O2 -g
DIVISOR ?= 1
WARN    := -std=c11 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wvla -Wmissing-prototypes \
           -Wdouble-promotion -Werror
CFLAGS_CORE = $(WARN) -ffreestanding $(OPT) $(EXTRA) $(CORE_EXTRA)
CFLAGS_HOST = $(WARN) -I. -DTEST_DIVISOR=$(DIVISOR) $(OPT) $(EXTRA)

CORE := $(sort $(wildcard core/*/*.c))
HAL  := $(sort $(wildcard hal/*.c ports/framebuffer/*.c))
SIM  := $(sort $(wildcard ports/host/*.c))
UNIT := $(sort $(wildcard tests/unit/*.c))
TEST := $(UNIT) $(sort $(wildcard tests/harness/*.c tests/oracle/*.c)) \
        tests/exhaustive/triangles.c tests/exhaustive/clipped.c

LIB       := $(BUILD)/libetch.a
SIMLIB    := $(BUILD)/libetchsim.a
ETCH_SIM  := $(BUILD)/etch-sim
UNIT_TEST := $(BUILD)/unit-test
PICTURES  := $(BUILD)/picture-diff

obj   = $(patsubst %.c,$(BUILD)/%.o,$(1))
MAKE1 = $(MAKE) --no-print-directory
STEPS = sh tests/tools/steps.sh
Q    := $(if $(V),,@)
# $(call steps,NAME,TARGETS,BESIDE): runs the targets one after the other, those of BESIDE at the same
# time, and sums what they report.
step  = $(1) "$(MAKE1) $(1)"
steps = +$(Q)$(STEPS) $(BUILD)/$(1) $(foreach t,$(2),$(call step,$(t))) \
        $(if $(3),-- $(foreach t,$(3),$(call step,$(t))))

.PHONY: all
all: $(LIB) $(ETCH_SIM) ## the library and the simulator

.PHONY: demo
demo: $(ETCH_SIM) ## renders the demo scenes into build/demo
	$(Q)BUILD=$(BUILD) sh ports/host/demo.sh

# ---- compiling: core and hal freestanding, the rest hosted --------------------------------------

$(LIB): $(call obj,$(CORE) $(HAL))
	@rm -f $@
	$(Q)$(AR) rcs $@ $^

$(SIMLIB): $(call obj,$(filter-out ports/host/etch_sim.c,$(SIM)))
	@rm -f $@
	$(Q)$(AR) rcs $@ $^

$(ETCH_SIM): $(call obj,ports/host/etch_sim.c) $(SIMLIB) $(LIB)
	$(Q)$(CC) $(OPT) $(EXTRA) $^ -o $@

$(UNIT_TEST): $(call obj,$(TEST)) $(BUILD)/tests/suites.o $(LIB)
	$(Q)$(CC) $(OPT) $(EXTRA) $^ -o $@

$(PICTURES): $(call obj,$(wildcard tests/tools/*.c))
	$(Q)$(CC) $(OPT) $(EXTRA) $^ -o $@

$(call obj,$(CORE) $(HAL)): $(BUILD)/%.o: %.c
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS_CORE) -MMD -MP -c $< -o $@

$(BUILD)/%.o: %.c
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS_HOST) -MMD -MP -c $< -o $@

$(BUILD)/tests/suites.o: $(BUILD)/tests/suites.c
	$(Q)$(CC) $(CFLAGS_HOST) -c $< -o $@

# The list of suites, from the names of the files in tests/unit; rewritten only if it changed.
SUITES := $(notdir $(UNIT:.c=))
$(BUILD)/tests/suites.c: FORCE
	@mkdir -p $(@D)
	@{ echo '/* Generated from the names of the files in tests/unit. */'; \
	   echo '#include "tests/harness/harness.h"'; \
	   for s in $(SUITES); do echo "void suite_$$s(void);"; done; \
	   echo 'extern const struct test_suite test_suites[];'; \
	   echo 'const struct test_suite test_suites[] = {'; \
	   for s in $(SUITES); do echo "    {\"$$s\", suite_$$s},"; done; \
	   echo '    {0, 0}};'; } >$@.new
	@if cmp -s $@.new $@; then rm $@.new; else mv $@.new $@; fi
.PHONY: FORCE
FORCE:

-include $(patsubst %.o,%.d,$(call obj,$(CORE) $(HAL) $(SIM) $(TEST) $(wildcard tests/tools/*.c)))

# ---- tests ----------------------------------------------------------------------------------------

TEST_STEPS  := unit stores golden cli readme features extremes fuzz-replay
CHECK_STEPS := test includes stack fuzz-check
# Beside them, two at a time: what shares no object with the others.
CHECK_BESIDE := test-clang test32 test-size sanitize uninit symbols lint

.PHONY: test
test: $(UNIT_TEST) $(ETCH_SIM) ## all tests that need only gcc and make
	$(call steps,test,$(TEST_STEPS))

.PHONY: unit
unit: $(UNIT_TEST) ## the unit tests (SUITE=name for one suite)
	$(Q)$(RUN) $(UNIT_TEST) $(SUITE)

# Core compiled so that every store and every block calls tests/harness/stores.c, which looks the
# store up on the canvas; gcc is told not to drop or join stores first. ETCH_ASSERT is on.
STORES := -include tests/harness/assert.h -fsanitize=thread \
          $(if $(findstring clang,$(CC)),-fsanitize-coverage=bb -fsanitize-coverage=no-prune,\
          -fno-tree-dse -fno-tree-loop-distribute-patterns) -fsanitize-coverage=trace-pc
.PHONY: stores
stores: ## the unit tests with every store and block of core counted: no overdraw, none outside the clip
	+$(Q)$(MAKE1) unit BUILD=$(BUILD)/stores DIVISOR=10 EXTRA="$(EXTRA) -DTEST_STORES=1" \
	    CORE_EXTRA="$(STORES)"

GOLDEN = $(Q)RUN="$(RUN)" sh tests/golden/golden.sh
.PHONY: golden golden-update golden-list
golden: $(ETCH_SIM) $(PICTURES) ## compares the golden scenes (SCENE=name for one)
	$(GOLDEN) run $(BUILD) $(SCENE)
golden-update: $(ETCH_SIM) $(PICTURES) ## takes what is drawn now as golden (SCENE=name for one)
	$(GOLDEN) update $(BUILD) $(SCENE)
golden-list: ## lists the golden scenes
	$(GOLDEN) list $(BUILD)

.PHONY: cli
cli: $(ETCH_SIM) ## the simulator's command line, errors included
	$(Q)BUILD=$(BUILD) sh tests/cli/run

.PHONY: readme
readme: $(LIB) ## the README's program, run against a panel
	$(Q)BUILD=$(BUILD) CC="$(CC)" EXTRA="$(EXTRA)" RUN="$(RUN)" sh tests/readme/run

.PHONY: features
features: ## the tables of core/README.md name what there is
	$(Q)sh tests/tools/features.sh
.PHONY: extremes
extremes: ## every extreme of tests/EXTREMES.md has its test
	$(Q)sh tests/tools/extremes.sh

.PHONY: test-clang test32 test-size
test-clang: ## the tests with everything compiled by clang
	+$(Q)$(MAKE1) test TEST_STEPS="$(filter-out stores,$(TEST_STEPS))" CC=clang BUILD=$(BUILD)/clang DIVISOR=4
test32: ## the tests as 32-bit programs
	+$(Q)$(MAKE1) test TEST_STEPS="$(filter-out stores,$(TEST_STEPS))" BUILD=$(BUILD)/m32 \
	    EXTRA="$(EXTRA) -m32" DIVISOR=4
test-size: ## the unit tests at -Os
	+$(Q)$(MAKE1) unit BUILD=$(BUILD)/os OPT="-Os -g" DIVISOR=4

# A report ends the program, so that it fails. Every test runs, the seeded loops a tenth as often.
SANITIZE := -fsanitize=address,undefined,integer,implicit-conversion -fno-sanitize-recover=all \
            -fsanitize-ignorelist=tests/tools/sanitize.ignore -fno-omit-frame-pointer
.PHONY: sanitize uninit
sanitize: ## the tests under ASan and UBSan, with integer overflow and conversion checks
	+$(Q)$(MAKE1) test TEST_STEPS="unit golden cli" CC=clang BUILD=$(BUILD)/sanitize OPT="-O1 -g" \
	    DIVISOR=10 EXTRA="$(SANITIZE)" CORE_EXTRA="-D'ETCH_ASSERT(x)=((x)?(void)0:__builtin_trap())'"
uninit: ## the unit tests under MSan: no use of what was never written
	+$(Q)$(MAKE1) unit CC=clang BUILD=$(BUILD)/uninit OPT="-O1 -g" DIVISOR=10 \
	    EXTRA="-fsanitize=memory -fno-sanitize-recover=all"

.PHONY: symbols
symbols: ## what core and hal objects use on Cortex-M0+, AVR and rv32, at -Os and -O2
	$(Q)sh tests/tools/symbols.sh $(BUILD)/symbols $(CORE) $(HAL) $(sort $(wildcard ports/spi_lcd/*.c))

.PHONY: includes
includes: ## the include rules of core and hal, and no float in them
	$(Q)CC=$(CC) sh tests/tools/includes.sh

# ---- tools -----------------------------------------------------------------------------------------

C_FILES = $(shell find core hal ports tests -name '*.[ch]' | sort)

.PHONY: lint
lint: ## clang-format, clang-tidy and cppcheck
	$(Q)sh tests/tools/lint.sh $(BUILD) $(C_FILES)

.PHONY: fmt
fmt: ## formats every C file
	$(Q)clang-format -i $(C_FILES)

.PHONY: check
check: ## all that CI runs
	$(call steps,check,$(CHECK_STEPS),$(CHECK_BESIDE))

DEPS := gcc make libc6-dev gcc-multilib clang clang-tidy clang-format libclang-rt-dev cppcheck \
        gcc-arm-none-eabi gcc-avr gcc-riscv64-unknown-elf qemu-system-arm qemu-system-misc valgrind \
        simavr libsimavr-dev libelf-dev avr-libc nodejs qemu-user-static lld llvm python3 universal-ctags \
        libpng-dev g++ frama-c-base why3 z3 gappa
SUDO = $(if $(filter 0,$(shell id -u)),,sudo)
.PHONY: deps
deps: ## installs what `make check` and the benchmarks need (Debian, Ubuntu)
	$(SUDO) apt-get update
	$(SUDO) env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $(DEPS)
	command -v npm || $(SUDO) apt-get install -y --no-install-recommends npm
	npm install --no-save --prefix $(BUILD)/npm rp2040js@1.4.1

.PHONY: help
help: ## this list
	@sed -n 's/^\([a-z0-9-]*\):.*## \(.*\)/  make \1|\2/p' $(MAKEFILE_LIST) | \
	    awk -F'|' '{ printf "%-24s%s\n", $$1, $$2 }'

.PHONY: clean
clean: ## removes build/
	rm -rf $(BUILD)

# Folders may bring targets of their own.
-include $(wildcard ports/*/*.mk tests/*/*.mk)
