# Sketches for Adafruit GFX and TFT_eSPI with another include (ports/familiar), compiled as C++ by clang and by
# g++, on the simulated panel against frozen pictures. Included by the Makefile.
CHECK_STEPS += familiar

FAMILIAR_DIR     := $(BUILD)/familiar
FAMILIAR_SKETCHES := graphics clock
FAMILIAR_FLAGS   := -std=c++11 -Wall -Wextra -Wpedantic -Werror -fno-exceptions -fno-rtti -I. $(OPT) $(EXTRA)

$(FAMILIAR_DIR)/%-clang.o $(FAMILIAR_DIR)/%-g++.o: tests/familiar/%.ino tests/familiar/glue.cpp tests/familiar/glue.h \
    $(wildcard ports/familiar/*)
	@mkdir -p $(@D)
	$(Q)clang++ $(FAMILIAR_FLAGS) -DSKETCH='"$<"' -c tests/familiar/glue.cpp -o $(FAMILIAR_DIR)/$*-clang.o
	$(Q)g++ $(FAMILIAR_FLAGS) -DSKETCH='"$<"' -c tests/familiar/glue.cpp -o $(FAMILIAR_DIR)/$*-g++.o
$(FAMILIAR_DIR)/%: $(FAMILIAR_DIR)/%.o $(call obj,tests/familiar/run.c) $(SIMLIB) $(LIB)
	$(Q)$(CC) $(OPT) $(EXTRA) $^ -lm -o $@
-include $(patsubst %.o,%.d,$(call obj,tests/familiar/run.c))

FAMILIAR = $(foreach s,$(FAMILIAR_SKETCHES),$(FAMILIAR_DIR)/$(s)-clang $(FAMILIAR_DIR)/$(s)-g++)
.PHONY: familiar familiar-update
familiar: $(FAMILIAR) $(PICTURES) ## sketches with another include, on the simulated panel
	$(Q)BUILD=$(BUILD) RUN="$(RUN)" sh tests/familiar/run $(FAMILIAR_SKETCHES)
familiar-update: $(FAMILIAR) ## takes what they draw now as frozen
	$(Q)for s in $(FAMILIAR_SKETCHES); do $(FAMILIAR_DIR)/$$s-clang tests/familiar/$$s.png || exit 1; done
.PRECIOUS: $(FAMILIAR_DIR)/%-clang.o $(FAMILIAR_DIR)/%-g++.o
