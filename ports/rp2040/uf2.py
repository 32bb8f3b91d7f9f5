#!/usr/bin/env python3
"""uf2.py IMAGE.bin OUT.uf2: an image that begins with the second boot stage, as a file to drop on a
Pico in its boot mode. Adds the stage's checksum. Sources: Raspberry Pi, RP2040 data sheet, 2.8.1.3;
Microsoft, UF2 file format."""
import struct
import sys

FLASH = 0x10000000
FAMILY = 0xE48BFF56
BLOCK = 256


def crc32(data):
    """Polynomial 04C11DB7, from all ones, most significant bit first, not inverted."""
    crc = 0xFFFFFFFF
    for byte in data:
        crc ^= byte << 24
        for _ in range(8):
            crc = (crc << 1 ^ (0x04C11DB7 if crc >> 31 else 0)) & 0xFFFFFFFF
    return crc


def main():
    with open(sys.argv[1], "rb") as f:
        image = bytearray(f.read())
    image[252:256] = struct.pack("<I", crc32(image[:252]))
    image += bytes(-len(image) % BLOCK)
    count = len(image) // BLOCK
    with open(sys.argv[2], "wb") as f:
        for i in range(count):
            data = image[BLOCK * i:BLOCK * (i + 1)]
            head = struct.pack("<8I", 0x0A324655, 0x9E5D5157, 0x2000, FLASH + BLOCK * i, BLOCK, i,
                               count, FAMILY)
            f.write(head + data + bytes(476 - BLOCK) + struct.pack("<I", 0x0AB16F30))
    print(f"{sys.argv[2]}: {count} blocks")


main()
