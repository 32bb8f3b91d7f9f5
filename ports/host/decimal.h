/* ports/host/decimal.h: decimal numbers, read and scaled with integers alone. */
#ifndef ETCH_HOST_DECIMAL_H
#define ETCH_HOST_DECIMAL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Bytes of a text; not terminated. */
struct etch_word {
    const char *text;
    size_t size;
};

#define ETCH_DECIMAL_DIGITS 40

/* +-0.dddd * 10^point, as it was written: rounding waits until the scale is known. */
struct etch_decimal {
    uint8_t digit[ETCH_DECIMAL_DIGITS]; /* digit[0 .. count-1], 0 .. 9 */
    uint8_t count;                      /* digits beyond the 40th significant one are dropped */
    bool negative;
    int32_t point; /* -200000 .. 200000 */
};

/* Reads [+-]digits[.digits][e[+-]digits], with a digit before or after the point. False if
 * the word is anything else. */
bool etch_decimal_read(struct etch_word word, struct etch_decimal *d);

/* d * 2^bits rounded to the nearest integer, half up (towards +infinity); bits -31 .. 31. Exact
 * for numbers of at most 36 digits after the point. False, and *value unchanged, if the result
 * is not within -2^31 .. 2^31 - 1. */
bool etch_decimal_scale(const struct etch_decimal *d, int bits, int32_t *value);

/* Reads an integer, [+-]digits. False if the word is anything else or leaves int64_t. */
bool etch_integer_read(struct etch_word word, int64_t *value);

#endif
