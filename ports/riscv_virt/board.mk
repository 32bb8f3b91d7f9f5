# Two boards of one folder: 32 and 64 bits.
BOARDS += riscv32-virt riscv64-virt
riscv32-virt_CC := riscv64-unknown-elf-gcc -march=rv32imac -mabi=ilp32
riscv64-virt_CC := riscv64-unknown-elf-gcc -march=rv64imac -mabi=lp64 -mcmodel=medany
riscv32-virt_QEMU := qemu-system-riscv32
riscv64-virt_QEMU := qemu-system-riscv64
$(foreach b,riscv32-virt riscv64-virt,\
    $(eval $(b)_SOURCES = ports/riscv_virt/start.S ports/riscv_virt/board.c $$(FREESTANDING))\
    $(eval $(b)_LINK := -nostdlib -Llinker -T riscv_virt.ld -Wl,--no-warn-rwx-segments)\
    $(eval $(b)_SPEED ?= 100 0 cpu -)\
    $(eval $(b)_STRIP := 76800)\
    $(eval $(b)_BUFFERS := 1)\
    $(eval $(b)_FRAME := 320 240)\
    $(eval $(b)_SHOW := python3 tests/targets/qemu_screen.py 1 $($(b)_QEMU) -M virt -bios none \
        -device bochs-display,romfile= -semihosting-config enable=on,target=native -kernel))
$(foreach b,riscv32-virt riscv64-virt,\
    $(eval $(b)_RUN := $($(b)_QEMU) -M virt -bios none \
        -device bochs-display,romfile= -display none -monitor none -serial null \
        -semihosting-config enable=on,target=native -kernel))
