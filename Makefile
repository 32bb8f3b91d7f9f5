# etch: `make help` lists the targets. Output goes to build/ only.
CC      ?= gcc
BUILD   ?= build
OPT     ?= -O2 -g
WARN    := -std=c11 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wvla -Wmissing-prototypes \
           -Wdouble-promotion -Werror
CFLAGS_CORE = $(WARN) -ffreestanding $(OPT) $(EXTRA)
CFLAGS_HOST = $(WARN) $(OPT) $(EXTRA)

CORE  := $(sort $(wildcard core/*/*.c))
HAL   := $(sort $(wildcard hal/*.c ports/framebuffer/*.c))
HOST  := $(sort $(wildcard ports/host/*.c))
UNIT  := $(sort $(wildcard tests/unit/*.c))
TEST  := $(UNIT) $(sort $(wildcard tests/harness/*.c tests/oracle/*.c))

obj = $(patsubst %.c,$(BUILD)/%.o,$(1))

.PHONY: all
all: $(BUILD)/libetch.a ## library

$(BUILD)/libetch.a: $(call obj,$(CORE) $(HAL))
	@rm -f $@
	$(AR) rcs $@ $^

$(BUILD)/core/%.o: core/%.c
	@mkdir -p $(@D)
	$(CC) $(CFLAGS_CORE) -MMD -c $< -o $@
$(BUILD)/hal/%.o: hal/%.c
	@mkdir -p $(@D)
	$(CC) $(CFLAGS_CORE) -MMD -c $< -o $@
$(BUILD)/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(CFLAGS_HOST) -MMD -c $< -o $@

-include $(shell find $(BUILD) -name '*.d' 2>/dev/null)
