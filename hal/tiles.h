/* hal/tiles.h: sends only the tiles whose pixels changed, for scenes that are drawn anew every
 * frame. A display in front of another:
 *
 *      static uint32_t hash[40 * 15];
 *      static struct etch_tiles tiles;
 *      etch_tiles_init(&tiles, &lcd.display, (struct etch_tiles_setup){hash, 600, 8, 16, 64});
 *      etch_frame_init(&frame, &tiles.display, memory);
 *
 * It keeps a 32-bit hash of each tile that the panel shows, no pixels: a tile is tile_width
 * pixels of a strip, and each strip must be cut where it was in the last frame; so draw whole
 * frames, always in strips of tile_rows rows. Neighbouring tiles that changed go as one area.
 *
 * A change is missed if the hash stays the same: one changed tile in 2^32, for changes that were
 * not made with the hash in mind; at 60 frames a second with 100 changed tiles each, one in eight
 * days on average. What was missed is healed by `refresh`: in each frame the tiles of one in
 * `refresh` are sent in any case, by turns, so that each is, once in `refresh` frames (a missed
 * one is on the glass for half of that on average: half a second at 64).
 *
 * After an error the tiles of the strip count as unknown and are sent in the next frame.
 */
#ifndef ETCH_HAL_TILES_H
#define ETCH_HAL_TILES_H

#include "display.h"

struct etch_tiles_setup {
    uint32_t *hash;     /* the caller's, in use as long as the display */
    uint16_t count;     /* elements: tiles across x strips, both rounded up */
    int16_t tile_width; /* 1 .. 32767, a multiple of the display's align_x */
    int16_t tile_rows;  /* the strip's */
    uint16_t refresh;   /* frames; 0: never without need */
};

/* Set up by etch_tiles_init; then `display` is for the frame loop, the counts may be read, and
 * the rest is private. Must stay where it is. */
struct etch_tiles {
    struct etch_display display;
    const struct etch_display *inner;
    struct etch_tiles_setup setup;
    uint16_t across, turn; /* tiles in a strip; 0 .. refresh - 1 */
    uint16_t first;        /* tile of the strip that is sent */
    bool sending;
    uint32_t sent, skipped; /* tiles, modulo 2^32 */
};

/* Puts `tiles` before `inner`, a flushed display, which must stay valid; all tiles are unknown.
 * ETCH_EINVAL: a direct display, or a tile's size; ETCH_ENOMEM: too few elements. */
int etch_tiles_init(struct etch_tiles *tiles, const struct etch_display *inner,
                    struct etch_tiles_setup setup);

/* Forgets what the panel shows: the next frame is sent whole. */
void etch_tiles_forget(struct etch_tiles *tiles);

#endif
