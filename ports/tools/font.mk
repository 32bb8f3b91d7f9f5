# font.mk: etch-font (BDF) and, where FreeType is, etch-font-ttf. Included by the Makefile.
$(BUILD)/etch-font: $(call obj,ports/tools/etch_font.c ports/tools/font_source.c)
	$(Q)$(CC) $(OPT) $(EXTRA) $^ -o $@
all: $(BUILD)/etch-font

.PHONY: etch-font etch-font-ttf
etch-font: $(BUILD)/etch-font ## turns BDF fonts into C: build/etch-font
etch-font-ttf: ## the same for TrueType; needs FreeType (libfreetype-dev)
	@mkdir -p $(BUILD)
	$(Q)$(CC) $(CFLAGS_HOST) $$(pkg-config --cflags freetype2 | sed 's/-I/-isystem /g') \
	    ports/tools/etch_font_ttf.c ports/tools/font_source.c $$(pkg-config --libs freetype2) \
	    -o $(BUILD)/etch-font-ttf
