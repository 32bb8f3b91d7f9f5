// tests/targets: rp2040js.mjs IMAGE.uf2 MODULES: puts an image into the flash of rp2040js (a package of
// npm, in MODULES), starts it as the boot ROM would and runs it until its breakpoint. Writes its bytes
// on SPI0 and its pins D/C, CS and RESET in the form that glass.c reads; what it says, and what it
// cost, goes to standard error. Both cores run, see rp2040_core1.mjs. A byte takes as long as on the wire at 31.25 MHz.
import { readFileSync, writeSync } from "fs";
import { createRequire } from "module";
import { resolve } from "path";
import { addCore1 } from "./rp2040_core1.mjs";

const [, , image, modules] = process.argv;
const { RP2040 } = createRequire(resolve(modules, "x"))("rp2040js");
const LIMIT = 2e9;
const mcu = new RP2040();
const quiet = () => {};
mcu.logger = { debug: quiet, info: quiet, warn: quiet, error: quiet };

const refuse = (reason) => {
    console.error(reason);
    process.exit(1);
};

// UF2: blocks of 512 bytes, 256 of them for flash.
const FLASH = 0x10000000, FAMILY = 0xe48bff56;
const file = readFileSync(image);
for (let at = 0; at < file.length; at += 512) {
    const block = new DataView(file.buffer, file.byteOffset + at, 512);
    const word = (i) => block.getUint32(i, true);
    if (word(0) !== 0x0a324655 || word(4) !== 0x9e5d5157 || word(508) !== 0x0ab16f30 ||
        word(16) !== 256 || word(28) !== FAMILY || word(20) !== at / 512)
        refuse(`block ${at / 512} is not one of UF2 for an RP2040`);
    mcu.flash.set(file.subarray(at + 32, at + 32 + 256), word(12) - FLASH);
}

// The boot ROM checks the second stage, copies it to the end of RAM and runs it there.
const STAGE = 0x20041f00;
let crc = 0xffffffff;
for (const byte of mcu.flash.subarray(0, 252)) {
    crc ^= byte << 24;
    for (let bit = 0; bit < 8; bit++) crc = crc < 0 || crc >= 0x80000000 ? (crc << 1) ^ 0x04c11db7 : crc << 1;
}
if (crc >>> 0 !== mcu.readUint32(FLASH + 252)) refuse("the second stage has a wrong checksum");
for (let i = 0; i < 256; i += 4) mcu.writeUint32(STAGE + i, mcu.readUint32(FLASH + i));
mcu.core.SP = STAGE;
mcu.core.PC = STAGE;

let lines = [];
const line = (text) => {
    lines.push(text);
    if (lines.length >= 4096) flush();
};
const flush = () => {
    const text = Buffer.from(lines.join(""));
    for (let at = 0; at < text.length; ) {
        try {
            at += writeSync(1, text, at);
        } catch (error) {
            if (error.code !== "EAGAIN") throw error;
        }
    }
    lines = [];
};

const DC = 20, CS = 17, RESET = 21;
const high = (pin) => (mcu.gpio[pin].value === 1 ? 1 : 0);
const pins = () =>
    line(`addr 0x2 value 0x${(high(DC) | (high(CS) << 1) | (high(RESET) << 2)).toString(16)}\n`);
for (const pin of [DC, CS, RESET]) mcu.gpio[pin].addListener(pins);

const CYCLES_A_BYTE = 8 * 4; // 31.25 MHz of 125
let onTheWire = [], last = 0, bytes = 0;
mcu.spi[0].onTransmit = (value) => {
    bytes++;
    line(`addr 0x1 value 0x${value.toString(16)}\n`);
    last = Math.max(last, mcu.core.cycles) + CYCLES_A_BYTE;
    onTheWire.push(last);
};
mcu.uart[0].onByte = (value) => writeSync(2, Buffer.from([value]));

// What each core executes while a pin is high that says so.
const core1 = addCore1(mcu), DRAWS = 22;
let drawn;
mcu.gpio[DRAWS].addListener(() => {
    const now = [instructions, core1.instructions];
    if (high(DRAWS)) drawn = now;
    else if (drawn) drawn = now.map((n, i) => n - drawn[i]);
});
let stopped = false, instructions = 0, idle = 0, began = mcu.core.cycles;
mcu.onBreak = () => (stopped = true);
while (!stopped && instructions < LIMIT) {
    let cycles = 1;
    if (mcu.core.waiting) {
        idle++;
        mcu.core.cycles++;
    } else {
        cycles = mcu.core.executeInstruction();
        instructions++;
    }
    core1.runUntil(mcu.core.cycles);
    mcu.clock.tick(cycles * 8);
    while (onTheWire.length && onTheWire[0] <= mcu.core.cycles) {
        onTheWire.shift();
        mcu.spi[0].completeTransmit(0);
    }
}
flush();
console.error(`${instructions} instructions, ${idle} cycles of waiting, ` +
              `${mcu.core.cycles - began} cycles, ${bytes} bytes`);
if (drawn) console.error(`while GP${DRAWS} was high: ${drawn.join(" ")} instructions`);
process.exit(stopped ? 0 : 1);
