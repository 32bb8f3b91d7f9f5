/* tests/tools: decompression of zlib streams. Called by png_read.c. See png_read.h. */
#include <stdbool.h>

#include "png_read.h"

struct stream {
    const uint8_t *in;
    size_t n, at; /* bytes */
    uint32_t bits, held;
    uint8_t *out;
    size_t size, filled;
    bool broken;
};

static uint32_t take(struct stream *s, uint32_t count)
{
    uint32_t value;

    while (s->held < count) {
        if (s->at == s->n) {
            s->broken = true;
            return 0;
        }
        s->bits |= (uint32_t)s->in[s->at++] << s->held;
        s->held += 8;
    }
    value = s->bits & ((UINT32_C(1) << count) - 1);
    s->bits >>= count;
    s->held -= count;
    return value;
}

static void put(struct stream *s, uint8_t byte)
{
    if (s->filled == s->size)
        s->broken = true;
    else
        s->out[s->filled++] = byte;
}

/* A canonical Huffman code: how many codes of each length, and the symbols in code order. */
struct code {
    uint16_t count[16], symbol[288];
};

static void code_make(struct code *c, const uint8_t *length, uint32_t n)
{
    uint16_t next[16] = {0};
    uint32_t i;

    for (i = 0; i < 16; i++)
        c->count[i] = 0;
    for (i = 0; i < n; i++)
        c->count[length[i]]++;
    c->count[0] = 0;
    for (i = 1; i < 15; i++)
        next[i + 1] = (uint16_t)(next[i] + c->count[i]);
    for (i = 0; i < n; i++)
        if (length[i] != 0)
            c->symbol[next[length[i]]++] = (uint16_t)i;
}

static uint32_t decode(struct stream *s, const struct code *c)
{
    uint32_t code = 0, first = 0, index = 0, length;

    for (length = 1; length < 16 && !s->broken; length++) {
        code |= take(s, 1);
        if (code < first + c->count[length])
            return c->symbol[index + code - first];
        index += c->count[length];
        first = (first + c->count[length]) << 1;
        code <<= 1;
    }
    s->broken = true;
    return 0;
}

/* Length symbols 257 .. 285 and distance symbols 0 .. 29: the first value and its extra bits. */
static uint32_t length_of(struct stream *s, uint32_t symbol)
{
    const uint32_t k = symbol - 257, extra = k < 8 ? 0 : k / 4 - 1;

    if (symbol == 285)
        return 258;
    return (k < 8 ? k : (4 + k % 4) << extra) + 3 + take(s, extra);
}

static uint32_t distance_of(struct stream *s, uint32_t symbol)
{
    const uint32_t extra = symbol < 4 ? 0 : symbol / 2 - 1;

    return (symbol < 4 ? symbol : (2 + symbol % 2) << extra) + 1 + take(s, extra);
}

static void copy(struct stream *s, uint32_t length, uint32_t distance)
{
    if (distance > s->filled)
        s->broken = true;
    for (; length != 0 && !s->broken; length--)
        put(s, s->out[s->filled - distance]);
}

static void compressed_block(struct stream *s, const struct code *lengths,
                             const struct code *distances)
{
    while (!s->broken) {
        const uint32_t symbol = decode(s, lengths);

        if (symbol == 256)
            return;
        if (symbol < 256) {
            put(s, (uint8_t)symbol);
        } else {
            const uint32_t length = length_of(s, symbol);

            copy(s, length, distance_of(s, decode(s, distances)));
        }
    }
}

static void fixed_block(struct stream *s)
{
    struct code lengths, distances;
    uint8_t n[288];
    uint32_t i;

    for (i = 0; i < 288; i++)
        n[i] = i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8;
    code_make(&lengths, n, 288);
    for (i = 0; i < 30; i++)
        n[i] = 5;
    code_make(&distances, n, 30);
    compressed_block(s, &lengths, &distances);
}

static void dynamic_block(struct stream *s)
{
    static const uint8_t order[19] = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                      11, 4,  12, 3, 13, 2, 14, 1, 15};
    const uint32_t literals = take(s, 5) + 257, distance_codes = take(s, 5) + 1;
    const uint32_t n_order = take(s, 4) + 4;
    uint8_t n[320] = {0};
    struct code lengths, distances;
    uint32_t i;

    for (i = 0; i < n_order; i++)
        n[order[i]] = (uint8_t)take(s, 3);
    code_make(&lengths, n, 19);
    for (i = 0; i < literals + distance_codes && !s->broken;) {
        const uint32_t symbol = decode(s, &lengths);
        const uint8_t value = symbol < 16 ? (uint8_t)symbol : symbol == 16 && i > 0 ? n[i - 1] : 0;
        uint32_t times = symbol < 16    ? 1
                         : symbol == 16 ? 3 + take(s, 2)
                         : symbol == 17 ? 3 + take(s, 3)
                                        : 11 + take(s, 7);

        for (; times != 0 && i < literals + distance_codes; times--)
            n[i++] = value;
    }
    if (literals > 288 || s->broken) {
        s->broken = true;
        return;
    }
    code_make(&lengths, n, literals);
    code_make(&distances, n + literals, distance_codes);
    compressed_block(s, &lengths, &distances);
}

static void stored_block(struct stream *s)
{
    uint32_t length;

    take(s, s->held % 8);
    length = take(s, 16);
    if (length != (take(s, 16) ^ 0xFFFF))
        s->broken = true;
    for (; length != 0 && !s->broken; length--)
        put(s, (uint8_t)take(s, 8));
}

static uint32_t adler32(const uint8_t *p, size_t n)
{
    uint32_t a = 1, b = 0;

    for (; n != 0; n--) {
        a = (a + *p++) % 65521;
        b = (b + a) % 65521;
    }
    return b << 16 | a;
}

const char *inflate(uint8_t *out, size_t size, const uint8_t *in, size_t n)
{
    struct stream s = {in, n, 2, 0, 0, out, size, 0, false};
    uint32_t last, i, sum = 0;

    if (n < 6 || (in[0] & 15) != 8 || (in[0] * 256 + in[1]) % 31 != 0)
        return "no zlib header";
    do {
        last = take(&s, 1);
        switch (take(&s, 2)) {
        case 0: stored_block(&s); break;
        case 1: fixed_block(&s); break;
        case 2: dynamic_block(&s); break;
        default: s.broken = true; break;
        }
    } while (!last && !s.broken);
    take(&s, s.held % 8);
    for (i = 0; i < 4; i++)
        sum = sum << 8 | take(&s, 8);
    if (s.broken || s.filled != size)
        return "broken zlib stream";
    return sum == adler32(out, size) ? NULL : "wrong zlib checksum";
}
