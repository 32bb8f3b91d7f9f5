#!/bin/sh
# esp32.sh ELF: runs the component for ESP32 above its pretended driver and writes what the panel shows.
set -eu
"$1" >"$1.trace"
"$BUILD/targets/glass" ili9341 1 byte=1 data.level=2:1 select.level=2:2 reset.level=2:4 <"$1.trace"
rm "$1.trace"
