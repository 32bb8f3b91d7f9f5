# tests/cli: the simulator's own unit tests, which `make cli` runs beside the command line.
HOST_OBJ := $(call obj,$(sort $(wildcard tests/cli/*.c tests/oracle/*.c)) tests/harness/harness.c \
              tests/harness/host.c)

$(BUILD)/host-test: $(HOST_OBJ) $(SIMLIB) $(LIB)
	$(Q)$(CC) $(OPT) $(EXTRA) $^ -o $@

cli: $(BUILD)/host-test
-include $(HOST_OBJ:.o=.d)
