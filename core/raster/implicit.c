/* raster/implicit.c: implicit shapes to runs, by tiles. Called by applications. See implicit.h.
 *
 * The quarters of a tile are walked in Morton order, in which a block of s x s pixels is a
 * stretch of s s numbers: where to go on is a sum, and nothing is kept on a stack. */
#include "implicit.h"
#include "rect.h"

enum {
    TILE = 32,
    LEAF = 4
};

/* Bits 0, 2, 4, 6, 8 of a Morton number, moved together. */
static int16_t even_bits(uint16_t at)
{
    uint16_t bits = 0;

    for (uint8_t i = 0; i < 5; i++)
        bits = (uint16_t)(bits | (at >> i & (1U << i)));
    return (int16_t)bits;
}

/* Sets the bits of the pixels of `block` that are inside; bit x - tile.x0 of word y - tile.y0. */
static void ask_pixels(const struct etch_implicit *shape, struct etch_rect block,
                       struct etch_rect tile, uint32_t inside[TILE])
{
    for (int16_t y = block.y0; y < block.y1; y++)
        for (int16_t x = block.x0; x < block.x1; x++)
            if (shape->value(shape, x, y) < 0)
                inside[y - tile.y0] |= UINT32_C(1) << (x - tile.x0);
}

static void fill_block(struct etch_rect block, struct etch_rect tile, uint32_t inside[TILE])
{
    const uint32_t bits = ((UINT32_C(1) << (block.x1 - block.x0)) - 1) << (block.x0 - tile.x0);

    for (int16_t y = block.y0; y < block.y1; y++)
        inside[y - tile.y0] |= bits;
}

/* The pixels of a tile of which nothing is known; `size`, of blocks, is 16 at most. */
static void ask_tile(const struct etch_implicit *shape, struct etch_rect tile,
                     uint32_t inside[TILE])
{
    uint16_t size = TILE / 2;

    for (uint16_t at = 0; at < TILE * TILE;) {
        const int32_t x = tile.x0 + even_bits(at), y = tile.y0 + even_bits((uint16_t)(at >> 1));
        enum etch_implicit_side side = ETCH_IMPLICIT_OUTSIDE;

        if (x < tile.x1 && y < tile.y1) {
            const struct etch_rect block = {(int16_t)x, (int16_t)y,
                                            (int16_t)(tile.x1 - x < size ? tile.x1 : x + size),
                                            (int16_t)(tile.y1 - y < size ? tile.y1 : y + size)};

            side = size > LEAF ? shape->side(shape, block) : ETCH_IMPLICIT_UNKNOWN;
            if (side == ETCH_IMPLICIT_UNKNOWN && size > LEAF) {
                size /= 2;
                continue;
            }
            if (side == ETCH_IMPLICIT_UNKNOWN)
                ask_pixels(shape, block, tile, inside);
            else if (side == ETCH_IMPLICIT_INSIDE)
                fill_block(block, tile, inside);
        }
        at = (uint16_t)(at + size * size);
        while (size < TILE / 2 && (at & (4 * size * size - 1)) == 0)
            size *= 2;
    }
}

/* Takes the first run of set bits out of the word. Empty where there is none. */
static struct etch_run take_run(uint32_t *bits, int16_t x)
{
    struct etch_run run = {x, x};

    if (*bits == 0)
        return run;
    for (uint32_t b = *bits; (b & 1) == 0; b >>= 1)
        run.x0++;
    run.x1 = run.x0;
    for (uint32_t b = *bits >> (run.x0 - x); (b & 1) != 0; b >>= 1)
        run.x1++;
    *bits = run.x1 - x < TILE ? *bits & ~((UINT32_C(1) << (run.x1 - x)) - 1) : 0;
    return run;
}

/* The first runs of all rows, then the second ones, .. as run_band.h. */
static void draw_tile(const struct etch_surface *surface, const struct etch_implicit *shape,
                      struct etch_rect tile, const struct etch_paint *paint)
{
    struct etch_run run[ETCH_RUN_BLOCK];
    uint32_t inside[TILE];
    bool any;

    for (uint8_t i = 0; i < TILE; i++)
        inside[i] = 0;
    ask_tile(shape, tile, inside);
    do {
        any = false;
        for (uint8_t i = 0; i < tile.y1 - tile.y0; i++) {
            any |= inside[i] != 0;
            run[i] = take_run(&inside[i], tile.x0);
        }
        if (any)
            paint->kernel(surface, tile.y0, run, (uint8_t)(tile.y1 - tile.y0), paint);
    } while (any);
}

/* A row of tiles; those side by side that are inside are drawn as one. */
static void draw_row(const struct etch_surface *surface, const struct etch_implicit *shape,
                     struct etch_rect row, const struct etch_paint *paint)
{
    struct etch_rect tile = row, whole = row;

    for (; tile.x0 < row.x1; tile.x0 = tile.x1) {
        enum etch_implicit_side side;

        tile.x1 = (int16_t)(row.x1 - tile.x0 < TILE ? row.x1 : tile.x0 + TILE);
        side = shape->side(shape, tile);
        if (side == ETCH_IMPLICIT_INSIDE)
            continue;
        whole.x1 = tile.x0;
        etch_rect_runs(surface, whole, paint);
        whole.x0 = tile.x1;
        if (side == ETCH_IMPLICIT_UNKNOWN)
            draw_tile(surface, shape, tile, paint);
    }
    whole.x1 = row.x1;
    etch_rect_runs(surface, whole, paint);
}

void etch_implicit_runs(const struct etch_surface *surface, const struct etch_implicit *shape,
                        const struct etch_paint *paint)
{
    const struct etch_rect seen = etch_rect_intersect(shape->box, surface->clip);
    struct etch_rect row = seen;

    if (etch_rect_is_empty(seen))
        return;
    for (; row.y0 < seen.y1; row.y0 = row.y1) {
        row.y1 = (int16_t)(seen.y1 - row.y0 < TILE ? seen.y1 : row.y0 + TILE);
        draw_row(surface, shape, row, paint);
    }
}
