# Fuzzing: README.md here. FUZZ_RUNS executions of each target by `make fuzz`, FUZZ_SECONDS in total by
# `make fuzz-check`; FUZZ="scene" for one target.
FUZZ         ?= scene calls
FUZZ_RUNS    ?= 1000000
FUZZ_SECONDS ?= 60
FUZZ_DIR     := $(BUILD)/fuzz
FUZZ_C       := $(sort $(wildcard tests/fuzz/*.c))
FUZZ_CALLS   := $(filter tests/fuzz/calls%,$(FUZZ_C))
FUZZ_LIBS     = $(SIMLIB) $(LIB)

# The replay: the corpus and seeded sequences, by any compiler.
$(FUZZ_DIR)/replay-scene: $(call obj,tests/fuzz/replay.c tests/fuzz/fuzz.c tests/fuzz/scene.c) $(FUZZ_LIBS)
	@mkdir -p $(@D)
	$(Q)$(CC) $(OPT) $(EXTRA) $^ -o $@
$(FUZZ_DIR)/replay-calls: $(call obj,tests/fuzz/replay.c tests/fuzz/fuzz.c $(FUZZ_CALLS)) $(LIB)
	@mkdir -p $(@D)
	$(Q)$(CC) $(OPT) $(EXTRA) $^ -o $@
-include $(patsubst %.o,%.d,$(call obj,$(FUZZ_C)))

# The fuzzers, made by `make fuzz` with clang in a folder of their own.
$(FUZZ_DIR)/fuzz-scene: $(call obj,$(addprefix tests/fuzz/,libfuzzer.c fuzz.c scene.c scene_mutate.c)) \
    $(FUZZ_LIBS)
	@mkdir -p $(@D)
	$(Q)$(CC) $(OPT) $(EXTRA) -fsanitize=fuzzer $^ -o $@
$(FUZZ_DIR)/fuzz-calls: $(call obj,tests/fuzz/libfuzzer.c tests/fuzz/fuzz.c $(FUZZ_CALLS)) $(LIB)
	@mkdir -p $(@D)
	$(Q)$(CC) $(OPT) $(EXTRA) -fsanitize=fuzzer $^ -o $@

FUZZ_MAKE = +$(Q)$(MAKE1) CC=clang BUILD=$(BUILD)/fuzzed OPT="-O1 -g" \
            EXTRA="$(SANITIZE) -fsanitize=fuzzer-no-link" \
            CORE_EXTRA="-D'ETCH_ASSERT(x)=((x)?(void)0:__builtin_trap())'"
.PHONY: fuzz fuzz-build
fuzz-build:
	$(FUZZ_MAKE) $(foreach t,$(FUZZ),$(BUILD)/fuzzed/fuzz/fuzz-$(t))

# $(call fuzz_run,TARGET,LIMIT): from the packed corpus on, in a folder of its own.
FUZZ_LENGTH_scene := 320
FUZZ_LENGTH_calls := 652
define fuzz_run
	$(Q)rm -rf $(BUILD)/fuzzed/$(1) && mkdir -p $(BUILD)/fuzzed/$(1)
	$(Q)$(FUZZ_DIR)/replay-$(1) tests/fuzz/corpus/$(1).pack $(BUILD)/fuzzed/$(1)
	$(Q)sh tests/fuzz/run.sh $(1) $(BUILD)/fuzzed -max_len=$(FUZZ_LENGTH_$(1)) $(2)

endef
FUZZ_REPLAYS = $(foreach t,$(FUZZ),$(FUZZ_DIR)/replay-$(t))
fuzz: fuzz-build $(FUZZ_REPLAYS) ## FUZZ_RUNS executions of each fuzzer (FUZZ="scene calls")
	$(foreach t,$(FUZZ),$(call fuzz_run,$(t),-runs=$(FUZZ_RUNS)))
.PHONY: fuzz-check fuzz-pack fuzz-replay
fuzz-check: fuzz-build $(FUZZ_REPLAYS) ## FUZZ_SECONDS of them in total
	$(foreach t,$(FUZZ),$(call fuzz_run,$(t),-max_total_time=$(shell expr $(FUZZ_SECONDS) / $(words $(FUZZ)))))

# The inputs that reach what no other does, into the packs; after `make fuzz`.
fuzz-pack: fuzz-build $(FUZZ_REPLAYS) ## keeps in tests/fuzz/corpus what the fuzzers found
	$(foreach t,$(FUZZ),$(Q)sh tests/fuzz/pack.sh $(t) $(BUILD) $(FUZZ_LENGTH_$(t)) || exit 1;)

fuzz-replay: $(FUZZ_REPLAYS) ## the corpus of the fuzzers and seeded noise, without a fuzzer
	$(Q)$(RUN) $(FUZZ_DIR)/replay-scene tests/fuzz/corpus/scene.pack
	$(Q)$(RUN) $(FUZZ_DIR)/replay-calls tests/fuzz/corpus/calls.pack
	$(Q)sh tests/fuzz/public.sh $(call obj,$(FUZZ_CALLS))
