/* ports/host/deflate.c: bytes to a zlib stream. The PNG writer calls it. */
#include "deflate.h"

#include <string.h>

#define MIN_MATCH 3
#define MAX_MATCH 258
#define ADLER 65521

/* Writes n bits, lowest first; n <= 16. */
static void put_bits(struct etch_deflate *d, uint32_t value, uint32_t n)
{
    d->bits |= value << d->n_bits; /* n_bits <= 7 here */
    for (d->n_bits += n; d->n_bits >= 8; d->n_bits -= 8) {
        d->write(d->context, (uint8_t)(d->bits & 0xFF));
        d->bits >>= 8;
    }
}

/* Writes a Huffman code, which goes highest bit first. */
static void put_code(struct etch_deflate *d, uint32_t code, uint32_t n)
{
    uint32_t reversed = 0;

    for (uint32_t i = 0; i < n; i++) {
        reversed |= (code >> i & 1) << (n - 1 - i);
    }
    put_bits(d, reversed, n);
}

/* A literal byte, 256 for the end, or 257 .. 285 for a length (RFC 1951, 3.2.6). */
static void put_symbol(struct etch_deflate *d, uint32_t symbol)
{
    if (symbol < 144) {
        put_code(d, 0x30 + symbol, 8);
    } else if (symbol < 256) {
        put_code(d, 0x190 + symbol - 144, 9);
    } else if (symbol < 280) {
        put_code(d, symbol - 256, 7);
    } else {
        put_code(d, 0xC0 + symbol - 280, 8);
    }
}

/* A value coded as bucket and extra bits: buckets double in size every `per` of them (4 for
 * lengths, 2 for distances), after `2 * per` of size one. Returns the bucket. */
static uint32_t bucket_of(uint32_t value, uint32_t per, uint32_t *extra, uint32_t *n_extra)
{
    uint32_t bucket = 0, size = 1, base = 0;

    *n_extra = 0;
    while (value - base >= size) {
        base += size;
        bucket++;
        if (bucket >= 2 * per && bucket % per == 0) {
            size *= 2;
            ++*n_extra;
        }
    }
    *extra = value - base;
    return bucket;
}

static void put_match(struct etch_deflate *d, uint32_t length, uint32_t distance)
{
    uint32_t extra, n_extra, bucket;

    if (length == MAX_MATCH) {
        put_symbol(d, 285); /* a bucket of its own */
    } else {
        bucket = bucket_of(length - MIN_MATCH, 4, &extra, &n_extra);
        put_symbol(d, 257 + bucket);
        put_bits(d, extra, n_extra);
    }
    bucket = bucket_of(distance - 1, 2, &extra, &n_extra);
    put_code(d, bucket, 5);
    put_bits(d, extra, n_extra);
}

static uint32_t hash_of(const uint8_t *p)
{
    const uint32_t key = (uint32_t)p[0] << 16 | (uint32_t)p[1] << 8 | p[2];
    return (uint32_t)((uint64_t)key * 2654435761U >> 18) % ETCH_DEFLATE_HASH;
}

/* Remembers the three bytes at `at`; returns the place before that had them too, + 1, or 0. */
static uint32_t remember(struct etch_deflate *d, uint32_t at)
{
    uint32_t *slot = &d->last[hash_of(d->text + at)];
    const uint32_t before = *slot;

    *slot = at + 1;
    return before;
}

/* Codes what starts at d->at: a match or one byte. Looks at bytes before `end` only. */
static void code_one(struct etch_deflate *d, uint32_t end)
{
    const uint32_t at = d->at;
    const uint32_t most = end - at < MAX_MATCH ? end - at : MAX_MATCH;
    const uint32_t before = most >= MIN_MATCH ? remember(d, at) : 0;
    uint32_t length = 0;

    if (before != 0 && at - (before - 1) <= ETCH_DEFLATE_WINDOW) {
        while (length < most && d->text[before - 1 + length] == d->text[at + length]) {
            length++;
        }
    }
    if (length < MIN_MATCH) {
        put_symbol(d, d->text[at]);
        d->at++;
        return;
    }
    put_match(d, length, at - (before - 1));
    for (d->at++; d->at < at + length; d->at++) {
        if (end - d->at >= MIN_MATCH) {
            (void)remember(d, d->at);
        }
    }
}

/* Moves the last window to the front, to make room behind it. */
static void slide(struct etch_deflate *d)
{
    const uint32_t shift = d->at - ETCH_DEFLATE_WINDOW;

    memmove(d->text, d->text + shift, d->used - shift);
    d->used -= shift;
    d->at -= shift;
    for (uint32_t i = 0; i < ETCH_DEFLATE_HASH; i++) {
        d->last[i] = d->last[i] > shift ? d->last[i] - shift : 0;
    }
}

void etch_deflate_begin(struct etch_deflate *d, void (*write)(void *, uint8_t), void *context)
{
    memset(d, 0, sizeof *d);
    d->write = write;
    d->context = context;
    d->sum_a = 1;
    d->write(context, 0x78); /* deflate, 32 KB window */
    d->write(context, 0x01); /* fastest; makes 0x7801 a multiple of 31 */
    put_bits(d, 1, 1);       /* the last block .. */
    put_bits(d, 1, 2);       /* .. has fixed codes */
}

void etch_deflate_bytes(struct etch_deflate *d, const uint8_t *bytes, size_t size)
{
    for (size_t i = 0; i < size; i++) {
        d->sum_a = (d->sum_a + bytes[i]) % ADLER;
        d->sum_b = (d->sum_b + d->sum_a) % ADLER;
        d->text[d->used++] = bytes[i];
        if (d->used == sizeof d->text) {
            while (d->used - d->at > MAX_MATCH) {
                code_one(d, d->used);
            }
            slide(d);
        }
    }
}

void etch_deflate_end(struct etch_deflate *d)
{
    while (d->at < d->used) {
        code_one(d, d->used);
    }
    put_symbol(d, 256);
    put_bits(d, 0, 7); /* to a whole byte */
    for (uint32_t i = 0; i < 4; i++) {
        const uint32_t half = i < 2 ? d->sum_b : d->sum_a;
        d->write(d->context, (uint8_t)(half >> (i % 2 ? 0 : 8) & 0xFF));
    }
}
