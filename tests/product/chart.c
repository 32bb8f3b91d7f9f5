/* tests/product: the climate of a room, as a chart that scrolls: two smooth lines with a legend,
 * one with its area filled, a grid with times that move along, cards with the latest values, a
 * choice of spans. See product.h. */
#include "plot.h"
#include "product.h"

#include "core/fonts/fonts.h"
#include "core/fragment/gradient.h"

enum {
    PAPER = 0xEEF1F6,
    CARD = 0xFFFFFF,
    SHADE = 0xCBD3E1,
    RULE = 0x9AA8C0,
    TEXT = 0x1B2437,
    MUTED = 0x6B778D
};

static void draw_grid(const struct etch_surface *s)
{
    char label[24];

    text(s, &etch_font_sans_12, warm.rgb, LEFT - 6, TOP - 10, ETCH_ALIGN_RIGHT, "\u00B0C");
    text(s, &etch_font_sans_12, wet.rgb, RIGHT + 12, TOP - 10, ETCH_ALIGN_LEFT, "%");
    for (int16_t i = 0; i <= 4; i++) {
        const int16_t y = (int16_t)(BOTTOM - i * (BOTTOM - TOP) / 4);
        const struct etch_rect rule = {LEFT, (int16_t)(y - 1), RIGHT, y};

        box(s, rule, 0, glass(RULE, i == 0 ? 255 : 90));
        text(s, &etch_font_sans_12, MUTED, LEFT - 6, (int16_t)(y + 4), ETCH_ALIGN_RIGHT,
             number(label, 15 + 3 * i, 0, ""));
        text(s, &etch_font_sans_12, MUTED, RIGHT + 12, (int16_t)(y + 4), ETCH_ALIGN_LEFT,
             number(label, 20 + 15 * i, 0, ""));
    }
}

/* Every 15 samples a time under the plot, which moves along. */
static void draw_times(const struct etch_surface *s)
{
    for (int i = 0; i < SAMPLES; i++) {
        const uint32_t k = plot_newest() - (uint32_t)(SAMPLES - i), minutes = 13 * 60 + k / 3;
        const int16_t x = (int16_t)(plot_place(&warm, i).x / 256);
        char clock[6] = {(char)('0' + minutes / 600 % 3), (char)('0' + minutes / 60 % 10), ':',
                         (char)('0' + minutes % 60 / 10), (char)('0' + minutes % 10),      '\0'};
        const struct etch_rect rule = {x, TOP, (int16_t)(x + 1), BOTTOM};

        if (k % 15 != 0 || x < LEFT + 4 || x > RIGHT - 4)
            continue;
        box(s, rule, 0, glass(RULE, 60));
        text(s, &etch_font_sans_12, MUTED, x, BOTTOM + 16, ETCH_ALIGN_CENTRE, clock);
    }
}

/* ---- around it
 * ----------------------------------------------------------------------------------- */

static void card(const struct etch_surface *s, struct etch_rect r)
{
    const struct etch_rect below = {r.x0, (int16_t)(r.y0 + 2), r.x1, (int16_t)(r.y1 + 2)};

    box(s, below, 10, solid(SHADE));
    box(s, r, 10, solid(CARD));
}

static void draw_legend(const struct etch_surface *s, int16_t x, const struct series *series,
                        const char *name)
{
    line(s, corner((int16_t)(x + 2), 63), corner((int16_t)(x + 14), 63), series->width_q8 / 16,
         solid(series->rgb));
    disc(s, corner((int16_t)(x + 8), 63), 3 * 16 + 8, solid(CARD));
    disc(s, corner((int16_t)(x + 8), 63), 2 * 16 + 8, solid(series->rgb));
    text(s, &etch_font_sans_12, TEXT, (int16_t)(x + 21), 68, ETCH_ALIGN_LEFT, name);
}

static void draw_value(const struct etch_surface *s, int16_t x, const struct series *series,
                       const char *name, const char *unit, int32_t divisor)
{
    const struct etch_rect r = {x, 218, (int16_t)(x + 106), 272};
    const struct etch_rect mark = {(int16_t)(x + 10), 228, (int16_t)(x + 13), 262};
    const int16_t value = series->sample[SAMPLES - 2];
    const bool rises = value >= series->sample[SAMPLES - 8];
    char digits[24];

    card(s, r);
    box(s, mark, 1, solid(series->rgb));
    text(s, &etch_font_sans_12, MUTED, (int16_t)(x + 20), 238, ETCH_ALIGN_LEFT, name);
    text(s, &etch_font_sans_24, TEXT, (int16_t)(x + 19), 263, ETCH_ALIGN_LEFT,
         number(digits, (value + divisor / 2) / divisor, divisor == 10 ? 1 : 0, unit));
    text(s, &etch_font_sans_12, rises ? 0x2B8A3E : 0xC92A2A, (int16_t)(x + 97), 263,
         ETCH_ALIGN_RIGHT, rises ? "\u25B2" : "\u25BC");
}

static void draw_spans(const struct etch_surface *s)
{
    static const char *const names[] = {"15 min", "1 h", "24 h"};
    const struct etch_rect bar = {10, 284, 230, 310}, chosen = {13, 287, 84, 307};

    box(s, bar, 13, solid(0xDCE2EC));
    box(s, chosen, 10, solid(TEXT));
    for (int16_t i = 0; i < 3; i++)
        text(s, &etch_font_sans_12, i == 0 ? CARD : MUTED, (int16_t)(48 + 72 * i), 301,
             ETCH_ALIGN_CENTRE, names[i]);
}

static void draw(const struct etch_surface *s)
{
    static const struct etch_stop stops[] = {{0, 0xFF, 0xC0, 0x9A}, {65535, 0xFF, 0xF6, 0xF0}};
    static const struct etch_rect plot = {10, 44, 230, 208};
    static uint16_t colors[32];
    struct etch_ramp ramp;
    struct etch_gradient_linear down;

    (void)etch_ramp_init(&ramp, colors, 5, stops, 2); /* both by constants */
    (void)etch_gradient_linear_init(&down, &ramp, 0, TOP + 16, 0, BOTTOM);
    fill_all(s, PAPER);
    text(s, &etch_font_sans_16, TEXT, 14, 29, ETCH_ALIGN_LEFT, "Living room");
    text(s, &etch_font_sans_12, MUTED, 226, 28, ETCH_ALIGN_RIGHT, "every 20 s");
    card(s, plot);
    draw_legend(s, 22, &warm, "Temperature");
    draw_legend(s, 132, &wet, "Humidity");
    plot_lines(s, &down.brush);
    draw_grid(s);
    draw_times(s);
    plot_head(s, &wet);
    plot_head(s, &warm);
    draw_value(s, 10, &warm, "Temperature", "\u00B0", 10);
    draw_value(s, 124, &wet, "Humidity", "%", 100);
    draw_spans(s);
}

const struct product_screen product_chart = {"chart", plot_prepare, draw};
