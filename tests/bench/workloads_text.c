/* bench/workloads_text.c: W14, 2,000 characters of 9 x 15 px as texts of one letter. See bench.h.
 */
#include "bench.h"

#include "../../core/draw/text.h"
#include "../../core/fonts/fonts.h"

static wl_glyph glyphs[WL_NGLYPH];

static void prepare_glyphs(void)
{
    wl_make_glyphs(glyphs);
}

static void draw_glyphs(const struct etch_surface *s, uint8_t frame)
{
    struct etch_text_style style = {&etch_font_fixed_9x15, etch_glyph_solid, 0, 0};

    (void)frame;
    for (const wl_glyph *p = glyphs; p < glyphs + WL_NGLYPH; p++) {
        const char text[2] = {(char)p->ch, '\0'};

        style.color = p->c;
        etch_text_draw(s, &style, p->x, (int16_t)(p->y + style.font->ascent), text, 0);
    }
}

const struct bench_workload bench_w14 = {1, false, prepare_glyphs, draw_glyphs};
