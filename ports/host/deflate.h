/* ports/host/deflate.h: a small deflate compressor for the PNG writer.
 *
 * One stream, fixed Huffman codes, matches found through a hash of three bytes with one
 * candidate each. Pictures drawn by etch are mostly runs and repeated rows, which this finds.
 * Formats: P. Deutsch, RFC 1950 (zlib) and RFC 1951 (deflate), 1996. */
#ifndef ETCH_HOST_DEFLATE_H
#define ETCH_HOST_DEFLATE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define ETCH_DEFLATE_WINDOW 32768
#define ETCH_DEFLATE_HASH 16384

/* About 230 KB: allocate it. */
struct etch_deflate {
    void (*write)(void *context, uint8_t byte); /* takes the compressed bytes */
    void *context;

    /* Private. */
    uint8_t text[4 * ETCH_DEFLATE_WINDOW]; /* the window behind `at`, then what is to come */
    uint32_t used, at;                     /* bytes in text, bytes compressed of it */
    uint32_t last[ETCH_DEFLATE_HASH];      /* place + 1 in text of the newest match, or 0 */
    uint32_t bits, n_bits;                 /* not yet written, lowest first */
    uint32_t sum_a, sum_b;                 /* Adler-32 */
};

/* Begins a zlib stream. */
void etch_deflate_begin(struct etch_deflate *d, void (*write)(void *, uint8_t), void *context);

/* Compresses `size` more bytes; they are copied. */
void etch_deflate_bytes(struct etch_deflate *d, const uint8_t *bytes, size_t size);

/* Ends the stream. */
void etch_deflate_end(struct etch_deflate *d);

#endif
