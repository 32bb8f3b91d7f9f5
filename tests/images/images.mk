# tests/images: etch-image's C compiles and draws the picture that it was made of. Included by the
# Makefile. `make images` needs only gcc; `make images-png` is for what libpng adds.
TEST_STEPS  += images
CHECK_STEPS += images-png

.PHONY: images images-png
images: $(BUILD)/etch-image $(LIB) ## every format of etch-image, there and back
	$(Q)BUILD=$(BUILD) CC="$(CC)" FLAGS="$(CFLAGS_HOST)" RUN="$(RUN)" sh tests/images/run

images-png: $(BUILD)/etch-image ## PNG files give what the same pictures give as PPM
	$(Q)BUILD=$(BUILD) python3 tests/images/png.py
