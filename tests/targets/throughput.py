#!/usr/bin/env python3
"""throughput.py BUILD BOARD CPU_MHZ BUS_MHZ HOW BYTE COMMAND ..: one row of the table in ports/README.md:
what a frame of spin.c costs on a board. HOW tells who feeds the bus, cpu or dma; with BUS_MHZ 0 there is
none. BYTE is the address of the register that takes a byte for the bus.

COMMAND runs an ELF file under QEMU, which counts instructions (tests/bench/plugin.c) and logs what is
written to BYTE; or it is one of the scripts for rp2040js and simavr, which count cycles. Two programs are
run, of 1 and of 9 frames: what they send differs by 8 frames."""
import os
import re
import subprocess
import sys
import threading

FRAMES = 8
SENDERS = {"send", "data", "spin"}  # functions of board.c that only feed the bus


def senders(elf, nm):
    """Addresses of the board's functions that wait for the bus."""
    table = subprocess.run([nm, "-S", elf], capture_output=True, text=True, check=True).stdout
    found = []
    for line in table.splitlines():
        if (m := re.fullmatch(r"(\w+) (\w+) [tT] (\w+)", line)) and m[3] in SENDERS:
            found.append((int(m[1], 16) & ~1, int(m[1], 16) + int(m[2], 16)))
    return found


def run_qemu(build, command, elf, byte):
    """Instructions per address between the marks, and bytes on the bus, of a whole run."""
    counts, trace = elf + ".counts", elf + ".fifo"
    for path in counts, trace:
        if os.path.exists(path):
            os.remove(path)
    os.mkfifo(trace)
    sent = [0]

    def count_bytes():
        needle = f"addr 0x{byte}".encode()
        with open(trace, "rb") as f:
            for line in f:
                sent[0] += needle in line

    reader = threading.Thread(target=count_bytes)
    reader.start()
    at = command.index("-kernel")
    qemu = subprocess.Popen(
        ["timeout", "120"] + command[:at] + ["-plugin", f"{build}/bench/plugin.so,out={counts}"] +
        ["-trace", "memory_region_ops_write", "-D", trace, "-kernel", elf],
        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        env=dict(os.environ, QEMU_AUDIO_DRV="none"))
    said = b""
    for line in qemu.stdout:
        said += line
        if b"drawn" in line:
            qemu.terminate()
            break
    qemu.wait()
    try:  # the reader still waits if QEMU did not start
        os.close(os.open(trace, os.O_WRONLY | os.O_NONBLOCK))
    except OSError:
        pass
    reader.join()
    os.remove(trace)
    if b"drawn\n" not in said:
        sys.exit(f"{elf} did not draw: {said!r}")
    with open(counts, encoding="ascii") as f:
        rows = [line.split() for line in f]
    return [(int(r[0], 16), int(r[1])) for r in rows], sent[0]


def measure_qemu(build, command, elfs, byte):
    (_, before), (counts, after) = (run_qemu(build, command, e, byte) for e in elfs)
    waiting = senders(elfs[1], os.environ["NM"])
    drawing = sum(n for a, n in counts if not any(lo <= a < hi for lo, hi in waiting))
    return drawing, drawing, drawing, after - before


def measure_cycles(command, elfs):
    """The scripts say "I instructions, W cycles of waiting, C cycles, B bytes"."""
    results = []
    for elf in elfs:
        waiting = " ".join(f"{lo} {hi}" for lo, hi in senders(elf, os.environ["NM"]))
        said = subprocess.run(command + [elf], check=True, stdin=subprocess.DEVNULL,
                              env=dict(os.environ, WAITING=waiting),
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT).stdout
        m = re.search(rb"(\d+) instructions, (\d+) cycles of waiting, (\d+) cycles, (\d+) bytes", said)
        if m is None or b"drawn" not in said:
            sys.exit(f"{elf} did not draw: {said!r}")
        results.append([int(n) for n in m.groups()])
    instructions, waiting, cycles, sent = (b - a for a, b in zip(*results))
    return instructions, cycles - waiting, cycles, sent


def main():
    build, board, cpu, bus, how, byte = sys.argv[1:7]
    command, cpu, bus = sys.argv[7:], float(cpu), float(bus)
    elfs = [f"{build}/targets/{board}/spin-{n}.elf" for n in (0, FRAMES)]
    qemu = "-kernel" in command
    instructions, cycles, total, sent = (measure_qemu(build, command, elfs, byte) if qemu else
                                         measure_cycles(command, elfs))
    if instructions <= 0 or (bus > 0) != (sent > 0) or sent % FRAMES != 0:
        sys.exit(f"{board}: {instructions} instructions, {sent} bytes")
    drawing = cycles / FRAMES / cpu / 1000  # ms; QEMU: a cycle an instruction
    sending = sent / FRAMES * 8 / bus / 1000 if bus else 0
    # By DMA both go on at once: what was counted is what a frame took.
    frame = total / FRAMES / cpu / 1000 if how == "dma" else drawing + sending
    print(f"| `{board}` | {cpu:g} | {instructions // FRAMES} | "
          f"{'' if qemu else cycles // FRAMES} | {drawing:.2f} | " +
          (f"{sent // FRAMES} | {bus:g}, {how} | {sending:.2f} | " if bus else "| | | ") +
          f"{'bus' if sending > drawing else 'CPU'} | {'<= ' if qemu else ''}{1000 / frame:.1f} |")


main()
