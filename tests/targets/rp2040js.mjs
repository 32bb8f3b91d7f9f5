// tests/targets: rp2040js.mjs ELF.bin MODULES: runs a firmware on rp2040js (a package of npm, in
// MODULES) until its breakpoint. Writes its bytes on SPI0 and its pins D/C, CS and RESET in the form
// that glass.c reads; what it says, and what it cost, goes to standard error. A byte takes as long as
// on the wire at 31.25 MHz.
import { readFileSync, writeSync } from "fs";
import { createRequire } from "module";
import { resolve } from "path";

const [, , image, modules] = process.argv;
const { RP2040 } = createRequire(resolve(modules, "x"))("rp2040js");
const LIMIT = 2e9;
const mcu = new RP2040();
const quiet = () => {};
mcu.logger = { debug: quiet, info: quiet, warn: quiet, error: quiet };
mcu.flash.set(readFileSync(image), 0);

// The boot ROM would run the second stage, which does this.
const vectors = 0x10000100;
mcu.core.VTOR = vectors;
mcu.core.SP = mcu.readUint32(vectors);
mcu.core.PC = mcu.readUint32(vectors + 4) & ~1;

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

let stopped = false, instructions = 0, idle = 0;
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
    mcu.clock.tick(cycles * 8);
    while (onTheWire.length && onTheWire[0] <= mcu.core.cycles) {
        onTheWire.shift();
        mcu.spi[0].completeTransmit(0);
    }
}
flush();
console.error(`${instructions} instructions, ${idle} cycles asleep, ${bytes} bytes`);
process.exit(stopped ? 0 : 1);
