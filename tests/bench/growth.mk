# growth.mk: how cost grows with the size of what is drawn, on Cortex-M0+ under QEMU. Included by
# the Makefile after bench.mk, whose objects it uses.

CHECK_STEPS += growth
GROWTH := $(BENCH)/growth

$(GROWTH)/growth.elf: $(BENCH_SRC)/growth.c $(BENCH_SRC)/workloads_mesh.c $(BENCH_SRC)/start.c \
    linker/mps2.ld $(BENCH)/m0plus-portable/libetch.a
	@mkdir -p $(@D)
	@$(BENCH_CC_m0plus) $(filter-out -MMD -MP,$(BENCH_FLAGS)) -ffreestanding -nostdlib \
	    -Wl,--gc-sections -T linker/mps2.ld $(BENCH_SRC)/growth.c $(BENCH_SRC)/start.c \
	    $(BENCH)/m0plus-portable/libetch.a -lgcc -o $@

.PHONY: growth
growth: $(GROWTH)/growth.elf $(BENCH)/plugin.so ## curves of cost against size, count, strips, depth
	@python3 $(BENCH_SRC)/growth.py $(GROWTH) $(BENCH)/plugin.so $(BUILD)
