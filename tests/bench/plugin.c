/* bench/plugin.c: a QEMU plugin that counts what a firmware executes between two markers.
 *
 * Loaded by bench.mk into qemu-system-arm (QEMU 7.2, plugin API version 1, whose header Debian
 * does not package: the few prototypes used are declared here). Counting is on from the first
 * instruction of `bench_counted` to the first of `bench_done`. QEMU runs translated blocks
 * from end to end, so one counter per block gives every instruction in it.
 *
 * Output, one line per address that was executed:  address count taken cycles
 *   taken   how often a conditional branch was taken, else 0
 *   cycles  what the Cortex-M0+ model below says they cost together
 * With each=FILE also a line for every count, in order: its instructions.
 * Thumb-2 code (Cortex-M4) gets counts only; its cycles mean nothing.
 *
 * The model: Cortex-M0+ r0p1 technical reference manual, table of instruction timings, memory
 * without wait states, single-cycle multiplier (as in the RP2040 with code in RAM or in the
 * cache; no bus contention):
 *   load or store 2; load-, store-multiple, push, pop of n registers 1 + n; pop with pc 3 + n
 *   branch 2, conditional branch 2 taken, 1 not; bl 3; bx, blx, a write of pc 2
 *   mrs, msr, dmb, dsb, isb 3; everything else, mul too, 1
 */
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EXPORT __attribute__((visibility("default")))

/* ---- QEMU's side, as much as is used ---------------------------------------------------- */

typedef uint64_t qemu_plugin_id_t;
typedef struct qemu_info_t qemu_info_t;
struct qemu_plugin_tb;
struct qemu_plugin_insn;
typedef void tb_trans_cb(qemu_plugin_id_t, struct qemu_plugin_tb *);
typedef void tb_exec_cb(unsigned cpu, void *data);
typedef void exit_cb(qemu_plugin_id_t, void *data);
void qemu_plugin_register_vcpu_tb_trans_cb(qemu_plugin_id_t, tb_trans_cb *);
void qemu_plugin_register_vcpu_tb_exec_cb(struct qemu_plugin_tb *, tb_exec_cb *, int flags, void *);
void qemu_plugin_register_atexit_cb(qemu_plugin_id_t, exit_cb *, void *);
size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *);
struct qemu_plugin_insn *qemu_plugin_tb_get_insn(const struct qemu_plugin_tb *, size_t);
uint64_t qemu_plugin_insn_vaddr(const struct qemu_plugin_insn *);
const void *qemu_plugin_insn_data(const struct qemu_plugin_insn *);
const char *qemu_plugin_insn_symbol(const struct qemu_plugin_insn *);
EXPORT int qemu_plugin_version = 1;
EXPORT int qemu_plugin_install(qemu_plugin_id_t, const qemu_info_t *, int, char **);

/* ---- the model -------------------------------------------------------------------------- */

static bool is_conditional(uint16_t op)
{
    return op >> 12 == 0xD && (op >> 8 & 15) < 14;
}

/* From the first halfword. (QEMU 7.2 gives 4 for a short one at the end of a page, because it
 * looks ahead.) */
static unsigned size_of(uint16_t op)
{
    return op >> 11 >= 0x1D ? 4 : 2;
}

/* Cycles of a Thumb instruction, a conditional branch as not taken. */
static unsigned cycles_of(uint16_t op)
{
    const unsigned registers = (unsigned)__builtin_popcount(op & 0xFF);

    if (size_of(op) == 4) /* on ARMv6-M: bl, or msr mrs dmb dsb isb */
        return 3;
    if (op >> 11 == 0x09 || (op >> 12 >= 5 && op >> 12 <= 9)) /* literal, register, immediate, sp */
        return 2;
    if (op >> 12 == 0xC) /* stm, ldm */
        return 1 + registers;
    if (op >> 9 == 0x5A) /* push, with lr or without */
        return 1 + registers + (op >> 8 & 1);
    if (op >> 9 == 0x5E) /* pop; 3 + n with pc, which is one of the n */
        return op >> 8 & 1 ? 4 + registers : 1 + registers;
    if (op >> 11 == 0x1C) /* b */
        return 2;
    if (op >> 8 == 0x47) /* bx, blx */
        return 2;
    if ((op & 0xFD87) == 0x4487) /* add pc, mov pc */
        return 2;
    return 1;
}

/* ---- counting --------------------------------------------------------------------------- */

struct block {
    struct block *next;
    uint64_t count;
    uint64_t taken; /* of the last instruction, if it is a conditional branch */
    uint64_t end;   /* the address after the block */
    size_t length;
    int marker; /* +1 starts counting, -1 stops it */
    struct {
        uint32_t address;
        uint8_t cycles;
        bool conditional;
    } insn[];
};

static struct block *blocks, *last;
static bool counting;
static const char *out = "counts.txt";
static FILE *each; /* a line a count: the instructions from bench_counted to bench_done */
static uint64_t since;

static void run_block(unsigned cpu, void *data)
{
    struct block *b = data;

    (void)cpu;
    if (b->marker != 0) {
        if (each != NULL && counting && b->marker < 0)
            fprintf(each, "%llu\n", (unsigned long long)since);
        counting = b->marker > 0;
        since = 0;
    }
    if (counting) {
        b->count++;
        since += b->length;
        if (last != NULL && b->insn[0].address != last->end)
            last->taken++;
    }
    last = counting ? b : NULL;
}

/* A function is first met at its entry; only the entry of bench_counted starts the count, not
 * where a call returns into it. */
static int marker_of(const char *symbol, uint32_t address)
{
    static uint32_t entry;

    if (strcmp(symbol, "bench_done") == 0)
        return -1;
    if (strcmp(symbol, "bench_counted") != 0)
        return 0;
    if (entry == 0)
        entry = address;
    return address == entry;
}

static void translate(qemu_plugin_id_t id, struct qemu_plugin_tb *tb)
{
    const size_t n = qemu_plugin_tb_n_insns(tb);
    struct block *b = calloc(1, sizeof *b + n * sizeof b->insn[0]);

    (void)id;
    b->length = n;
    for (size_t i = 0; i < n; i++) {
        const struct qemu_plugin_insn *insn = qemu_plugin_tb_get_insn(tb, i);
        const char *symbol = qemu_plugin_insn_symbol(insn);
        uint16_t op;

        memcpy(&op, qemu_plugin_insn_data(insn), sizeof op);
        b->insn[i].address = (uint32_t)qemu_plugin_insn_vaddr(insn);
        b->insn[i].cycles = (uint8_t)cycles_of(op);
        b->insn[i].conditional = is_conditional(op);
        b->end = b->insn[i].address + size_of(op);
        if (i == 0 && symbol != NULL)
            b->marker = marker_of(symbol, b->insn[0].address);
    }
    b->next = blocks;
    blocks = b;
    qemu_plugin_register_vcpu_tb_exec_cb(tb, run_block, 0, b);
}

static void write_counts(qemu_plugin_id_t id, void *data)
{
    FILE *f = fopen(out, "w");

    (void)id;
    (void)data;
    if (each != NULL)
        fclose(each);
    if (f == NULL) {
        perror(out);
        exit(1);
    }
    for (const struct block *b = blocks; b != NULL; b = b->next)
        for (size_t i = 0; b->count != 0 && i < b->length; i++) {
            const uint64_t taken = i + 1 == b->length && b->insn[i].conditional ? b->taken : 0;
            fprintf(f, "%x %llu %llu %llu\n", b->insn[i].address, (unsigned long long)b->count,
                    (unsigned long long)taken,
                    (unsigned long long)(b->count * b->insn[i].cycles + taken));
        }
    fclose(f);
}

int qemu_plugin_install(qemu_plugin_id_t id, const qemu_info_t *info, int argc, char **argv)
{
    (void)info;
    for (int i = 0; i < argc; i++)
        if (strncmp(argv[i], "out=", 4) == 0)
            out = strdup(argv[i] + 4);
        else if (strncmp(argv[i], "each=", 5) == 0)
            each = fopen(argv[i] + 5, "w");
    qemu_plugin_register_vcpu_tb_trans_cb(id, translate);
    qemu_plugin_register_atexit_cb(id, write_counts, NULL);
    return 0;
}
