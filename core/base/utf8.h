/* base/utf8.h: code points from UTF-8 (RFC 3629; errors as Unicode 15, section 3.9, recommends). */
#ifndef ETCH_BASE_UTF8_H
#define ETCH_BASE_UTF8_H

#include "fixed.h"

#define ETCH_UTF8_BAD UINT32_C(0xFFFD)

/* True at `end`, or at a NUL where end is NULL. A NUL before `end` ends a text too. */
ETCH_INLINE bool etch_utf8_ended(const char *text, const char *end)
{
    return text == end || *text == '\0';
}

/* Takes one code point from *text, which has not ended, and moves *text behind it. Bytes that are
 * no UTF-8 (stray or cut sequences, overlong forms, surrogates, above U+10FFFF) give ETCH_UTF8_BAD,
 * one for each longest part that could have begun a sequence; so every byte is taken, none twice,
 * and nothing behind the end is read. */
uint32_t etch_utf8_next(const char **text, const char *end);

#endif
