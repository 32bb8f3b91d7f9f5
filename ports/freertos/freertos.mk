# Tasks of FreeRTOS and the interrupts of their panel on an MPS2 under QEMU. The kernel comes by
# path:
#       make run-freertos FREERTOS_KERNEL_PATH=../FreeRTOS-Kernel
# Not part of `make check`. Included by the Makefile.
FREERTOS_DIR := $(BUILD)/targets/freertos
FREERTOS_CC  := arm-none-eabi-gcc -mcpu=cortex-m3 -mthumb
FREERTOS_KERNEL = $(addprefix $(abspath $(FREERTOS_KERNEL_PATH))/,tasks.c list.c \
    portable/GCC/ARM_CM3/port.c)
FREERTOS_FOLDERS = $(addprefix $(abspath $(FREERTOS_KERNEL_PATH))/,include portable/GCC/ARM_CM3)
FREERTOS_OURS := $(addprefix ports/freertos/,freertos_monitor.c mps2.c main.c) ports/mps2/board.c \
    ports/cortex_m/start.c ports/cortex_m/print.c ports/cortex_m/exit.c \
    ports/freestanding/memory.c \
    ports/spi_lcd/dcs.c ports/spi_lcd/ili9341.c ports/spi_lcd/lcd.c ports/spi_lcd/lcd_open.c \
    ports/spi_lcd/lcd_pixels.c ports/spi_lcd/lcd_set.c tests/targets/scenes.c tests/targets/torus.c
FREERTOS_SCENES := shapes torus floor

.PHONY: run-freertos freertos-kernel
freertos-kernel:
	@[ -f "$(FREERTOS_KERNEL_PATH)/tasks.c" ] || { \
	    echo "FREERTOS_KERNEL_PATH must name a copy of FreeRTOS-Kernel (it has tasks.c):"; \
	    echo "    git clone https://github.com/FreeRTOS/FreeRTOS-Kernel"; \
	    echo "    make run-freertos FREERTOS_KERNEL_PATH=FreeRTOS-Kernel"; exit 1; }

FREERTOS_LIB := $(BUILD)/targets/mps2-an385/used.a # hal, and what the scenes use of core

# $(call freertos,WORKERS,SCENE)
define freertos
$(FREERTOS_DIR)-$(1)/$(2).elf: freertos-kernel $(FREERTOS_DIR)/kernel.a $(FREERTOS_LIB) \
    $(FREERTOS_OURS)
	@mkdir -p $$(@D)
	$(Q)$(FREERTOS_CC) $$(TARGET_FLAGS) -Iports/freertos \
	    $$(patsubst %,-isystem %,$$(FREERTOS_FOLDERS)) -DWORKERS=$(1) -DSCENE=target_$(2) \
	    -nostdlib -Llinker -T mps2_lcd.ld -Wl,--gc-sections \
	    $(FREERTOS_OURS) $(FREERTOS_LIB) $(FREERTOS_DIR)/kernel.a -lgcc -o $$@
endef
$(foreach w,1 2,$(foreach s,$(FREERTOS_SCENES),$(eval $(call freertos,$(w),$(s)))))
FREERTOS_ELFS := $(foreach w,1 2,$(foreach s,$(FREERTOS_SCENES),$(FREERTOS_DIR)-$(w)/$(s).elf))

$(FREERTOS_DIR)/kernel.a: freertos-kernel ports/freertos/FreeRTOSConfig.h
	@mkdir -p $(@D) && rm -f $(@D)/*.o $@
	$(Q)cd $(@D) && $(FREERTOS_CC) -O2 -g -ffunction-sections -c -I$(CURDIR)/ports/freertos \
	    $(patsubst %,-I%,$(FREERTOS_FOLDERS)) $(FREERTOS_KERNEL)
	$(Q)arm-none-eabi-ar rcs $@ $(@D)/*.o

run-freertos: freertos-kernel $(BUILD)/targets/reference $(BUILD)/targets/glass \
    $(BUILD)/targets/core.list ## tasks of FreeRTOS (FREERTOS_KERNEL_PATH=dir) on an MPS2
	+$(Q)$(MAKE1) $(FREERTOS_ELFS)
	$(Q)for w in 1 2; do BUILD=$(BUILD) sh tests/targets/compare.sh freertos-$$w "320 240" \
	    "$(mps2-an385_SHOW)" $(FREERTOS_SCENES) || exit 1; done
