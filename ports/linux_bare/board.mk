# Big-endian machines.
BOARDS += linux-mips64 linux-aarch64be
linux-mips64_CC := clang --target=mips64-linux-gnuabi64 -fno-pic -mno-abicalls -G0
# clang 14 gets vectorized loops wrong that select between channels: the same LLVM code gives the
# right pixels on AArch64 of the other byte order.
linux-aarch64be_CC := clang --target=aarch64_be-linux-gnu -fno-vectorize
linux-mips64_SHOW := qemu-mips64-static
linux-aarch64be_SHOW := qemu-aarch64_be-static
$(foreach b,linux-mips64 linux-aarch64be,\
    $(eval $(b)_SOURCES = ports/linux_bare/board.c $$(FREESTANDING))\
    $(eval $(b)_LINK := -nostdlib -static -fuse-ld=lld -Wl,-estart)\
    $(eval $(b)_LIBS :=)\
    $(eval $(b)_STRIP := 76800)\
    $(eval $(b)_BUFFERS := 1)\
    $(eval $(b)_FRAME := 320 240)\
    $(eval $(b)_RUN := $$($(b)_SHOW)))
