BOARDS += wasm
wasm_CC := clang --target=wasm32
wasm_SOURCES = ports/wasm/board.c $(FREESTANDING)
wasm_LINK := -nostdlib -Wl,--no-entry
wasm_AR := llvm-ar
wasm_LIBS :=
wasm_STRIP := 76800
wasm_BUFFERS := 1
wasm_FRAME := 320 240
wasm_SHOW := node tests/targets/wasm.mjs
wasm_RUN := node tests/targets/wasm.mjs
