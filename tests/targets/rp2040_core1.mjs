// tests/targets: the second core of the RP2040, which rp2040js lacks. It runs in lock step with the
// first: addCore1(mcu).runUntil(cycles) goes on until it has lived as long. Memory, flash and
// peripherals are the same; of its own are the core, its NVIC and its side of the FIFOs. SEV wakes
// both. Its boot ROM waits for the words that start it, and repeats them. Not there: interrupts
// (peripherals have one line, to core 0) and a divider of its own.
// Source: Raspberry Pi, RP2040 data sheet, 2.3.1 and 2.8.2.

const CPUID = 0x00, FIFO_ST = 0x50, FIFO_WR = 0x54, FIFO_RD = 0x58;
const FIFO_VALID = 1, FIFO_READY = 2, FIFO_WORDS = 8;

// The boot ROM: the words that core 1 has got so far; it starts after 0, 0, 1, vectors, stack,
// entry.
class BootRom {
    words = [];
    take(word) {
        const expected = [0, 0, 1][this.words.length];
        if (expected === undefined || expected === word) this.words.push(word);
        else this.words = [];
        return word;
    }
    get done() {
        return this.words.length === 6;
    }
}

export function addCore1(mcu) {
    const Core = mcu.core.constructor, Ppb = mcu.ppb.constructor, Sio = mcu.sio.constructor;
    const chip = Object.create(mcu); // as core 1 sees it
    const core = new Core(chip), rom = new BootRom();
    const fifo = [[], []]; // what core 0, core 1 can read
    const cores = [mcu.core, core];
    let running = false;
    const self = { instructions: 0, runUntil };

    chip.core = core;
    chip.ppb = new Ppb(chip, "PPB1");
    const shared = mcu.sio, read = Sio.prototype.readUint32, write = Sio.prototype.writeUint32;
    const side = (id) => ({
        readUint32(offset) {
            switch (offset) {
                case CPUID: return id;
                case FIFO_ST:
                    return (fifo[id].length ? FIFO_VALID : 0) |
                        (fifo[1 - id].length < FIFO_WORDS ? FIFO_READY : 0);
                case FIFO_RD: return fifo[id].length ? fifo[id].shift() : 0;
            }
            return read.call(shared, offset);
        },
        writeUint32(offset, value) {
            if (offset !== FIFO_WR) return write.call(shared, offset, value);
            if (id === 0 && !running) fifo[0].push(rom.take(value >>> 0));
            else if (fifo[1 - id].length < FIFO_WORDS) fifo[1 - id].push(value >>> 0);
            event();
        },
    });
    Object.assign(shared, side(0));
    chip.sio = side(1);

    // An event for both cores: SEV, of which rp2040js only writes to its log, and words in a FIFO.
    function event() {
        for (const c of cores) {
            c.eventRegistered = !c.waiting;
            c.waiting = false;
        }
    }
    const log = mcu.logger;
    mcu.logger = { ...log, info: (who, text) => text === "SEV" ? event() : log.info(who, text) };

    function runUntil(cycles) {
        if (!running && rom.done) {
            const [, , , vectors, stack, entry] = rom.words;
            running = true;
            core.VTOR = vectors;
            core.SP = stack;
            core.PC = entry & ~1;
            core.cycles = cycles;
        }
        while (running && core.cycles < cycles) {
            if (core.waiting) core.cycles++;
            else {
                core.executeInstruction();
                self.instructions++;
            }
        }
    }
    return self;
}
