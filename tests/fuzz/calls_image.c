/* tests/fuzz: images in every format, as they are, turned, scaled, compressed; maps; text. */
#include "calls.h"

#include "core/draw/text_small.h"
#include "core/fonts/fonts.h"

/* ---- images ---------------------------------------------------------------------------------- */

static etch_image_row *const formats[] = {
    etch_row_rgb565,        etch_row_rgb565_key,
    etch_row_rgb565_fade,   etch_row_rgb565_fade_swapped,
    etch_row_rgb565_alpha,  etch_row_rgb565_alpha_swapped,
    etch_row_index8,        etch_row_index8_key,
    etch_row_index8_fade,   etch_row_index8_fade_swapped,
    etch_row_index4,        etch_row_index4_key,
    etch_row_index4_fade,   etch_row_index4_fade_swapped,
    etch_row_index2,        etch_row_index2_key,
    etch_row_index2_fade,   etch_row_index2_fade_swapped,
    etch_row_index1,        etch_row_index1_key,
    etch_row_index1_fade,   etch_row_index1_fade_swapped,
    etch_row_index1_xor,    etch_row_mask8,
    etch_row_mask8_swapped, etch_row_mask4,
    etch_row_mask4_swapped,
};

/* Texels enough for every format, and a palette. */
static void picture(struct fuzz_calls *c, struct etch_image *image, struct etch_image_style *style)
{
    const uint8_t kind = fuzz_byte(c), seed = fuzz_byte(c);
    const uint16_t width = (uint16_t)(1 + fuzz_below(c, 24)),
                   height = (uint16_t)(1 + fuzz_below(c, 12));
    const uint16_t stride = (uint16_t)(width + kind % 3);
    const size_t size = (size_t)stride * height;
    uint16_t *texels = fuzz_memory(size * 2), *palette = fuzz_memory(512);
    uint8_t *alpha = fuzz_memory(size);

    for (size_t i = 0; i < size; i++) {
        texels[i] = (uint16_t)(i * 31 + seed);
        alpha[i] = (uint8_t)(i * 7 + seed);
    }
    for (size_t i = 0; i < 256; i++) {
        palette[i] = (uint16_t)(i * 251 + seed);
    }
    *image = (struct etch_image){NULL, NULL, texels, palette, alpha, width, height, stride};
    *style = (struct etch_image_style){image, formats[kind % (sizeof formats / sizeof formats[0])],
                                       fuzz_byte(c)};
}

static void image(struct fuzz_calls *c, fuzz_function *f)
{
    struct etch_image i;
    struct etch_image_style style;

    (void)f;
    picture(c, &i, &style);
    const int16_t x = fuzz_x(c), y = fuzz_y(c);

    etch_image_draw(&c->s, &style, x, y);
}

static void part(struct fuzz_calls *c, fuzz_function *f)
{
    struct etch_image i;
    struct etch_image_style style;

    (void)f;
    picture(c, &i, &style);
    const struct etch_rect from = fuzz_rect(c);
    const int16_t x = fuzz_x(c), y = fuzz_y(c);

    etch_image_draw_part(&c->s, &style, from, x, y);
}

static void turned(struct fuzz_calls *c, fuzz_function *f)
{
    struct etch_image i;
    struct etch_image_style style;

    (void)f;
    picture(c, &i, &style);
    const int16_t x = fuzz_x(c), y = fuzz_y(c);

    etch_image_draw_turned(&c->s, &style, x, y, (enum etch_turn)(fuzz_byte(c) % 8));
}

static void scaled(struct fuzz_calls *c, fuzz_function *f)
{
    struct etch_image i;
    struct etch_image_style style;

    (void)f;
    picture(c, &i, &style);
    const struct etch_rect from = fuzz_byte(c) < 128 ? etch_image_whole(&i) : fuzz_rect(c);
    const int16_t x = fuzz_x(c), y = fuzz_y(c), w = fuzz_size(c), h = fuzz_size(c);

    etch_image_draw_scaled(&c->s, &style, from, x, y, w, h);
}

static void nine(struct fuzz_calls *c, fuzz_function *f)
{
    struct etch_image i;
    struct etch_image_style style;
    struct etch_border border;

    (void)f;
    picture(c, &i, &style);
    border.left = fuzz_byte(c) < 250 ? fuzz_below(c, 12) : UINT16_MAX;
    border.top = fuzz_byte(c) < 250 ? fuzz_below(c, 12) : UINT16_MAX;
    border.right = fuzz_below(c, 12);
    border.bottom = fuzz_below(c, 12);
    const int16_t x = fuzz_x(c), y = fuzz_y(c), w = fuzz_size(c), h = fuzz_size(c);

    etch_image_draw_nine(&c->s, &style, &border, x, y, w, h);
}

/* ---- maps ------------------------------------------------------------------------------------ */

static bool map_of(struct fuzz_calls *c, struct etch_map *map, struct etch_rect from)
{
    const uint8_t kind = fuzz_byte(c);

    if (kind < 64) {
        const int16_t x = fuzz_x(c), y = fuzz_y(c), w = fuzz_size(c), h = fuzz_size(c);

        etch_map_scale(map, from, x, y, w, h);
        return true;
    }
    if (kind < 160) {
        struct etch_map_place place = {.u = fuzz_s32(c), .v = fuzz_s32(c)};

        place.x = fuzz_s32(c), place.y = fuzz_s32(c);
        place.angle = fuzz_word(c);
        place.scale_u = fuzz_s32(c), place.scale_v = fuzz_s32(c);
        return etch_map_rotate(map, from, &place) == ETCH_OK;
    }
    struct etch_affine affine = {.xu = fuzz_s32(c), .xv = fuzz_s32(c)};

    affine.x0 = fuzz_s32(c), affine.yu = fuzz_s32(c), affine.yv = fuzz_s32(c),
    affine.y0 = fuzz_s32(c);
    return etch_map_invert(map, from, &affine) == ETCH_OK;
}

static void mapped(struct fuzz_calls *c, fuzz_function *f)
{
    struct etch_image i;
    struct etch_image_style style;
    struct etch_map map;

    (void)f;
    picture(c, &i, &style);
    if (map_of(c, &map, etch_image_whole(&i))) {
        etch_image_draw_mapped(&c->s, &style, &map);
    }
}

/* Filtered, clamped, by stages. */
static void map_runs(struct fuzz_calls *c, fuzz_function *f)
{
    static etch_texel_filter *const filters[] = {etch_filter_linear, etch_filter_nearest,
                                                 etch_filter_linear_clamp};
    const struct etch_blend_constant opacity = {fuzz_byte(c)};
    struct etch_image i;
    struct etch_image_style style;
    struct etch_sampler sampler;
    struct etch_map map;

    (void)f;
    picture(c, &i, &style);
    i.colors = etch_texels_rgb565;
    if (etch_sampler_init(&sampler, &i, filters[opacity.alpha % 3], etch_texels_clamp) != ETCH_OK) {
        fuzz_fail("a sampler is refused");
    }
    if (map_of(c, &map, etch_image_whole(&i))) {
        const struct etch_stage stages[] = {{etch_source_map, &map},
                                            {etch_stage_texture_replace, &sampler},
                                            {etch_stage_opacity, &opacity},
                                            {etch_stage_read, NULL},
                                            {etch_stage_blend_alpha, NULL},
                                            {etch_stage_write, NULL},
                                            {NULL, NULL}};
        const struct etch_staged_paint paint = {{etch_kernel_staged}, stages};

        etch_map_runs(&c->s, &map, &paint.paint);
    }
}

/* ---- compressed images: any data ------------------------------------------------------------- */

static void rle(struct fuzz_calls *c, fuzz_function *f)
{
    const uint8_t kind = fuzz_byte(c), shift = (uint8_t)(fuzz_byte(c) % 4);
    const uint16_t width = (uint16_t)(1 + fuzz_below(c, 20)),
                   height = (uint16_t)(1 + fuzz_below(c, 10));
    const bool words = kind % 2 == 0;
    const int16_t x = fuzz_x(c), y = fuzz_y(c);
    const uint32_t size = (uint32_t)(c->end - c->at);
    uint8_t *data = fuzz_memory(size);
    uint32_t *rows = fuzz_memory(sizeof *rows * 16);
    uint16_t *palette = fuzz_memory(512);
    struct etch_rle_image packed = {
        .image = {NULL, NULL, NULL, palette, NULL, width, height, width},
        .texels = {words ? etch_rle_words : etch_rle_bytes, data, rows, size, width,
                   (uint8_t)(words ? 2 : 1), 1, shift}};
    struct etch_rle_style style = {&packed, words ? etch_row_rgb565 : etch_row_index8, kind, NULL};

    (void)f;
    for (uint32_t i = 0; i < size; i++) {
        data[i] = c->at[i];
    }
    for (uint32_t i = 0; i < 16; i++) {
        rows[i] = i == 7 ? UINT32_MAX : i * 2;
    }
    style.line = fuzz_memory(etch_rle_line_size(&packed));
    etch_rle_draw(&c->s, &style, x, y);
}

/* ---- text ------------------------------------------------------------------------------------ */

enum {
    LINE,
    TURNED,
    CELLS,
    ALIGNED,
    BOX
};

static void write(struct fuzz_calls *c, int way)
{
    static const struct etch_font *const fonts[] = {&etch_font_fixed_6x13, &etch_font_sans_16_2bit,
                                                    &etch_font_sans_12};
    static etch_glyph_painter *const painters[3][4] = {
        {etch_glyph_solid, etch_glyph_opaque, etch_glyph_solid_small, etch_glyph_solid},
        {etch_glyph_blend2, etch_glyph_blend2_swapped, etch_glyph_blend2, etch_glyph_blend2},
        {etch_glyph_blend4, etch_glyph_blend4_swapped, etch_glyph_blend4, etch_glyph_blend4}};
    const uint8_t kind = fuzz_byte(c);
    const struct etch_text_style style = {fonts[kind % 3], painters[kind % 3][kind / 3 % 4],
                                          fuzz_word(c), kind};
    const struct etch_rect box = fuzz_rect(c);
    const char *text = (const char *)c->at, *end = (const char *)c->end;
    const enum etch_align align = (enum etch_align)(kind / 64 % 3);

    switch (way) {
    case LINE: (void)etch_text_draw(&c->s, &style, box.x0, box.y0, text, end); break;
    case TURNED: (void)etch_text_draw_turned(&c->s, &style, box.x0, box.y0, kind, text, end); break;
    case CELLS: (void)etch_text_draw_cells(&c->s, &style, box.x0, box.y0, text, end); break;
    case ALIGNED:
        (void)etch_text_draw_aligned(&c->s, &style, box.x0, box.y0, align, text, end);
        break;
    default: (void)etch_text_box(&c->s, &style, box, align, text, end);
    }
}

static void text(struct fuzz_calls *c, fuzz_function *f)
{
    (void)f;
    write(c, LINE);
}

static void text_turned(struct fuzz_calls *c, fuzz_function *f)
{
    (void)f;
    write(c, TURNED);
}

static void text_cells(struct fuzz_calls *c, fuzz_function *f)
{
    (void)f;
    write(c, CELLS);
}

static void text_aligned(struct fuzz_calls *c, fuzz_function *f)
{
    (void)f;
    write(c, ALIGNED);
}

static void text_box(struct fuzz_calls *c, fuzz_function *f)
{
    (void)f;
    write(c, BOX);
}

const struct fuzz_row fuzz_image_rows[] = {
    {"etch_image_draw", image, NULL},
    {"etch_image_draw_part", part, NULL},
    {"etch_image_draw_turned", turned, NULL},
    {"etch_image_draw_scaled", scaled, NULL},
    {"etch_image_draw_nine", nine, NULL},
    {"etch_image_draw_mapped", mapped, NULL},
    {"etch_map_runs", map_runs, NULL},
    {"etch_rle_draw", rle, NULL},
    {"etch_text_draw", text, NULL},
    {"etch_text_draw_turned", text_turned, NULL},
    {"etch_text_draw_cells", text_cells, NULL},
    {"etch_text_draw_aligned", text_aligned, NULL},
    {"etch_text_box", text_box, NULL},
    {NULL, NULL, NULL},
};
