# The component on the host, above a driver that pretends (tests/targets/esp32): no emulator is at hand.
BOARDS += esp32-host
esp32-host_CC := gcc
esp32-host_FLAGS := -Itests/targets/esp32
esp32-host_SOURCES = ports/esp32/etch_esp32.c tests/targets/esp32/board.c $(SPI_LCD)
esp32-host_LINK :=
esp32-host_LIBS :=
esp32-host_STRIP := 5120
esp32-host_BUFFERS := 2
esp32-host_FRAME := 320 240
esp32-host_SHOW := sh tests/targets/esp32.sh
