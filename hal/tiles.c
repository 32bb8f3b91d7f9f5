/* hal/tiles.c: skips tiles that did not change. The frame loop calls it as a display; it calls the
 * display behind it. See tiles.h. */
#include "tiles.h"

/* Hash 0 stands for a tile of which nothing is known. */
#define UNKNOWN 0U

/* One pixel more: a bijection of the state for each pixel, so tiles that differ in one pixel
 * have different hashes (but that 0 becomes 1). Source: the multiply and the fold of FNV-1a (G.
 * Fowler, L. Noll, K.-P. Vo, 1991) with the multiplier of D. Knuth's multiplicative hashing, 2^32 /
 * golden ratio, which unlike FNV's prime carries every input bit into the upper half at once. */
static uint32_t mix(uint32_t hash, uint16_t pixel)
{
    hash = etch_wrap_mul(hash ^ pixel, UINT32_C(2654435769));
    return hash ^ hash >> 15;
}

static uint32_t hash_tile(const uint16_t *pixels, uint16_t stride, int16_t width, int16_t rows)
{
    uint32_t hash = UINT32_C(0x9E3779B9);

    for (; rows > 0; rows--, pixels += stride) {
        for (int16_t x = 0; x < width; x++) {
            hash = mix(hash, pixels[x]);
        }
    }
    return hash != UNKNOWN ? hash : 1;
}

static bool is_due(const struct etch_tiles *t, uint16_t tile)
{
    return t->setup.refresh != 0 && tile % t->setup.refresh == t->turn;
}

/* The columns of tile i of a strip. */
static struct etch_rect tile_area(const struct etch_tiles *t, struct etch_rect strip, uint16_t i)
{
    const int32_t x0 = (int32_t)i * t->setup.tile_width, x1 = x0 + t->setup.tile_width;
    struct etch_rect area = strip;

    area.x0 = (int16_t)x0;
    area.x1 = x1 < strip.x1 ? (int16_t)x1 : strip.x1;
    return area;
}

/* True if tile i of the strip must be sent; its hash is then the new one. */
static bool changed(struct etch_tiles *t, struct etch_rect strip, uint16_t i,
                    const uint16_t *pixels, uint16_t stride)
{
    const struct etch_rect area = tile_area(t, strip, i);
    const uint16_t tile = (uint16_t)(t->first + i);
    const uint32_t hash = hash_tile(pixels + area.x0, stride, (int16_t)(area.x1 - area.x0),
                                    (int16_t)(area.y1 - area.y0));
    const bool same = hash == t->setup.hash[tile] && !is_due(t, tile);

    t->setup.hash[tile] = hash;
    t->sent = etch_wrap_add(t->sent, !same);
    t->skipped = etch_wrap_add(t->skipped, same);
    return !same;
}

static int settle(struct etch_tiles *t)
{
    const bool sending = t->sending;

    t->sending = false;
    return sending ? t->inner->wait(t->inner) : ETCH_OK;
}

static void forget_strip(struct etch_tiles *t)
{
    for (uint16_t i = 0; i < t->across; i++) {
        t->setup.hash[t->first + i] = UNKNOWN;
    }
}

/* Sends the columns of tiles from .. to - 1. */
static int send_run(struct etch_tiles *t, struct etch_rect strip, uint16_t from, uint16_t to,
                    const uint16_t *pixels, uint16_t stride)
{
    struct etch_rect area = tile_area(t, strip, from);
    int status = settle(t);

    area.x1 = tile_area(t, strip, (uint16_t)(to - 1)).x1;
    if (status >= 0) {
        status = t->inner->flush(t->inner, area, pixels + area.x0, stride);
        t->sending = status >= 0;
    }
    return status;
}

static int flush(const struct etch_display *display, struct etch_rect area, const uint16_t *pixels,
                 uint16_t stride)
{
    struct etch_tiles *t = display->context;
    const int16_t rows = t->setup.tile_rows;
    uint16_t from = 0;
    int status = ETCH_OK;

    if (area.x0 != 0 || area.x1 != display->width || area.y0 % rows != 0 ||
        area.y1 - area.y0 > rows) {
        return ETCH_EINVAL;
    }
    if (area.y0 == 0 && t->setup.refresh != 0) {
        t->turn = (uint16_t)((t->turn + 1) % t->setup.refresh);
    }
    t->first = (uint16_t)etch_mul_u16((uint16_t)(area.y0 / rows), t->across);
    for (uint16_t i = 0; i < t->across && status >= 0; i++) {
        if (!changed(t, area, i, pixels, stride)) {
            status = from < i ? send_run(t, area, from, i, pixels, stride) : status;
            from = (uint16_t)(i + 1);
        }
    }
    if (status >= 0 && from < t->across) {
        status = send_run(t, area, from, t->across, pixels, stride);
    }
    if (status < 0) {
        forget_strip(t);
    }
    return status;
}

static int wait(const struct etch_display *display)
{
    struct etch_tiles *t = display->context;
    const int status = settle(t);

    if (status < 0) {
        forget_strip(t);
    }
    return status;
}

static int sync(const struct etch_display *display)
{
    const struct etch_tiles *t = display->context;

    return t->inner->sync(t->inner);
}

void etch_tiles_forget(struct etch_tiles *tiles)
{
    for (uint16_t i = 0; i < tiles->setup.count; i++) {
        tiles->setup.hash[i] = UNKNOWN;
    }
}

int etch_tiles_init(struct etch_tiles *t, const struct etch_display *inner,
                    struct etch_tiles_setup setup)
{
    const int32_t w = setup.tile_width, h = setup.tile_rows;
    uint32_t across, down;

    ETCH_ASSERT(t != NULL && inner != NULL && setup.hash != NULL);
    if (inner->memory != NULL || w < 1 || h < 1 ||
        (inner->align_x > 1 && w % inner->align_x != 0)) {
        return ETCH_EINVAL;
    }
    across = (uint32_t)((inner->width + w - 1) / w);
    down = (uint32_t)((inner->height + h - 1) / h);
    if (across * down > setup.count) {
        return ETCH_ENOMEM;
    }
    *t = (struct etch_tiles){.inner = inner, .setup = setup, .across = (uint16_t)across};
    t->display = *inner;
    t->display.context = t;
    t->display.flush = flush;
    t->display.wait = wait;
    t->display.sync = inner->sync != NULL ? sync : NULL;
    t->display.in_order = true; /* the turn of `refresh` begins with row 0 */
    etch_tiles_forget(t);
    return ETCH_OK;
}
