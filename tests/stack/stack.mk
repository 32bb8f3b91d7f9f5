# Worst-case stack on Cortex-M0+, from gcc's own frames and calls. See README.md.
STACK_CI := $(patsubst %.c,$(BUILD)/stack/%.o,$(CORE) $(HAL))
$(BUILD)/stack/%.o: %.c
	@mkdir -p $(@D)
	$(Q)arm-none-eabi-gcc -mcpu=cortex-m0plus -mthumb $(WARN) -ffreestanding -O2 \
	    -ffunction-sections -fcallgraph-info=su -MMD -MP -c $< -o $@
-include $(STACK_CI:.o=.d)

STACK = python3 tests/stack/stack.py $(BUILD)/stack tests/stack/budgets.txt $(BUILD)/stack.md
.PHONY: stack stack-readme
stack: $(STACK_CI) ## the worst-case stack of public functions on Cortex-M0+, against budgets
	$(Q)sh tests/stack/selftest.sh $(BUILD)/stack
	$(Q)$(STACK)
stack-readme: $(STACK_CI) ## its figures into tests/stack/README.md
	$(Q)$(STACK) >$(BUILD)/stack.txt
	$(Q)grep '^|' $(BUILD)/stack.txt >$(BUILD)/stack_whole.md
	$(Q)python3 tests/bench/insert.py tests/stack/README.md whole $(BUILD)/stack_whole.md
	$(Q)python3 tests/bench/insert.py tests/stack/README.md alone $(BUILD)/stack.md
