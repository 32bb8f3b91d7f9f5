/* bench/leaves_guard.c: do the kernels with the leaf loops of this machine write what the portable
 * C does, and touch nothing else? All of the library is linked twice, the portable one under names
 * portable_*. Planes and runs stand against memory that may not be touched, before or behind, and
 * the arguments are seeded and hostile. Ends with status 0 if no element differs; a touch outside
 * ends it by a signal. See `make bench-leaves`. */
#define _GNU_SOURCE
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>

#include "bench.h"

#include "../../core/fragment/flat.h"
#include "../../core/fragment/gouraud.h"
#include "../../core/raster/edge.h"
#include "../../core/vertex/viewport.h"

#define GUARD 65536 /* bytes, a multiple of every page size */
#define LARGEST (64 * 1024)

#define KERNELS(X)                                                                                 \
    X(etch_kernel_flat)                                                                            \
    X(etch_kernel_flat_less)                                                                       \
    X(etch_kernel_flat_lequal)                                                                     \
    X(etch_kernel_gouraud)                                                                         \
    X(etch_kernel_gouraud_swapped)                                                                 \
    X(etch_kernel_gouraud_less)                                                                    \
    X(etch_kernel_gouraud_less_swapped)                                                            \
    X(etch_kernel_gouraud_lequal)                                                                  \
    X(etch_kernel_gouraud_lequal_swapped)

#define DECLARE(name) etch_kernel portable_##name;
KERNELS(DECLARE)

#define ROW(name) {#name, name, portable_##name},
static const struct {
    const char *name;
    etch_kernel *leaf, *portable;
} kernels[] = {KERNELS(ROW)};

static uint32_t seed = 1, projected;

static uint32_t below(uint32_t n)
{
    return wl_next(&seed) % n;
}

/* LARGEST bytes between two guards. */
static uint8_t *guarded(void)
{
    uint8_t *const p = mmap(NULL, LARGEST + 2 * GUARD, PROT_READ | PROT_WRITE,
                            MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);

    if (p == MAP_FAILED || mprotect(p, GUARD, PROT_NONE) != 0 ||
        mprotect(p + GUARD + LARGEST, GUARD, PROT_NONE) != 0)
        return NULL;
    return p + GUARD;
}

/* `bytes` of it, at its begin or at its end. */
static void *place(uint8_t *memory, size_t bytes)
{
    return below(2) == 0 ? memory : memory + LARGEST - bytes;
}

static struct etch_plane plane(bool gentle)
{
    const uint32_t steep = gentle ? 1 << 22 : UINT32_MAX;

    return (struct etch_plane){wl_next(&seed), below(steep), below(steep)};
}

/* Runs of up to `widest` pixels in the window, some empty, many up to its edges. */
static void make_runs(struct etch_run *runs, uint8_t n, struct etch_rect window, uint32_t widest)
{
    const uint32_t width = (uint32_t)(window.x1 - window.x0);

    for (uint8_t i = 0; i < n; i++) {
        const uint32_t length = below((widest < width ? widest : width) + 1);
        const uint32_t room = width - length, at = below(3);
        const uint32_t x = at == 0 ? 0 : at == 1 ? room : below(room + 1);

        runs[i].x0 = (int16_t)(window.x0 + (int16_t)x);
        runs[i].x1 = (int16_t)(runs[i].x0 + (int16_t)length);
    }
}

/* Whether kernel k draws one block of runs the portable way. */
static bool differs(size_t k, uint8_t *const memory[3], uint8_t *const copies[2])
{
    const uint8_t n = (uint8_t)(1 + below(ETCH_RUN_BLOCK));
    const int16_t width = (int16_t)(1 + below(below(2) == 0 ? 20 : 500));
    const int16_t x = (int16_t)below((uint32_t)(32767 - width)), y = (int16_t)below(32700);
    const struct etch_rect window = {x, y, (int16_t)(x + width), (int16_t)(y + n)};
    const uint16_t stride = (uint16_t)(width + (int16_t)below(3));
    const size_t bytes = ((size_t)stride * (n - 1U) + (size_t)width) * 2;
    struct etch_gouraud_paint paint = {
        {kernels[k].leaf}, plane(true), plane(false), plane(false), plane(below(2) == 0)};
    const struct etch_flat_depth_paint flat = {paint.paint, paint.z, (uint16_t)wl_next(&seed)};
    const struct etch_flat_paint plain = {paint.paint, flat.color};
    const struct etch_paint *const used = k == 0  ? &plain.paint
                                          : k < 3 ? &flat.paint
                                                  : &paint.paint;
    struct etch_run *const runs = place(memory[2], n * sizeof *runs);
    struct etch_surface s, t;

    if (etch_surface_init(&s, place(memory[0], bytes), window, stride) != ETCH_OK)
        return true;
    s.depth = place(memory[1], bytes);
    for (size_t i = 0; i < bytes / 2; i++) {
        const int16_t row = (int16_t)(y + (int16_t)(i / stride));
        const uint32_t z = etch_plane_at(&paint.z, (int16_t)(x + (int16_t)(i % stride)), row) >> 16;

        s.pixels[i] = (uint16_t)wl_next(&seed);
        s.depth[i] = (uint16_t)(z + below(8) - below(8));
    }
    t = s;
    t.pixels = (uint16_t *)(void *)copies[0];
    t.depth = (uint16_t *)(void *)copies[1];
    memcpy(t.pixels, s.pixels, bytes);
    memcpy(t.depth, s.depth, bytes);
    make_runs(runs, n, window, below(2) == 0 ? 12 : 500);
    kernels[k].leaf(&s, y, runs, n, used);
    kernels[k].portable(&t, y, runs, n, used);
    return memcmp(t.pixels, s.pixels, bytes) != 0 || memcmp(t.depth, s.depth, bytes) != 0;
}

void portable_etch_viewport_project(const struct etch_viewport *v,
                                    const struct etch_clip_vertex *in, struct etch_vertex *out);

/* One of either sign, of up to `bits` bits. */
static int32_t signed_of(uint32_t bits)
{
    const int32_t v = (int32_t)(wl_next(&seed) >> (32 - bits));

    return below(2) == 0 ? v : -v;
}

/* Vertices of every size on viewports of every size, near, far, beside and beyond their planes by a
 * little; many quotients are halves. */
static bool projection_differs(void)
{
    const uint32_t bits = 1 + below(31), beside = 1 + below(31), size = below(16);
    const int32_t width = 1 + (int32_t)below(1U << size), height = 1 + (int32_t)below(1U << size);
    const int16_t x = (int16_t)(signed_of(15) % (32767 - width)), y = (int16_t)below(64);
    const struct etch_rect rect = {x, y, (int16_t)(x + width),
                                   (int16_t)(height > 32000 ? 32000 : y + height)};
    const int32_t w = 1 + (signed_of(bits) & INT32_MAX);
    const struct etch_clip_vertex in = {.x = signed_of(beside),
                                        .y = signed_of(beside),
                                        .z = below(8) == 0 ? w : signed_of(bits),
                                        .w = w > 0 ? w : INT32_MAX,
                                        .r = 1,
                                        .g = 2,
                                        .b = 3,
                                        .a = 4};
    struct etch_viewport v;
    struct etch_vertex a, b;

    if (etch_viewport_init(&v, rect) != ETCH_OK ||
        (etch_viewport_outcode(&v, &in) & ETCH_OUT_CLIP) != 0)
        return false;
    projected++;
    etch_viewport_project(&v, &in, &a);
    portable_etch_viewport_project(&v, &in, &b);
    return a.x_q8 != b.x_q8 || a.y_q8 != b.y_q8 || a.z_q16 != b.z_q16 || a.r != b.r || a.g != b.g ||
           a.b != b.b || a.a != b.a;
}

int16_t *portable_etch_edge_run(struct etch_point_q8 a, struct etch_point_q8 b, int16_t *out,
                                int32_t n);

/* From (128 + 256 i, 128 - k) an edge crosses row K, counted from its first, (k + 256 K) dx / (256
 * dy) from a pixel's centre. Edges that do so in a centre or the least possible distance beside
 * one, 1 / (256 dy): in their first row, in every third by a slope that binary fractions miss, and
 * in any. */
static struct etch_point_q8 hostile_edge(int32_t *k)
{
    const uint32_t row = 1 + below(ETCH_RUN_BLOCK - 1), most = (1U << 22) / (1 + 256 * row);
    const int32_t q = (int32_t)below(most), third = 1 + (int32_t)below(1U << below(20));
    const int32_t dy = 1 + (int32_t)below(1U << below(22)), side = below(2) == 0 ? 1 : -1;

    *k = 1;
    switch (below(3)) {
    case 0: return (struct etch_point_q8){(int32_t)below(3) - 1, dy};
    case 1: *k = 0; return (struct etch_point_q8){side * third, 3 * third};
    default: /* (1 + 256 row) dx = 1 + 256 dy */
        return (struct etch_point_q8){side * (1 + 256 * q),
                                      q + (int32_t)row + 256 * (int32_t)row * q};
    }
}

static bool edge_differs(void)
{
    int16_t leaf[2 * ETCH_RUN_BLOCK] = {0}, portable[2 * ETCH_RUN_BLOCK] = {0};
    const int32_t n = 1 + (int32_t)below(ETCH_RUN_BLOCK);
    int32_t k;
    const struct etch_point_q8 d = hostile_edge(&k);
    const struct etch_point_q8 a = {128 + 256 * signed_of(10), 128 - k + 256 * signed_of(10)};
    const struct etch_point_q8 b = {a.x + d.x, a.y + d.y};

    return etch_edge_run(a, b, leaf, n) - leaf !=
               portable_etch_edge_run(a, b, portable, n) - portable ||
           memcmp(leaf, portable, sizeof leaf) != 0;
}

int main(void)
{
    static uint16_t copies[2][LARGEST / 2];
    uint8_t *const copy[2] = {(uint8_t *)copies[0], (uint8_t *)copies[1]};
    uint8_t *const memory[3] = {guarded(), guarded(), guarded()};
    const size_t count = sizeof kernels / sizeof kernels[0];
    const uint32_t calls = 1000;

    if (memory[0] == NULL || memory[1] == NULL || memory[2] == NULL)
        return 1;
    for (uint32_t i = 0; i < calls; i++)
        for (size_t k = 0; k < count; k++)
            if (differs(k, memory, copy)) {
                printf("%s: call %u differs\n", kernels[k].name, (unsigned)i);
                return 1;
            }
    for (uint32_t i = 0; i < 100 * calls; i++)
        if (projection_differs()) {
            printf("projection %u differs\n", (unsigned)i);
            return 1;
        }
    for (uint32_t i = 0; i < 100 * calls; i++)
        if (edge_differs()) {
            printf("edge %u differs\n", (unsigned)i);
            return 1;
        }
    if (projected < 10 * calls)
        return 1;
    printf(
        "%u guarded calls of %u kernels, %u projections and %u edges do what the portable C does\n",
        (unsigned)(calls * count), (unsigned)count, (unsigned)projected, (unsigned)(100 * calls));
    return 0;
}
