# tests/fonts: what etch-font writes and what it refuses. Included by the Makefile.
TEST_STEPS += fonts

.PHONY: fonts
fonts: $(BUILD)/etch-font ## BDF fonts as C, and what is no font
	$(Q)BUILD=$(BUILD) RUN="$(RUN)" sh tests/fonts/run
