# bench.mk: what drawing costs, and what it weighs. Included by the Makefile.
#
# Every workload Wn becomes a firmware for Cortex-M0+ and M4 (run by QEMU, counted by plugin.c)
# and a host program (counted by callgrind). A count is only kept if its picture is right: the
# host's is checked against the slow oracle of check.c, the firmware's must equal the host's.
# W="6 8" chooses workloads, CORES="m0plus m4 host" where they run.

W       ?= 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15
CORES   ?= m0plus m4 host
VARIANT ?= portable
PROFILE ?= function

BENCH       := $(BUILD)/bench
BENCH_SRC   := tests/bench
BENCH_OPT   ?= -O2 -g
BENCH_FLAGS  = $(WARN) $(BENCH_OPT) -ffunction-sections -fdata-sections -MMD -MP
BENCH_WORK  := $(wildcard $(BENCH_SRC)/workloads_*.c)
BENCH_LIB   := $(CORE) $(HAL)
ARM         ?= arm-none-eabi-

# What each core is: compiler and flags, board (any Cortex-M runs ARMv6-M code).
BENCH_CC_m0plus      := $(ARM)gcc -mcpu=cortex-m0plus -mthumb
BENCH_CC_m4          := $(ARM)gcc -mcpu=cortex-m4 -mthumb
BENCH_CC_host         = $(CC)
BENCH_MACHINE_m0plus := mps2-an385
BENCH_MACHINE_m4     := mps2-an386

# Leaf loops per architecture, which the variant "best" puts in place of the portable files.
BENCH_LEAF_m0plus-best := $(wildcard core/leaf/armv6m/*.[cS])
BENCH_LEAF_m4-best     := $(wildcard core/leaf/armv7em/*.[cS])
BENCH_LEAF_host-best   := $(wildcard core/leaf/vector128/*.c)

# $(call bench_objects,DIR,SOURCES)
bench_objects = $(patsubst %,$(BENCH)/$(1)/%.o,$(basename $(2)))

# $(call bench_core,CORE,VARIANT): objects, library and one program a workload, all in one
# directory. Leaf objects come before the library, so that its members of the same names stay
# out.
define bench_core
$(BENCH)/$(1)-$(2)/%.o: %.c $(BENCH_SRC)/bench.mk
	@mkdir -p $$(@D)
	$$(BENCH_CC_$(1)) $$(BENCH_FLAGS) -ffreestanding -c $$< -o $$@
$(BENCH)/$(1)-$(2)/%.o: %.S
	@mkdir -p $$(@D)
	$$(BENCH_CC_$(1)) -g -c $$< -o $$@
$(BENCH)/$(1)-$(2)/libetch.a: $(call bench_objects,$(1)-$(2),$(BENCH_LIB))
	@rm -f $$@
	@$(if $(filter host,$(1)),$$(AR),$(ARM)ar) rcs $$@ $$^
.SECONDARY: $(call bench_objects,$(1)-$(2),$(BENCH_LIB) $(BENCH_WORK))
-include $(patsubst %.o,%.d,$(call bench_objects,$(1)-$(2),$(BENCH_LIB) $(BENCH_WORK)))
endef

define bench_firmware
$(call bench_core,$(1),$(2))
$(BENCH)/$(1)-$(2)/w%.elf: $(BENCH_SRC)/main.c $(BENCH_SRC)/start.c linker/mps2.ld \
    $(call bench_objects,$(1)-$(2),$(BENCH_WORK) $(BENCH_LEAF_$(1)-$(2))) \
    $(BENCH)/$(1)-$(2)/libetch.a
	@$$(BENCH_CC_$(1)) $$(filter-out -MMD -MP,$$(BENCH_FLAGS)) -ffreestanding -nostdlib \
	    -Wl,--gc-sections -T linker/mps2.ld -DWORKLOAD=$$* $$(filter %.c %.o,$$^) \
	    $(BENCH)/$(1)-$(2)/libetch.a -lgcc -o $$@
$(BENCH)/$(1)-$(2)/w%/counts.txt: $(BENCH)/$(1)-$(2)/w%.elf $(BENCH)/plugin.so \
    $(BENCH)/host-portable/w%/truth.txt
	@$(BENCH_SRC)/run_firmware.sh $$(BENCH_MACHINE_$(1)) $$< $(BENCH)/plugin.so $$(@D) \
	    $(BENCH)/host-portable/w$$*
.PRECIOUS: $(BENCH)/$(1)-$(2)/w%.elf $(BENCH)/$(1)-$(2)/w%/counts.txt
endef

$(foreach v,portable best,$(eval $(call bench_firmware,m0plus,$(v))))
$(foreach v,portable best,$(eval $(call bench_firmware,m4,$(v))))
# The host's portable picture is the one that is checked; truth.txt says how many primitives and
# pixels it has. That of the leaves must equal it.
$(BENCH)/host-portable/w%/truth.txt: $(BENCH)/host-portable/w%.elf $(BENCH)/check
	@rm -rf $(@D) && mkdir -p $(@D)
	@cd $(@D) && $(abspath $<)
	@$(BENCH)/check $* $(@D) >$@.new && mv $@.new $@

define bench_host
$(call bench_core,host,$(1))
-include $(patsubst %.o,%.d,$(call bench_objects,host-$(1),$(BENCH_LEAF_host-$(1))))
$(BENCH)/host-$(1)/w%.elf: $(BENCH_SRC)/main.c $(BENCH_SRC)/host.c \
    $(call bench_objects,host-$(1),$(BENCH_WORK) $(BENCH_LEAF_host-$(1))) \
    $(BENCH)/host-$(1)/libetch.a
	@$$(CC) $$(filter-out -MMD -MP,$$(BENCH_FLAGS)) -Wl,--gc-sections -DWORKLOAD=$$* $$^ -o $$@
$(BENCH)/host-$(1)/w%/counts.txt: $(BENCH)/host-$(1)/w%.elf $(BENCH)/host-portable/w%/truth.txt
	@$(BENCH_SRC)/run_callgrind.sh $$< $$(@D) $(BENCH)/host-portable/w$$*
.PRECIOUS: $(BENCH)/host-$(1)/w%.elf $(BENCH)/host-$(1)/w%/counts.txt
.SECONDARY: $(call bench_objects,host-$(1),$(BENCH_LEAF_host-$(1)))
endef

$(foreach v,portable best,$(eval $(call bench_host,$(v))))
.PRECIOUS: $(BENCH)/host-portable/w%/truth.txt

$(BENCH)/plugin.so: $(BENCH_SRC)/plugin.c
	@mkdir -p $(@D)
	$(CC) -O2 -Wall -Wextra -shared -fPIC $< -o $@

# The check of W15 runs the vertex stage and records its triangles.
$(BENCH)/check: $(wildcard $(BENCH_SRC)/check*.c) $(wildcard $(BENCH_SRC)/*.h) \
    $(call bench_objects,host-portable,$(BENCH_SRC)/workloads_mesh.c) \
    $(BENCH)/host-portable/libetch.a
	@mkdir -p $(@D)
	$(CC) $(WARN) -O2 $(filter %.c %.o %.a,$^) -lm -o $@

# The host always in both variants, since one machine builds both anyway.
BENCH_RUNS = $(foreach c,$(CORES),$(foreach v,$(if $(filter host,$(c)),portable best,$(VARIANT)), \
    $(foreach n,$(W),$(BENCH)/$(c)-$(v)/w$(n)/counts.txt)))

.PHONY: bench
bench: $(BENCH_RUNS) ## instructions per pixel and primitive on Cortex-M0+, M4 and here (W="6 8")
	@python3 $(BENCH_SRC)/report.py $(BENCH) $^

.PHONY: bench-diff
bench-diff: bench ## what a change made better or worse; fails on more than 2 % worse
	@python3 $(BENCH_SRC)/diff.py $(BENCH_SRC)/baseline.csv $(BUILD)/bench.csv

.PHONY: bench-baseline
bench-baseline: bench ## takes today's figures as the baseline of bench-diff
	cp $(BUILD)/bench.csv $(BENCH_SRC)/baseline.csv

W8_W11 := w8 w11
.PHONY: bench-selftest
bench-selftest: $(W8_W11:%=$(BENCH)/m0plus-portable/%/counts.txt) ## proves the bench itself
	@sh $(BENCH_SRC)/selftest.sh $(BENCH)

# The portable functions under other names, beside the leaves that replace them.
LEAVES        := $(BENCH)/leaves
LEAF_PORTABLE := base/fill fragment/flat fragment/gouraud raster/line_walk \
                 fragment/depth_rows_less fragment/depth_rows_lequal \
                 fragment/gouraud_narrow_less fragment/gouraud_narrow_lequal raster/edge_run \
                 raster/basis_color raster/circle_whole
LEAF_NAMES    := etch_fill_rows etch_kernel_flat etch_kernel_gouraud etch_line_walk \
                 etch_depth_rows_less etch_depth_rows_lequal \
                 etch_gouraud_narrow_less etch_gouraud_narrow_lequal etch_edge_run \
                 etch_basis_color etch_circle_whole
$(LEAVES)/%.o: $(BENCH)/m0plus-portable/core/%.o
	@mkdir -p $(@D)
	@$(ARM)objcopy $(foreach n,$(LEAF_NAMES),--redefine-sym $(n)=portable_$(n)) $< $@
$(LEAVES)/leaves.elf: $(BENCH_SRC)/leaves.c $(BENCH_SRC)/start.c linker/mps2.ld \
    $(LEAF_PORTABLE:%=$(LEAVES)/%.o) \
    $(foreach n,base/surface raster/basis raster/triangle_setup,$(BENCH)/m0plus-portable/core/$(n).o) \
    $(foreach n,$(notdir $(LEAF_PORTABLE)),$(BENCH)/m0plus-best/core/leaf/armv6m/$(n).o)
	@$(BENCH_CC_m0plus) $(filter-out -MMD -MP,$(BENCH_FLAGS)) -ffreestanding -nostdlib \
	    -Wl,--gc-sections -T linker/mps2.ld $(filter %.c %.o,$^) -lgcc -o $@

# On this machine all of the portable library has other names.
LEAVES_HOST := $(call bench_objects,host-best,$(BENCH_LEAF_host-best)) \
    $(BENCH)/host-portable/libetch.a $(LEAVES)/portable.a
$(LEAVES)/portable.a: $(BENCH)/host-portable/libetch.a
	@mkdir -p $(@D)
	@nm -g --defined-only $< 2>/dev/null | awk 'NF == 3 { print $$3, "portable_" $$3 }' | sort -u >$@.names
	@objcopy --redefine-syms=$@.names $< $@
$(LEAVES)/leaves_host $(LEAVES)/leaves_guard: $(LEAVES)/%: $(LEAVES_HOST)
$(LEAVES)/leaves_host: $(BENCH_SRC)/leaves.c
$(LEAVES)/leaves_guard: $(BENCH_SRC)/leaves_guard.c
$(LEAVES)/leaves_host $(LEAVES)/leaves_guard:
	@$(CC) $(filter-out -MMD -MP,$(BENCH_FLAGS)) $(filter %.c,$^) $(filter-out %.c,$^) -o $@

CHECK_STEPS += bench-leaves

.PHONY: bench-leaves
bench-leaves: $(LEAVES)/leaves.elf $(LEAVES)/leaves_host $(LEAVES)/leaves_guard ## proves the leaf loops against the portable C
	@QEMU_AUDIO_DRV=none timeout 300 qemu-system-arm -M mps2-an385 -display none -monitor none \
	    -serial none -semihosting-config enable=on,target=native -kernel $<
	@$(LEAVES)/leaves_host
	@echo "5700 calls of leaf loops write what the portable C writes, on ARMv6-M and here"
	@$(LEAVES)/leaves_guard

.PHONY: profile
profile: $(BENCH_RUNS) ## instructions per function (W=6 CORES=m0plus; PROFILE=line, PROFILE=insn)
	@for c in $^; do python3 $(BENCH_SRC)/profile.py $(PROFILE) $$c $(FUNCTION); done

# ---- size: programs for Cortex-M0+ at -Os, linked with all they pull in ----------------------

SIZE          := $(BENCH)/size
SIZE_PROGRAMS := $(patsubst $(BENCH_SRC)/size/%.c,%, \
                     $(filter-out %/memory.c,$(wildcard $(BENCH_SRC)/size/*.c)))
SIZE_ELFS     := $(SIZE_PROGRAMS:%=$(SIZE)/%.elf)
SIZE_FLAGS     = $(WARN) -Os -g -ffreestanding -ffunction-sections -fdata-sections -MMD -MP
SIZE_ENFORCE  ?=
SIZE_OPTIONS  ?=

$(SIZE)/%.o: %.c $(BENCH_SRC)/bench.mk
	@mkdir -p $(@D)
	$(BENCH_CC_m0plus) $(SIZE_FLAGS) -c $< -o $@
$(SIZE)/libetch.a: $(BENCH_LIB:%.c=$(SIZE)/%.o) $(SIZE)/$(BENCH_SRC)/size/memory.o
	@rm -f $@
	@$(ARM)ar rcs $@ $^
$(SIZE)/%.elf: $(SIZE)/$(BENCH_SRC)/size/%.o $(SIZE)/libetch.a linker/size.ld
	@$(BENCH_CC_m0plus) -nostdlib -Wl,--gc-sections -T linker/size.ld $(filter %.o %.a,$^) -lgcc -o $@
.SECONDARY: $(BENCH_LIB:%.c=$(SIZE)/%.o)
-include $(BENCH_LIB:%.c=$(SIZE)/%.d) $(SIZE_PROGRAMS:%=$(SIZE)/$(BENCH_SRC)/size/%.d)

.PHONY: size
size: $(SIZE_ELFS) ## flash of small programs, and that they link nothing unused (SIZE_OPTIONS=--symbols)
	@python3 $(BENCH_SRC)/links.py $(BENCH_SRC)/size/links.txt $^
	@python3 $(BENCH_SRC)/size.py $(BENCH_SRC)/size/budgets.csv $(SIZE_OPTIONS) \
	    --enforce "$(SIZE_ENFORCE)" -- $^

# The tables into a document that has the lines <!-- bench --> <!-- /bench -->, same for size.
DOC ?= README.md
.PHONY: bench-write
bench-write: bench size ## writes the tables of bench and size into DOC=README.md
	@python3 $(BENCH_SRC)/insert.py $(DOC) bench $(BUILD)/bench.md
	@python3 $(BENCH_SRC)/insert.py $(DOC) size $(BUILD)/size.md
