/* tests/cli: decimal numbers. */
#include "ports/host/decimal.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "tests/harness/harness.h"

void suite_decimal(void);

static struct etch_word word(const char *text)
{
    const struct etch_word w = {text, strlen(text)};
    return w;
}

/* `text` * 2^bits rounds to `expected`. */
static void scales(const char *text, int bits, int32_t expected)
{
    struct etch_decimal d;
    int32_t value = 12345;

    CHECK(etch_decimal_read(word(text), &d));
    CHECK(etch_decimal_scale(&d, bits, &value));
    CHECK_EQ(value, expected);
}

static void refuses(const char *text, int bits)
{
    struct etch_decimal d;
    int32_t value = 12345;

    CHECK(etch_decimal_read(word(text), &d));
    CHECK(!etch_decimal_scale(&d, bits, &value));
    CHECK_EQ(value, 12345);
}

static void numbers_are_rounded_once(void)
{
    scales("0", 16, 0);
    scales("1", 16, 65536);
    scales("-1", 16, -65536);
    scales("+.5", 1, 1);
    scales("5.", 0, 5);
    scales("00012.50", 0, 13); /* a tie goes up .. */
    scales("-12.5", 0, -12);   /* .. on both sides of zero */
    scales("-12.500000000000000000000000000000000001", 0, -13);
    scales("12.499999999999999999999999999999999999", 0, 12);
    scales("0.00000762939453125", 16, 1); /* exactly 2^-17 */
    scales("0.000007629394531249999999", 16, 0);
    scales("-0.00000762939453125", 16, 0);
    scales("32767.99999237060546874", 16, INT32_MAX);
    refuses("32767.99999237060546875", 16);
    scales("-32768.00000762939453125", 16, INT32_MIN);
    refuses("-32768.00000762939453126", 16);
    scales("1e-1", 31, 214748365);
    scales("2147483647", 0, INT32_MAX);
    refuses("2147483648", 0);
    scales("1.5e3", 0, 1500);
    scales("1500e-3", 1, 3);
}

static void large_and_small_ones_too(void)
{
    scales("1e-99999999999999999999", 31, 0);
    scales("0e99999999999999999999", 31, 0);
    scales("0.000e5", 31, 0);
    refuses("1e99999999999999999999", -31);
    refuses("1e19", -31);
    scales("10", -1, 5);
    scales("11", -1, 6);
    scales("-11", -1, -5);
    scales("-11.0000000001", -1, -6);
    scales("6", -2, 2);
    scales("5.9999", -2, 1);
    scales("3221225472", -31, 2); /* 1.5 * 2^31 */
    scales("-3221225472", -31, -1);
    scales("100000000000000000000000000000000000000000000e-44", 4, 16);
    scales("0.00000000000000000000000000000000000000000001e44", 4, 16);
}

static void other_words_are_none(void)
{
    static const char *const wrong[] = {"",   "-",   ".",     "+.",  "e5",  "1e",  "1e+", "1e5.",
                                        "1 ", "0x1", "1.2.3", "--1", "inf", "nan", "1f",  "1,5"};
    struct etch_decimal d;
    int64_t value;

    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++)
        CHECK(!etch_decimal_read(word(wrong[i]), &d));
    CHECK(etch_integer_read(word("-0012"), &value) && value == -12);
    CHECK(etch_integer_read(word("+7"), &value) && value == 7);
    CHECK(!etch_integer_read(word("1.0"), &value) && !etch_integer_read(word("-"), &value));
    CHECK(!etch_integer_read(word("9223372036854775808"), &value));
    CHECK(!etch_integer_read(word(""), &value));
}

/* Every 1/65536 written out in full, moved by a hair under and over half a unit. */
static void against_the_integers(void)
{
    uint32_t state = 7;

    for (int i = 0; i < 100000 / TEST_DIVISOR && !test_failed(); i++) {
        const int32_t whole = test_range(&state, 0, 32766);
        const uint32_t part = test_random(&state) & 0xFFFF;
        /* part / 2^16 + 1/2^17 has 17 decimals: part * 10^17 / 2^16 + 10^17 / 2^17 */
        const uint64_t tie = part * UINT64_C(1525878906250) + UINT64_C(762939453125);
        char text[64];

        for (int nudge = -1; nudge <= 1; nudge++) {
            (void)snprintf(text, sizeof text, "%" PRId32 ".%017" PRIu64, whole,
                           nudge < 0   ? tie - 1
                           : nudge > 0 ? tie + 1
                                       : tie);
            scales(text, 16, whole * 65536 + (int32_t)part + (nudge >= 0));
        }
    }
}

void suite_decimal(void)
{
    RUN(numbers_are_rounded_once);
    RUN(large_and_small_ones_too);
    RUN(other_words_are_none);
    RUN(against_the_integers);
}
