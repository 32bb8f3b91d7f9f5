# Every triangle, line and circle of a small grid. See grid.h.
EXHAUSTIVE := $(BUILD)/exhaustive
$(EXHAUSTIVE): $(call obj,$(wildcard tests/exhaustive/*.c) tests/oracle/line.c tests/oracle/circle.c) $(LIB)
	$(Q)$(CC) $(OPT) $(EXTRA) $^ -o $@
.PHONY: exhaustive
exhaustive: $(EXHAUSTIVE) ## every triangle, line and circle of a small grid, clipped every way, on two cores
	$(Q)$(EXHAUSTIVE) 1 2 >$(EXHAUSTIVE).1 & half=$$!; $(EXHAUSTIVE) 0 2; bad=$$?; \
	    wait $$half || bad=1; cat $(EXHAUSTIVE).1; exit $$bad
