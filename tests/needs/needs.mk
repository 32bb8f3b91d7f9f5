# What functions weigh together, for `etch-sim --needs`. Included by the Makefile; the objects are those of
# `make size` and the call graphs those of `make stack`.
CHECK_STEPS += needs

NEEDS        := $(BUILD)/needs
NEEDS_LIBGCC := $(shell arm-none-eabi-gcc -mcpu=cortex-m0plus -mthumb -print-libgcc-file-name 2>/dev/null)
$(NEEDS)/needs_table.c: tests/needs/table.py $(BUILD)/bench/size/libetch.a $(patsubst %.c,$(BUILD)/stack/%.o,$(CORE) $(HAL))
	@mkdir -p $(@D)
	$(Q)python3 tests/needs/table.py $(BUILD)/bench/size/libetch.a $(NEEDS_LIBGCC) $(BUILD)/stack $@
# Today's sums, and those of the table that is committed.
$(NEEDS)/sum: tests/needs/sum.c ports/host/needs.c $(NEEDS)/needs_table.c
	$(Q)$(CC) $(WARN) -I. -iquote ports/host $^ -o $@
$(NEEDS)/committed: tests/needs/sum.c ports/host/needs.c ports/host/needs_table.c
	@mkdir -p $(@D)
	$(Q)$(CC) $(WARN) -I. $^ -o $@

.PHONY: needs needs-table
needs: $(NEEDS)/sum $(NEEDS)/committed ## what etch-sim --needs says of flash, against the linker
	$(Q)sh tests/needs/run $(NEEDS) $(BUILD)/bench/size/libetch.a arm-none-eabi-gcc
needs-table: $(NEEDS)/needs_table.c ## today's weights into ports/host/needs_table.c
	@cp $< ports/host/needs_table.c
