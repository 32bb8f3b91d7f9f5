# tradeoff.mk: how exact every mode is, and what it costs: error against exact rationals on the host,
# instructions on Cortex-M0+ and M4 under QEMU, flash at -Os. Included by the Makefile; the objects and
# the plugin are those of bench.mk, which make reads before.

TRADE     := $(BUILD)/tradeoff
TRADE_SRC := tests/tradeoff
TRADE_C   := $(TRADE_SRC)/modes.c $(TRADE_SRC)/scenes.c $(wildcard $(TRADE_SRC)/modes_*.c) \
             $(wildcard $(TRADE_SRC)/candidate_*.c) $(BENCH_SRC)/workloads_mesh.c
TRADE_H   := $(wildcard $(TRADE_SRC)/*.h)

# $(call trade_core,CORE): the firmware, and its counts, one line a drawing.
define trade_core
$(TRADE)/$(1).elf: $(TRADE_SRC)/main.c $(TRADE_C) $(TRADE_H) $(BENCH_SRC)/start.c linker/mps2.ld \
    $(BENCH)/$(1)-portable/libetch.a
	@mkdir -p $$(@D)
	@$$(BENCH_CC_$(1)) $$(filter-out -MMD -MP,$$(BENCH_FLAGS)) -ffreestanding -nostdlib \
	    -Wl,--gc-sections -T linker/mps2.ld $$(filter %.c,$$^) $(BENCH)/$(1)-portable/libetch.a \
	    -lgcc -o $$@
$(TRADE)/$(1)/counts: $(TRADE)/$(1).elf $(BENCH)/plugin.so
	@rm -rf $$(@D) && mkdir -p $$(@D)
	@cd $$(@D) && QEMU_AUDIO_DRV=none timeout 300 qemu-system-arm -M $$(BENCH_MACHINE_$(1)) \
	    -display none -monitor none -serial none -semihosting-config enable=on,target=native \
	    -plugin $(abspath $(BENCH)/plugin.so),out=all.txt,each=counts.new -kernel $$(abspath $$<)
	@mv $$(@D)/counts.new $$@
endef
$(eval $(call trade_core,m0plus))
$(eval $(call trade_core,m4))

TRADE_HOST = $(CC) $(WARN) -O2 -I.
$(TRADE)/host/hashes: $(TRADE_SRC)/main.c $(TRADE_C) $(TRADE_H) $(BENCH_SRC)/host.c $(LIB)
	@mkdir -p $(@D)
	@$(TRADE_HOST) $(filter %.c,$^) $(LIB) -o $(@D)/main
	@cd $(@D) && ./main
$(TRADE)/host/errors.csv: $(wildcard $(TRADE_SRC)/error*.c) $(TRADE_C) $(TRADE_H) \
    tests/oracle/triangle.c tests/oracle/wide.c $(LIB)
	@mkdir -p $(@D)
	@$(TRADE_HOST) $(filter %.c,$^) $(LIB) -lm -o $(@D)/error
	@$(@D)/error >$@.new && mv $@.new $@

$(TRADE)/host/separation.csv: $(TRADE_SRC)/separation.c $(TRADE_H) $(LIB)
	@mkdir -p $(@D)
	@$(TRADE_HOST) $(filter %.c,$^) $(LIB) -lm -o $(@D)/separation
	@$(@D)/separation >$@.new && mv $@.new $@

# What a program that draws with one mode weighs, with all it links.
TRADE_DRAWS := $(shell sed -n 's/^TRADEOFF_DRAWS(\(.*\));/\1/p' $(TRADE_SRC)/tradeoff.h)
$(TRADE)/flash/%.o: $(TRADE_SRC)/%.c $(TRADE_H)
	@mkdir -p $(@D)
	@$(BENCH_CC_m0plus) $(filter-out -MMD -MP,$(SIZE_FLAGS)) -c $< -o $@
TRADE_PARTS := $(patsubst $(TRADE_SRC)/%.c,$(TRADE)/flash/%.o,$(wildcard $(TRADE_SRC)/modes_*.c \
                   $(TRADE_SRC)/candidate_*.c))
$(TRADE)/flash/%.elf: $(TRADE_SRC)/flash.c $(TRADE_PARTS) $(SIZE)/libetch.a linker/size.ld
	@$(BENCH_CC_m0plus) $(filter-out -MMD -MP,$(SIZE_FLAGS)) -DMODE=$* -nostdlib -Wl,--gc-sections \
	    -T linker/size.ld $< $(TRADE_PARTS) $(SIZE)/libetch.a -lgcc -o $@
TRADE_ELFS := $(TRADE_DRAWS:%=$(TRADE)/flash/%.elf)
$(TRADE)/flash.txt: $(TRADE_ELFS)
	@$(ARM)size -B $^ >$@

.SECONDARY: $(TRADE_PARTS)

TRADE_RESULTS := $(TRADE)/m0plus/counts $(TRADE)/m4/counts $(TRADE)/host/errors.csv \
                 $(TRADE)/host/hashes $(TRADE)/host/separation.csv $(TRADE)/flash.txt

.PHONY: tradeoff tradeoff-check tradeoff-write
tradeoff: $(TRADE_RESULTS) ## error and cost of every mode: build/tradeoff.csv, .svg and .md
	@python3 $(TRADE_SRC)/tradeoff.py $(TRADE) $(BUILD)
tradeoff-check: tradeoff ## the committed table and chart are those of today
	@python3 $(TRADE_SRC)/current.py $(TRADE_SRC) $(BUILD)
tradeoff-write: tradeoff ## takes today's table and chart into tests/tradeoff and its README.md
	@cp $(BUILD)/tradeoff.csv $(BUILD)/tradeoff.svg $(TRADE_SRC)/
	@python3 $(BENCH_SRC)/insert.py $(TRADE_SRC)/README.md tradeoff $(BUILD)/tradeoff.md
