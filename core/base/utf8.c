/* base/utf8.c: the decoder. Called for each character of a text. See utf8.h. */
#include "utf8.h"

/* What may follow a first byte C2 .. F4: how many bytes, and which the second may be (RFC 3629):
 * the narrower ranges leave out overlong forms, surrogates and what is above U+10FFFF. */
struct tail {
    uint8_t count, least, most;
};

static struct tail tail_of(uint8_t lead)
{
    struct tail t = {1, 0x80, 0xBF};

    if (lead >= 0xF0)
        t.count = 3;
    else if (lead >= 0xE0)
        t.count = 2;
    if (lead == 0xE0)
        t.least = 0xA0;
    if (lead == 0xED)
        t.most = 0x9F;
    if (lead == 0xF0)
        t.least = 0x90;
    if (lead == 0xF4)
        t.most = 0x8F;
    return t;
}

uint32_t etch_utf8_next(const char **text, const char *end)
{
    const char *p = *text;
    const uint8_t lead = (uint8_t)*p++;

    *text = p;
    if (lead < 0x80)
        return lead;
    if (lead < 0xC2 || lead > 0xF4)
        return ETCH_UTF8_BAD;

    struct tail t = tail_of(lead);
    uint32_t code = lead & (0x3FU >> t.count);

    for (; t.count != 0; t.count--, *text = ++p) {
        const uint8_t byte = p == end ? 0 : (uint8_t)*p;

        if (byte < t.least || byte > t.most)
            return ETCH_UTF8_BAD;
        code = code << 6 | (byte & 0x3F);
        t.least = 0x80;
        t.most = 0xBF;
    }
    return code;
}
