# Big-endian machines.
BOARDS += linux-mips64 linux-aarch64be
linux-mips64_CC := clang --target=mips64-linux-gnuabi64 -fno-pic -mno-abicalls -G0
linux-aarch64be_CC := clang --target=aarch64_be-linux-gnu
linux-mips64_SHOW := qemu-mips64-static
linux-aarch64be_SHOW := qemu-aarch64_be-static
$(foreach b,linux-mips64 linux-aarch64be,\
    $(eval $(b)_SOURCES = ports/linux_bare/board.c $$(FREESTANDING))\
    $(eval $(b)_LINK := -nostdlib -static -fuse-ld=lld -Wl,-estart)\
    $(eval $(b)_LIBS :=)\
    $(eval $(b)_STRIP := 76800)\
    $(eval $(b)_BUFFERS := 1)\
    $(eval $(b)_FRAME := 320 240))
linux-mips64_RUN := qemu-mips64-static
