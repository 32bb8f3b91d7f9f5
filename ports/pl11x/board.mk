# Two boards of one folder, which differ in addresses.
BOARDS += versatilepb vexpress-a15
versatilepb_CC := arm-none-eabi-gcc -mcpu=arm926ej-s -marm -DPL11X_BASE=0x10120000 \
    -DPL11X_CONTROL=0x18 -DPL11X_FORMAT=4 -DPL11X_MUX=0x10000050
versatilepb_LINK := -nostdlib -Llinker -T versatilepb.ld
vexpress-a15_CC := arm-none-eabi-gcc -mcpu=cortex-a15 -marm -mfloat-abi=soft \
    -mno-unaligned-access -DPL11X_BASE=0x1C1F0000 -DPL11X_CONTROL=0x18 -DPL11X_FORMAT=6
vexpress-a15_LINK := -nostdlib -Llinker -T vexpress_a15.ld
$(foreach b,versatilepb vexpress-a15,\
    $(eval $(b)_SOURCES = ports/pl11x/start.S ports/pl11x/board.c $$(FREESTANDING))\
    $(eval $(b)_SPEED ?= 100 0 cpu -)\
    $(eval $(b)_STRIP := 76800)\
    $(eval $(b)_BUFFERS := 1)\
    $(eval $(b)_FRAME := 320 240)\
    $(eval $(b)_SHOW := python3 tests/targets/qemu_screen.py 1 qemu-system-arm -M $(b) \
        -semihosting-config enable=on,target=native -kernel)\
    $(eval $(b)_RUN = $$(CORTEX_M_RUN) -M $(b) -kernel))
