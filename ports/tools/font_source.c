/* ports/tools/font_source.c: trims, packs and writes fonts. See font_source.h. */
#include "font_source.h"

#include <stdlib.h>
#include <string.h>

void font_fail(const char *what, const char *detail)
{
    fprintf(stderr, "etch-font: %s%s\n", what, detail);
    exit(2);
}

bool font_set_has(const char *set, uint32_t code)
{
    while (*set != '\0') {
        char *end;
        const unsigned long first = strtoul(set, &end, 0);
        const unsigned long last = *end == '-' ? strtoul(end + 1, &end, 0) : first;

        if (end == set || (*end != ',' && *end != '\0') || last < first)
            font_fail("not a list of code points: ", set);
        if (code >= first && code <= last)
            return true;
        set = *end == ',' ? end + 1 : end;
    }
    return false;
}

struct font_glyph *font_add(struct font_source *f, uint32_t code, int width, int height)
{
    struct font_glyph *g = &f->glyph[f->count];

    if (f->count == FONT_GLYPHS)
        font_fail("too many glyphs", "");
    if (width < 0 || height < 0 || width > FONT_SIDE || height > FONT_SIDE)
        font_fail("a glyph is too large", "");
    *g = (struct font_glyph){.code = code, .width = width, .height = height};
    g->level = calloc((size_t)(width * height) + 1, 1);
    if (g->level == NULL)
        font_fail("out of memory", "");
    f->count++;
    return g;
}

static int by_code(const void *a, const void *b)
{
    const uint32_t x = ((const struct font_glyph *)a)->code;
    const uint32_t y = ((const struct font_glyph *)b)->code;

    return x < y ? -1 : x > y;
}

/* Keeps the rectangle of what is not 0. */
static void trim(struct font_glyph *g)
{
    int x0 = g->width, x1 = 0, y0 = g->height, y1 = 0;

    for (int i = 0; i < g->width * g->height; i++) {
        const int x = i % g->width, y = i / g->width;

        if (g->level[i] != 0) {
            x0 = x < x0 ? x : x0, x1 = x >= x1 ? x + 1 : x1;
            y0 = y < y0 ? y : y0, y1 = y >= y1 ? y + 1 : y1;
        }
    }
    if (x1 == 0) {
        g->width = g->height = g->left = g->top = 0;
        return;
    }
    for (int y = y0; y < y1; y++)
        memmove(g->level + (y - y0) * (x1 - x0), g->level + y * g->width + x0, (size_t)(x1 - x0));
    g->left += x0, g->top -= y0;
    g->width = x1 - x0, g->height = y1 - y0;
}

void font_finish(struct font_source *f)
{
    if (f->count == 0)
        font_fail("no glyph of the set is in the font", "");
    qsort(f->glyph, (size_t)f->count, sizeof f->glyph[0], by_code);
    for (int i = 0; i < f->count; i++) {
        struct font_glyph *g = &f->glyph[i];

        trim(g);
        if (i != 0 && g->code == g[-1].code)
            font_fail("a code point twice", "");
        if (g->left < -128 || g->left > 127 || g->top < -128 || g->top > 127 || g->advance < 0 ||
            g->advance > 255)
            font_fail("a glyph is too far from its pen", "");
    }
}

static int glyph_bytes(const struct font_source *f, const struct font_glyph *g)
{
    return (g->width * f->depth + 7) / 8 * g->height;
}

static void write_bits(FILE *out, const struct font_source *f, const char *name)
{
    int n = 0;

    fprintf(out, "static const uint8_t %s_bits[] = {", name);
    for (int i = 0; i < f->count; i++) {
        const struct font_glyph *g = &f->glyph[i];
        const int pitch = (g->width * f->depth + 7) / 8;

        for (int k = 0; k < pitch * g->height; k++) {
            const int y = k / pitch, per = 8 / f->depth;
            int byte = 0;

            for (int x = k % pitch * per; x < k % pitch * per + per; x++)
                byte = byte << f->depth | (x < g->width ? g->level[y * g->width + x] : 0);
            fprintf(out, "%s%d,", n++ % 24 == 0 ? "\n    " : "", byte);
        }
    }
    fprintf(out, "%s\n};\n\n", n == 0 ? "0" : "");
    if (n > UINT16_MAX)
        font_fail("more than 65535 bytes of bitmaps", "");
}

static void write_glyphs(FILE *out, const struct font_source *f, const char *name)
{
    int at = 0;

    fprintf(out, "static const struct etch_glyph %s_glyphs[] = {", name);
    for (int i = 0; i < f->count; i++) {
        const struct font_glyph *g = &f->glyph[i];

        fprintf(out, "%s{%d,%d,%d,%d,%d,%d},", i % 4 == 0 ? "\n    " : " ", at, g->width, g->height,
                g->left, g->top, g->advance);
        at += glyph_bytes(f, g);
    }
    fprintf(out, "\n};\n\n");
}

static int write_ranges(FILE *out, const struct font_source *f, const char *name)
{
    int ranges = 0;

    fprintf(out, "static const struct etch_font_range %s_ranges[] = {\n", name);
    for (int i = 0, n; i < f->count; i += n, ranges++) {
        for (n = 1; i + n < f->count && f->glyph[i + n].code == f->glyph[i].code + (uint32_t)n; n++)
            ;
        fprintf(out, "    {0x%lX, %d, %d},\n", (unsigned long)f->glyph[i].code, n, i);
    }
    fprintf(out, "};\n\n");
    return ranges;
}

static void write_pairs(FILE *out, const struct font_source *f, const char *name)
{
    fprintf(out, "static const struct etch_kern_pair %s_pairs[] = {", name);
    for (int i = 0; i < f->pair_count; i++)
        fprintf(out, "%s{%d,%d,%d},", i % 8 == 0 ? "\n    " : " ", f->pair[i].left,
                f->pair[i].right, f->pair[i].by);
    fprintf(out, "\n};\n\n");
}

/* U+FFFD, else the question mark, else none. */
static int replacement(const struct font_source *f)
{
    int found = UINT16_MAX;

    for (int i = 0; i < f->count; i++)
        if (f->glyph[i].code == 0xFFFD || f->glyph[i].code == '?')
            found = i;
    return found;
}

void font_write(FILE *out, const struct font_source *f, const char *name, const char *header,
                const char *from)
{
    int ranges;

    fprintf(out, "/* %s */\n#include \"%s\"\n\n/* clang-format off */\n\n", from, header);
    write_bits(out, f, name);
    write_glyphs(out, f, name);
    ranges = write_ranges(out, f, name);
    if (f->pair_count != 0)
        write_pairs(out, f, name);
    fprintf(out,
            "const struct etch_font %s = {\n    .bits = %s_bits,\n    .glyphs = %s_glyphs,\n"
            "    .ranges = %s_ranges,\n    .range_count = %d,\n",
            name, name, name, name, ranges);
    if (f->pair_count != 0)
        fprintf(out,
                "    .kern = etch_font_kern_pairs,\n    .pairs = %s_pairs,\n"
                "    .pair_count = %d,\n",
                name, f->pair_count);
    fprintf(out,
            "    .replacement = %d,\n    .depth = %d,\n    .ascent = %d,\n    .descent = %d,\n"
            "    .line = %d,\n};\n",
            replacement(f), f->depth, f->ascent, f->descent, f->line);
}
