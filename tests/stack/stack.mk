# Worst-case stack on Cortex-M0+, from gcc's own frames and calls.
STACK_CI := $(patsubst %.c,$(BUILD)/stack/%.o,$(CORE) $(HAL))
$(BUILD)/stack/%.o: %.c
	@mkdir -p $(@D)
	$(Q)arm-none-eabi-gcc -mcpu=cortex-m0plus -mthumb $(WARN) -ffreestanding -O2 \
	    -ffunction-sections -fcallgraph-info=su -MMD -MP -c $< -o $@
-include $(STACK_CI:.o=.d)
.PHONY: stack
stack: $(STACK_CI) ## the worst-case stack of public functions on Cortex-M0+, against budgets
	$(Q)python3 tests/stack/stack.py $(BUILD)/stack tests/stack/budgets.txt
