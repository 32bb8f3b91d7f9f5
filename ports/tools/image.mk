# image.mk: etch-image (PPM, PGM; PNG where libpng is). Included by the Makefile.
IMAGE_TOOL := $(filter-out ports/tools/image_png.c ports/tools/image_no_png.c,\
              $(wildcard ports/tools/etch_image.c ports/tools/image_*.c))

# libpng is there if a program with it links, for the same target and with the same flags.
$(BUILD)/etch-image: $(call obj,$(IMAGE_TOOL)) ports/tools/image_png.c ports/tools/image_no_png.c
	@if printf '#include <png.h>\nint main(void) { return png_access_version_number() == 0; }\n' | \
	    $(CC) $(OPT) $(EXTRA) -x c - -lpng -o $@.probe 2>/dev/null; \
	then set -- ports/tools/image_png.c -lpng; else set -- ports/tools/image_no_png.c; fi; \
	rm -f $@.probe; \
	$(if $(V),set -x;) $(CC) $(CFLAGS_HOST) $(filter %.o,$^) "$$@" -lm -o $@
all: $(BUILD)/etch-image
-include $(patsubst %.o,%.d,$(call obj,$(IMAGE_TOOL)))

.PHONY: etch-image
etch-image: $(BUILD)/etch-image ## turns PPM and PNG pictures into C: build/etch-image
