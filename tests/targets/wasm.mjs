// tests/targets: wasm.mjs MODULE: runs a WebAssembly firmware and writes its frame, big-endian RGB565;
// what it says goes to standard error.
import { readFileSync, writeSync } from "fs";

let memory;
const print = (address) => {
    const bytes = new Uint8Array(memory.buffer, address);
    writeSync(2, Buffer.from(bytes.subarray(0, bytes.indexOf(0))));
};
const { instance } = await WebAssembly.instantiate(readFileSync(process.argv[2]), { env: { print } });
memory = instance.exports.memory;
const status = instance.exports.start();
if (instance.exports.pixels) {
    const frame = Buffer.from(memory.buffer, instance.exports.pixels(), 320 * 240 * 2).swap16();
    for (let at = 0; at < frame.length; ) at += writeSync(1, frame, at);
}
process.exit(status === 0 ? 0 : 1);
