/* ports/host/decimal.c: decimal text to fixed point. The scene and OBJ readers call it. Digits
 * are kept as they stand until the scale is known, so that each number is rounded once. */
#include "decimal.h"

#define MAX_POINT 100000
#define LIMB UINT64_C(1000000000000000000) /* 10^18 */

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static void drop_first(struct etch_word *word)
{
    word->text++;
    word->size--;
}

bool etch_integer_read(struct etch_word word, int64_t *value)
{
    const bool negative = word.size != 0 && word.text[0] == '-';
    uint64_t magnitude = 0;

    if (word.size != 0 && (negative || word.text[0] == '+')) {
        drop_first(&word);
    }
    if (word.size == 0) {
        return false;
    }
    for (; word.size != 0; drop_first(&word)) {
        if (!is_digit(word.text[0]) || magnitude > (uint64_t)INT64_MAX / 10 - 1) {
            return false;
        }
        magnitude = magnitude * 10 + (uint64_t)(word.text[0] - '0');
    }
    *value = negative ? -(int64_t)magnitude : (int64_t)magnitude;
    return true;
}

/* Takes digits before (fraction 0) or after (1) the point. True if there was one. Leading
 * zeros are not kept, they only move the point. */
static bool take_digits(struct etch_word *word, struct etch_decimal *d, bool fraction)
{
    const size_t size = word->size;

    for (; word->size != 0 && is_digit(word->text[0]); drop_first(word)) {
        const bool leading = d->count == 0 && word->text[0] == '0';

        if (!leading && d->count < ETCH_DECIMAL_DIGITS) {
            d->digit[d->count++] = (uint8_t)(word->text[0] - '0');
        }
        if (!leading && !fraction && d->point < MAX_POINT) {
            d->point++;
        } else if (leading && fraction && d->point > -MAX_POINT) {
            d->point--;
        }
    }
    return word->size != size;
}

/* Takes a sign and digits, which must be all that is left. */
static bool take_exponent(struct etch_word *word, struct etch_decimal *d)
{
    const bool negative = word->size != 0 && word->text[0] == '-';
    int32_t exponent = 0;

    if (word->size != 0 && (negative || word->text[0] == '+')) {
        drop_first(word);
    }
    if (word->size == 0) {
        return false;
    }
    for (; word->size != 0; drop_first(word)) {
        if (!is_digit(word->text[0])) {
            return false;
        }
        if (exponent < MAX_POINT / 10) {
            exponent = exponent * 10 + (word->text[0] - '0');
        }
    }
    d->point += negative ? -exponent : exponent;
    return true;
}

bool etch_decimal_read(struct etch_word word, struct etch_decimal *d)
{
    bool any;

    *d = (struct etch_decimal){.negative = word.size != 0 && word.text[0] == '-'};
    if (word.size != 0 && (d->negative || word.text[0] == '+')) {
        drop_first(&word);
    }
    any = take_digits(&word, d, false);
    if (word.size != 0 && word.text[0] == '.') {
        drop_first(&word);
        any |= take_digits(&word, d, true);
    }
    if (any && word.size != 0 && (word.text[0] == 'e' || word.text[0] == 'E')) {
        drop_first(&word);
        return take_exponent(&word, d);
    }
    return any && word.size == 0;
}

/* whole + (high + low / 10^18) / 10^18, plus a rest below 10^-36 if `more`. */
struct mixed {
    uint64_t whole, high, low;
    bool more;
};

/* The digit of weight 10^-(place + 1), 0 beyond the first and last. */
static uint8_t digit_at(const struct etch_decimal *d, int32_t place)
{
    const int32_t i = place + d->point;
    return i >= 0 && i < d->count ? d->digit[i] : 0;
}

/* False if the integer has more than 18 digits. */
static bool split(const struct etch_decimal *d, struct mixed *m)
{
    *m = (struct mixed){0, 0, 0, (int32_t)d->count - d->point > 36};
    if (d->count == 0) {
        return true;
    }
    if (d->point > 18) {
        return false;
    }
    for (int32_t i = -18; i < 0; i++) {
        m->whole = m->whole * 10 + digit_at(d, i);
    }
    for (int32_t i = 0; i < 18; i++) {
        m->high = m->high * 10 + digit_at(d, i);
        m->low = m->low * 10 + digit_at(d, i + 18);
    }
    return true;
}

/* Doubles the number; false if its integer reaches 2^62. Both parts stay below 10^18 < 2^60. */
static bool twice(struct mixed *m)
{
    const uint64_t low = m->low * 2, high = m->high * 2 + (low >= LIMB);

    m->low = low >= LIMB ? low - LIMB : low;
    m->high = high >= LIMB ? high - LIMB : high;
    m->whole = m->whole * 2 + (high >= LIMB);
    return m->whole < UINT64_C(1) << 62;
}

/* Halves it. Of the fraction only "0, 1/2, and more than that or not" stays right. */
static void half(struct mixed *m)
{
    m->more |= m->high != 0 || m->low != 0;
    m->high = (m->whole & 1) * (LIMB / 2);
    m->low = 0;
    m->whole >>= 1;
}

bool etch_decimal_scale(const struct etch_decimal *d, int bits, int32_t *value)
{
    struct mixed m;

    if (!split(d, &m)) {
        return false;
    }
    for (; bits > 0; bits--) {
        if (!twice(&m)) {
            return false;
        }
    }
    for (; bits < 0; bits++) {
        half(&m);
    }
    if (m.high >= LIMB / 2 && (!d->negative || m.high != LIMB / 2 || m.low != 0 || m.more)) {
        m.whole++; /* half up: -1/2 itself goes to 0 */
    }
    if (m.whole > (uint64_t)INT32_MAX + d->negative) {
        return false;
    }
    *value = (int32_t)(d->negative ? -(int64_t)m.whole : (int64_t)m.whole);
    return true;
}
