/* ports/host/scene_text.c: the statements font, text and textbox. scene.c finds them by name,
 * scene_draw.c calls what they append. */
#include <string.h>

#include "../../core/draw/text.h"
#include "../../core/fonts/fonts.h"
#include "scene_steps.h"

struct etch_scene_words {
    const struct etch_font *font;
    char *text, *end;
    int16_t at[4]; /* x, y; of boxes also w, h */
    uint8_t rgb[3], back[3];
    enum etch_align align;
    uint8_t turn;
    bool cells;
};

/* ---- drawing ------------------------------------------------------------------------------ */

typedef void words_draw(const struct etch_surface *s, const struct etch_text_style *style,
                        const struct etch_scene_words *w);

static void draw_box(const struct etch_surface *s, const struct etch_text_style *style,
                     const struct etch_scene_words *w)
{
    (void)etch_text_box(s, style, etch_rect_from_size(w->at[0], w->at[1], w->at[2], w->at[3]),
                        w->align, w->text, w->end);
}

static void draw_line(const struct etch_surface *s, const struct etch_text_style *style,
                      const struct etch_scene_words *w)
{
    (void)etch_text_draw_aligned(s, style, w->at[0], w->at[1], w->align, w->text, w->end);
}

static void draw_turned(const struct etch_surface *s, const struct etch_text_style *style,
                        const struct etch_scene_words *w)
{
    (void)etch_text_draw_turned(s, style, w->at[0], w->at[1], w->turn, w->text, w->end);
}

static void draw_cells(const struct etch_surface *s, const struct etch_text_style *style,
                       const struct etch_scene_words *w)
{
    (void)etch_text_draw_cells(s, style, w->at[0], w->at[1], w->text, w->end);
}

static etch_glyph_painter *painter(const struct etch_scene_run *run,
                                   const struct etch_scene_words *w)
{
    const bool swapped = run->scene->format == ETCH_FORMAT_RGB565_SWAPPED;

    if (w->font->depth == 4) {
        return swapped ? etch_glyph_blend4_swapped : etch_glyph_blend4;
    }
    if (w->font->depth == 2) {
        return swapped ? etch_glyph_blend2_swapped : etch_glyph_blend2;
    }
    return w->cells ? etch_glyph_opaque : etch_glyph_solid;
}

/* Draws once more in white on the scratch plane: the faintest ink there is not 0. */
static void count(struct etch_scene_run *run, struct etch_text_style style, words_draw *draw,
                  const struct etch_scene_words *w)
{
    struct etch_surface scratch = run->surface;
    const struct etch_rect clip = scratch.clip;

    scratch.pixels = run->scratch;
    style.color = style.background = UINT16_MAX;
    draw(&scratch, &style, w);
    for (int16_t y = clip.y0; y < clip.y1; y++) {
        for (int16_t x = clip.x0; x < clip.x1; x++) {
            uint16_t *pixel = &scratch.pixels[etch_surface_index(&scratch, x, y)];

            run->stats->pixels += *pixel != 0;
            *pixel = 0;
        }
    }
}

static void draw_words(struct etch_scene_run *run, const struct etch_scene_step *step,
                       words_draw *draw)
{
    const struct etch_scene_words *w = step->of.data;
    const struct etch_text_style style = {w->font, painter(run, w), etch_scene_color(run, w->rgb),
                                          etch_scene_color(run, w->back)};

    draw(&run->surface, &style, w);
    if (run->stats != NULL) {
        count(run, style, draw, w);
    }
}

static void draw_text_statement(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct etch_scene_words *w = step->of.data;

    draw_words(run, step, w->cells ? draw_cells : w->turn != 0 ? draw_turned : draw_line);
}

static void draw_box_statement(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    draw_words(run, step, draw_box);
}

/* ---- reading ------------------------------------------------------------------------------ */

static bool read_font(struct etch_scene_reader *reader,
                      const struct etch_scene_statement *statement)
{
    static const char *const names[] = {"fixed_5x8", "fixed_6x13", "fixed_9x15",   "fixed_10x20",
                                        "sans_12",   "sans_16",    "sans_16_2bit", "sans_24",
                                        "digits_40", NULL};
    static const struct etch_font *const fonts[] = {
        &etch_font_fixed_5x8,    &etch_font_fixed_6x13, &etch_font_fixed_9x15,
        &etch_font_fixed_10x20,  &etch_font_sans_12,    &etch_font_sans_16,
        &etch_font_sans_16_2bit, &etch_font_sans_24,    &etch_font_digits_40};
    int i;

    (void)statement;
    if (!etch_text_choice(&reader->text, "font", names, &i)) {
        return false;
    }
    reader->font = fonts[i];
    return true;
}

static int hex_digit(char c)
{
    const char *const digits = "0123456789abcdef0123456789ABCDEF";
    const char *at = c != '\0' ? strchr(digits, c) : NULL;

    return at != NULL ? (int)(at - digits) % 16 : -1;
}

/* What follows a backslash at *from, and how many characters it has; 0 if it means nothing. */
static int escape(const char *from, const char *end, char *to)
{
    if (*from == 'n' || *from == '"' || *from == '\\') {
        *to = *from == 'n' ? '\n' : *from;
        return 1;
    }
    if (*from == 'x' && end - from > 2 && hex_digit(from[1]) >= 0 && hex_digit(from[2]) >= 0) {
        *to = (char)(hex_digit(from[1]) * 16 + hex_digit(from[2]));
        return 3;
    }
    return 0;
}

/* "..." with \n, \", \\ and \xHH. In quotes # is no comment: the line is looked at again. */
static bool read_quoted(struct etch_scene_reader *reader, struct etch_scene_words *w)
{
    struct etch_text *text = &reader->text;
    const char *end = text->next, *from, *comment;

    if (!etch_text_more(text) || *text->at != '"') {
        return etch_text_fail(text, "text: must be in quotes");
    }
    w->text = w->end = etch_scene_data(reader, (size_t)(end - text->at) + 1);
    if (w->text == NULL) {
        return false;
    }
    for (from = text->at + 1; from != end && *from != '"' && *from != '\n'; from++) {
        *w->end = *from;
        if (*from == '\\') {
            const int n = from + 1 != end ? escape(from + 1, end, w->end) : 0;

            if (n == 0) {
                return etch_text_fail(text, "text: a backslash stands before n, \", \\ or xHH");
            }
            from += n;
        }
        w->end++;
    }
    if (from == end || *from != '"') {
        return etch_text_fail(text, "text: the closing quote is missing");
    }
    text->at = from + 1;
    if (text->at > text->end) {
        comment = memchr(text->at, '#', (size_t)(end - text->at));
        text->end = comment != NULL ? comment : end;
        text->end -= text->end != text->at && text->end[-1] == '\n';
    }
    return true;
}

/* [align left|centre|right], and of lines [turn 0..3] and [back R G B]. */
static bool read_options(struct etch_scene_reader *reader, struct etch_scene_words *w, bool box)
{
    static const char *const aligns[] = {"left", "centre", "right", NULL};
    int64_t turn;
    int align;

    while (etch_text_more(&reader->text)) {
        if (etch_scene_take(reader, "align")) {
            if (!etch_text_choice(&reader->text, "align", aligns, &align)) {
                return false;
            }
            w->align = (enum etch_align)align;
        } else if (!box && etch_scene_take(reader, "turn")) {
            if (!etch_text_integer(&reader->text, "turn", 0, 3, &turn)) {
                return false;
            }
            w->turn = (uint8_t)turn;
        } else if (!box && etch_scene_take(reader, "back")) {
            w->cells = true;
            if (!etch_scene_read_rgb(reader, w->back)) {
                return false;
            }
        } else {
            return true; /* a word too many is the line's error */
        }
    }
    if (w->cells && w->font->depth != 1) {
        return etch_text_fail(&reader->text, "back needs a font of 1 bit a pixel");
    }
    if ((w->align != ETCH_ALIGN_LEFT) + (w->turn != 0) + w->cells > 1) {
        return etch_text_fail(&reader->text, "only one of align, turn and back");
    }
    return true;
}

/* The font and its painter, as --needs names them. */
static const char *needs_of(const struct etch_scene_words *w)
{
    static const struct {
        const struct etch_font *font;
        const char *needs;
    } fonts[] = {
        {&etch_font_fixed_5x8, "etch_font_fixed_5x8 etch_glyph_solid"},
        {&etch_font_fixed_6x13, "etch_font_fixed_6x13 etch_glyph_solid"},
        {&etch_font_fixed_9x15, "etch_font_fixed_9x15 etch_glyph_solid"},
        {&etch_font_fixed_10x20, "etch_font_fixed_10x20 etch_glyph_solid"},
        {&etch_font_sans_12, "etch_font_sans_12 etch_glyph_blend4"},
        {&etch_font_sans_16, "etch_font_sans_16 etch_glyph_blend4"},
        {&etch_font_sans_16_2bit, "etch_font_sans_16_2bit etch_glyph_blend2"},
        {&etch_font_sans_24, "etch_font_sans_24 etch_glyph_blend4"},
        {&etch_font_digits_40, "etch_font_digits_40 etch_glyph_blend4"},
    };
    size_t i = 0;

    while (fonts[i].font != w->font) {
        i++;
    }
    return fonts[i].needs;
}

static bool read_words(struct etch_scene_reader *reader,
                       const struct etch_scene_statement *statement)
{
    static const char *const names[] = {"x", "y", "w", "h"};
    struct etch_scene_step *step = etch_scene_append(reader, statement);
    struct etch_scene_words *w = step != NULL ? etch_scene_data(reader, sizeof *w) : NULL;
    const bool box = statement->draw == draw_box_statement;
    int64_t value;

    if (w == NULL) {
        return false;
    }
    step->of.data = w;
    w->font = reader->font != NULL ? reader->font : &etch_font_fixed_6x13;
    step->needs = needs_of(w);
    for (int i = 0; i < (box ? 4 : 2); i++) {
        if (!etch_text_integer(&reader->text, names[i], INT16_MIN, INT16_MAX, &value)) {
            return false;
        }
        w->at[i] = (int16_t)value;
    }
    return read_quoted(reader, w) && etch_scene_read_rgb(reader, w->rgb) &&
           read_options(reader, w, box);
}

const struct etch_scene_statement etch_scene_text_statements[] = {
    {"font", read_font, NULL, NULL, NULL},
    {"text", read_words, draw_text_statement,
     "etch_text_draw_aligned etch_text_draw_turned etch_text_draw_cells", NULL},
    {"textbox", read_words, draw_box_statement, "etch_text_box", NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
