/* bench/check_text.c: W14 by its definition: the bits of each glyph, one by one. See check.h. */
#include "../../core/fonts/fonts.h"
#include "check.h"

static void glyph(struct check *c, const wl_glyph *p)
{
    const struct etch_font *f = &etch_font_fixed_9x15;
    const struct etch_glyph *g = &f->glyphs[p->ch - 32]; /* its first range is ASCII */
    const int pitch = (g->width + 7) / 8;

    for (int y = 0; y < g->height; y++) {
        for (int x = 0; x < g->width; x++) {
            struct expected *e = &c->expected[p->y + f->ascent - g->top + y][p->x + g->left + x];

            if ((f->bits[g->bits + y * pitch + x / 8] >> (7 - x % 8) & 1) == 0)
                continue;
            e->drawn = true;
            e->channel[0] = (p->c >> 11) * 65536;
            e->channel[1] = (p->c >> 5 & 63) * 65536;
            e->channel[2] = (p->c & 31) * 65536;
            c->pixels++;
        }
    }
}

void check_text(struct check *c)
{
    static wl_glyph glyphs[WL_NGLYPH];

    wl_make_glyphs(glyphs);
    c->primitives = WL_NGLYPH;
    for (const wl_glyph *p = glyphs; p < glyphs + WL_NGLYPH; p++)
        glyph(c, p);
}
