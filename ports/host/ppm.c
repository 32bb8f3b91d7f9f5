/* ports/host/ppm.c: reads PPM files for the scene's textures. Format: J. Poskanzer and others,
 * ppm(5) and pbm(5) of Netpbm. */
#include "ppm.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "file.h"

/* What is left of the file. */
struct header {
    const char *at, *end;
};

/* The next character, -1 at the end. A comment is the character that ends it. */
static int take(struct header *h)
{
    int c = h->at != h->end ? *h->at++ : -1;

    if (c == '#') {
        while (c != '\n' && c != '\r' && c != -1) {
            c = h->at != h->end ? *h->at++ : -1;
        }
    }
    return c;
}

static bool is_blank(int c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

static bool is_digit(int c)
{
    return c >= '0' && c <= '9';
}

/* Blanks, digits and the one blank behind them; what is too large becomes 99999 or more. */
static bool take_number(struct header *h, int32_t *number)
{
    int c = take(h);

    while (is_blank(c)) {
        c = take(h);
    }
    if (!is_digit(c)) {
        return false;
    }
    for (*number = 0; is_digit(c); c = take(h)) {
        *number = *number < 99999 ? *number * 10 + (c - '0') : *number;
    }
    return is_blank(c);
}

/* NULL, or why this is not a picture that can be taken. */
static const char *read_header(struct header *h, struct etch_ppm *ppm)
{
    int32_t greatest;

    if (take(h) != 'P' || take(h) != '6' || !is_blank(take(h))) {
        return "is not a binary PPM, which begins with P6";
    }
    if (!take_number(h, &ppm->width) || !take_number(h, &ppm->height) ||
        !take_number(h, &greatest)) {
        return "has a header that is not width, height and maxval";
    }
    if (ppm->width < 1 || ppm->width > 32767 || ppm->height < 1 || ppm->height > 32767) {
        return "has a side that is not in 1 .. 32767";
    }
    return greatest != 255 ? "has a maxval that is not 255" : NULL;
}

static bool take_pixels(struct etch_ppm *ppm, const struct header *h, const char *name,
                        struct etch_text *from)
{
    const size_t has = (size_t)(h->end - h->at);
    const size_t needs = (size_t)ppm->width * (size_t)ppm->height * 3;

    ppm->rgb = (const uint8_t *)h->at;
    return has == needs ||
           etch_text_fail(from, "%s has %zu bytes of pixels, %s than %d x %d x 3", name, has,
                          has < needs ? "fewer" : "more", (int)ppm->width, (int)ppm->height);
}

bool etch_ppm_open(struct etch_ppm *ppm, const char *path, const char *name, struct etch_text *from)
{
    struct header h;
    const char *reason;
    size_t size;
    bool ok;

    *ppm = (struct etch_ppm){.data = etch_file_read(path, &size)};
    if (ppm->data == NULL) {
        return etch_text_fail(from, "cannot open %s: %s", name, strerror(errno));
    }
    h = (struct header){ppm->data, ppm->data + size};
    reason = read_header(&h, ppm);
    ok = reason == NULL ? take_pixels(ppm, &h, name, from)
                        : etch_text_fail(from, "%s %s", name, reason);
    if (!ok) {
        etch_ppm_close(ppm);
    }
    return ok;
}

void etch_ppm_close(struct etch_ppm *ppm)
{
    free(ppm->data);
    ppm->data = NULL;
}
