# Builds the panel drivers into the library, freestanding like core and hal; and an archive of the
# simulated panels, with what they call, for the unit tests, which link it after the library.
LCD       := $(sort $(wildcard ports/spi_lcd/*.c))
LCD_OBJ   := $(call obj,$(LCD))
PANEL_OBJ := $(call obj,$(sort $(wildcard ports/host/panel*.c)))
PANEL_LIB := $(BUILD)/libpanel.a

$(LCD_OBJ): CFLAGS_HOST = $(CFLAGS_CORE)
$(LIB): $(LCD_OBJ)
$(UNIT_TEST): $(PANEL_LIB)

$(PANEL_LIB): $(PANEL_OBJ) $(LCD_OBJ) $(call obj,hal/transfer.c)
	@rm -f $@
	$(Q)$(AR) rcs $@ $^

-include $(LCD_OBJ:.o=.d) $(PANEL_OBJ:.o=.d)
