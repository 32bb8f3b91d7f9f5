# The table of panels in ports/README.md.
PANEL_TABLE := $(BUILD)/panel-table

$(PANEL_TABLE): $(call obj,tests/panels/table.c) $(BUILD)/libpanel.a $(LIB)
	$(Q)$(CC) $(OPT) $(EXTRA) $^ -o $@

.PHONY: panels panels-update
panels: $(PANEL_TABLE) ## checks the table of panels in ports/README.md against what is sent
	$(Q)RUN="$(RUN)" sh tests/panels/table.sh check $(BUILD)
panels-update: $(PANEL_TABLE) ## writes the table of panels into ports/README.md
	$(Q)RUN="$(RUN)" sh tests/panels/table.sh update $(BUILD)

TEST_STEPS += panels
-include $(BUILD)/tests/panels/table.d
