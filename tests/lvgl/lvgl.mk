# LVGL above etch's panels, and etch's scenes in LVGL's widgets. LVGL, 9.3 or later, comes by path:
#       make run-lvgl LVGL_PATH=../lvgl
# Not part of `make check`. Included by the Makefile.
LVGL_DIR   := $(BUILD)/lvgl
LVGL_FLAGS := -O1 -DLV_CONF_SKIP=1 -DLV_USE_STDLIB_MALLOC=LV_STDLIB_CLIB
LVGL_SEE    = -isystem $(abspath $(LVGL_PATH)) -isystem $(abspath $(LVGL_PATH))/include
LVGL_OURS  := ports/lvgl/lvgl_display.c ports/lvgl/lvgl_surface.c tests/lvgl/main.c

.PHONY: run-lvgl lvgl-source
lvgl-source:
	@[ -f "$(LVGL_PATH)/src/lv_init.c" ] || { \
	    echo "LVGL_PATH must name a copy of LVGL, 9.3 or later (it has src/lv_init.c):"; \
	    echo "    git clone https://github.com/lvgl/lvgl"; \
	    echo "    make run-lvgl LVGL_PATH=lvgl"; exit 1; }

# The names of its objects hold their folders: some files have the same name.
$(LVGL_DIR)/liblvgl.a: | lvgl-source
	@mkdir -p $(@D)
	$(Q)cd $(abspath $(LVGL_PATH)) && find src -name '*.c' | xargs -P 2 -n 16 sh -c 'for f; do \
	    $(CC) $(LVGL_FLAGS) -w -I. -Iinclude -c "$$f" \
	    -o "$(abspath $(LVGL_DIR))/$$(echo "$$f" | tr / _).o" || exit 255; done' sh
	$(Q)$(AR) rcs $@ $(LVGL_DIR)/*.o

LVGL_OBJ   := $(call obj,tests/targets/scenes.c tests/targets/torus.c)

$(LVGL_DIR)/run: $(LVGL_DIR)/liblvgl.a $(LVGL_OURS) $(LVGL_OBJ) $(SIMLIB) $(LIB)
	$(Q)$(CC) $(CFLAGS_HOST) $(LVGL_FLAGS) $(LVGL_SEE) $(LVGL_OURS) $(LVGL_OBJ) \
	    $(SIMLIB) $(LIB) $< -lm -o $@

run-lvgl: lvgl-source $(LVGL_DIR)/run ## LVGL above a panel, etch in its widgets (LVGL_PATH=dir)
	$(Q)$(LVGL_DIR)/run
