# Built, not run: no emulator here has its display controller.
BUILT_BOARDS += stm32f429i-disc1
stm32f429i-disc1_CC := arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb
stm32f429i-disc1_SOURCES = ports/stm32f429i_disc1/board.c $(CORTEX_M) $(CORTEX_M_IDLE)
stm32f429i-disc1_LINK := -nostdlib -Llinker -T stm32f429i_disc1.ld
stm32f429i-disc1_STRIP := 4800
stm32f429i-disc1_BUFFERS := 1
stm32f429i-disc1_FRAME := 240 320
stm32f429i-disc1_SCENES := shapes torus floor
