/* tests/product: the menu of a room controller, glass over a photo: the photo in flash at half
 * the size, scaled up bilinear on the fly; panes of 8-bit opacity with rounded corners, symbols
 * from smooth shapes, a selection that moves. See product.h. */
#include "parts.h"
#include "product.h"

#include "core/fonts/fonts.h"
#include "core/fragment/sampler.h"
#include "core/fragment/source_map.h"
#include "core/fragment/write.h"
#include "core/raster/map_runs.h"
#include "symbols.h"

enum {
    WHITE = 0xFFFFFF,
    NIGHT = 0x0B1226,
    WARM = 0xFFB547,
    SOFT = 0xC9D2E6,

    ROWS = 5,
    ROW_Y = 92,
    ROW_HEIGHT = 42,
    ROW_LEFT = 14,
    ROW_RIGHT = 226
};

extern const struct etch_image product_photo; /* written by etch-image */

enum control {
    VALUE,
    SLIDER,
    SWITCH
};

struct row {
    const char *name, *value;
    symbol_painter *symbol;
    enum control control;
    uint8_t set; /* slider: percent; switch: on */
};

static const struct row rows[ROWS] = {
    {"Lights", "", symbol_lamp, SLIDER, 64},
    {"Heating", "21.5\u00B0", symbol_thermometer, VALUE, 0},
    {"Blinds", "", symbol_blinds, SWITCH, 1},
    {"Music", "", symbol_note, SWITCH, 0},
    {"Settings", "\u25B6", symbol_gear, VALUE, 0},
};

static int32_t chosen_q8; /* rows; moves from one to the next */

/* Eight ticks from row to row, of which it rests in four. */
static void prepare(uint32_t tick)
{
    const int32_t at = (int32_t)(tick / 8 % (2 * (ROWS - 1))), moved = (int32_t)(tick % 8);
    const int32_t part = moved < 4 ? 0 : (moved - 4) * 64;
    const int32_t way = at < ROWS - 1 ? 1 : -1;

    chosen_q8 = (at < ROWS - 1 ? at : 2 * (ROWS - 1) - at) * 256 + way * part;
}

static void draw_photo(const struct etch_surface *s)
{
    const struct etch_rect all = {0, 0, (int16_t)product_photo.width,
                                  (int16_t)product_photo.height};
    const struct etch_sampler sampler = {product_photo, etch_filter_linear_clamp, etch_texels_clamp,
                                         etch_texels_clamp};
    struct etch_map map;
    const struct etch_stage stages[] = {{etch_source_map, &map},
                                        {etch_stage_texture_replace, &sampler},
                                        {PANEL_STAGE_WRITE, NULL},
                                        {NULL, NULL}};
    const struct etch_staged_paint paint = {{etch_kernel_staged}, stages};

    etch_map_scale(&map, all, 0, 0, PRODUCT_WIDTH, PRODUCT_HEIGHT);
    etch_map_runs(s, &map, &paint.paint);
}

/* The battery and the strength of the radio. */
static void draw_status(const struct etch_surface *s)
{
    const struct etch_rect shell = {200, 13, 222, 25}, charge = {202, 15, 216, 23},
                           pole = {223, 17, 225, 21};

    text(s, &etch_font_sans_12, WHITE, 14, 24, ETCH_ALIGN_LEFT, "18:42");
    border(s, shell, 3, 20, solid(WHITE));
    box(s, charge, 2, solid(WHITE));
    box(s, pole, 1, solid(WHITE));
    for (int16_t i = 0; i < 4; i++) {
        const struct etch_rect bar = {(int16_t)(176 + 5 * i), (int16_t)(22 - 3 * i),
                                      (int16_t)(179 + 5 * i), 25};

        box(s, bar, 1, glass(WHITE, i < 3 ? 255 : 110));
    }
}

static void draw_switch(const struct etch_surface *s, int16_t y, bool on, struct ink ink)
{
    const struct etch_rect track = {182, (int16_t)(y - 10), 216, (int16_t)(y + 10)};

    box(s, track, 10, on ? solid(0x34C77B) : glass(WHITE, 90));
    disc(s, corner(on ? 206 : 192, y), 8 * 16, ink);
}

static void draw_slider(const struct etch_surface *s, int16_t y, uint8_t percent, struct ink ink)
{
    const int16_t x0 = 128, x1 = 212;
    const int16_t at = (int16_t)(x0 + (x1 - x0) * percent / 100);

    line(s, corner(x0, y), corner(x1, y), 64, glass(ink.rgb, 80));
    line(s, corner(x0, y), corner(at, y), 64, ink);
    disc(s, corner(at, y), 7 * 16, ink);
}

static void draw_row(const struct etch_surface *s, const struct row *row, int16_t y, bool chosen)
{
    const struct ink ink = solid(chosen ? NIGHT : WHITE);

    row->symbol(s, 36, y, ink);
    text(s, &etch_font_sans_16, ink.rgb, 58, (int16_t)(y + 6), ETCH_ALIGN_LEFT, row->name);
    if (row->control == SLIDER)
        draw_slider(s, y, row->set, ink);
    else if (row->control == SWITCH)
        draw_switch(s, y, row->set != 0, solid(WHITE));
    else
        text(s, &etch_font_sans_16, chosen ? NIGHT : SOFT, 216, (int16_t)(y + 6), ETCH_ALIGN_RIGHT,
             row->value);
}

static void draw_rows(const struct etch_surface *s)
{
    const int16_t top = (int16_t)(ROW_Y + chosen_q8 * ROW_HEIGHT / 256);
    const struct etch_rect pane = {ROW_LEFT - 4, ROW_Y - 4, ROW_RIGHT + 4,
                                   ROW_Y + ROWS * ROW_HEIGHT + 4};
    const struct etch_rect bar = {ROW_LEFT, top, ROW_RIGHT, (int16_t)(top + ROW_HEIGHT + 1)};

    box(s, pane, 16, glass(NIGHT, 150));
    border(s, pane, 16, 16, glass(WHITE, 60));
    for (int16_t i = 1; i < ROWS; i++) {
        const int16_t y = (int16_t)(ROW_Y + i * ROW_HEIGHT);
        const struct etch_rect rule = {58, y, ROW_RIGHT - 8, (int16_t)(y + 1)};

        box(s, rule, 0, glass(WHITE, 40));
    }
    box(s, bar, 12, glass(WARM, 232));
    for (int16_t i = 0; i < ROWS; i++)
        draw_row(s, &rows[i], (int16_t)(ROW_Y + i * ROW_HEIGHT + ROW_HEIGHT / 2),
                 i == (chosen_q8 + 128) / 256);
}

static void draw(const struct etch_surface *s)
{
    draw_photo(s);
    draw_status(s);
    text(s, &etch_font_sans_24, WHITE, 14, 60, ETCH_ALIGN_LEFT, "Good evening");
    text(s, &etch_font_sans_12, WHITE, 15, 78, ETCH_ALIGN_LEFT, "Lake house, 14\u00B0 outside");
    draw_rows(s);
}

const struct product_screen product_menu = {"menu", prepare, draw};
