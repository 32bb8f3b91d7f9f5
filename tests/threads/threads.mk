# Several threads: tasks, their transfers, and workers, under ThreadSanitizer. Included by the
# Makefile.
THREADS     := $(BUILD)/threads-test
THREADS_SRC := $(sort $(wildcard tests/threads/*.c ports/pthread/*.c)) tests/harness/harness.c
THREADS_OBJ := $(call obj,$(THREADS_SRC))
# Scenes of 320 x 240 that differ in what they use.
THREADS_SCENES := $(patsubst %,tests/scenes/%.scene,shapes text teapot)

$(THREADS): $(THREADS_OBJ) $(SIMLIB) $(LIB)
	$(Q)$(CC) $(OPT) $(EXTRA) $^ -lpthread -o $@

.PHONY: threads tsan
threads: $(THREADS) ## tasks and workers on POSIX threads draw what one thread draws
	$(Q)sh tests/threads/example.sh $(BUILD) "$(CC)" "$(EXTRA)"
	$(Q)$(THREADS) $(THREADS_SCENES)
tsan: ## the same under ThreadSanitizer, which wants addresses that are not too random
	+$(Q)setarch -R true 2>/dev/null && fixed="setarch -R"; \
	    TSAN_OPTIONS=halt_on_error=1 $$fixed $(MAKE1) threads BUILD=$(BUILD)/tsan OPT="-O1 -g" \
	    EXTRA="$(EXTRA) -fsanitize=thread"

CHECK_STEPS += tsan
-include $(THREADS_OBJ:.o=.d)
