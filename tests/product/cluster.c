/* tests/product: the instrument cluster of an electric motorcycle: speed on a dial with a needle
 * and in digits, charge and motor temperature on small dials, telltales, distances. See
 * product.h. */
#include "parts.h"
#include "product.h"

#include "core/base/trig.h"
#include "core/fonts/fonts.h"
#include "core/fragment/gradient.h"

enum {
    FACE = 0x0A0E17,
    TRACK = 0x242C42,
    FAINT = 0x8793AB,
    BRIGHT = 0xF2F5FA,
    GREEN = 0x35D07F,
    AMBER = 0xFFB02E,
    RED = 0xFF4B4B,
    NEEDLE = 0xFF6A3D,

    DIAL_X = 120,
    DIAL_Y = 140,
    DIAL_FROM = 24576,  /* lower left, */
    DIAL_SWEEP = 49152, /* over the top to lower right */
    SPEED_MOST = 180,

    SMALL_Y = 272,
    SMALL_SWEEP = 32768
};

/* What the vehicle's bus says. */
static struct {
    int32_t speed_q4; /* km/h in sixteenths */
    int32_t charge, celsius, metres;
    bool left, right, beam;
    char clock[6];
} now;

static uint16_t dial_angle(int32_t speed_q4)
{
    return (uint16_t)(DIAL_FROM + DIAL_SWEEP / 16 * speed_q4 / SPEED_MOST);
}

/* A ride that repeats every 256 ticks. */
static void prepare(uint32_t tick)
{
    const uint16_t phase = (uint16_t)(tick << 8);
    const int32_t minutes = 10 * 60 + 42 + (int32_t)(tick / 64 % 600);

    now.speed_q4 = 16 * 84 + etch_sin_q16(phase) / 64 + etch_sin_q16((uint16_t)(3 * phase)) / 256;
    now.charge = 76 - (int32_t)(tick / 32 % 60);
    now.celsius = 64 + etch_sin_q16((uint16_t)(phase + 16384)) / 4096;
    now.metres = 132400 + (int32_t)(tick % 4096) * 23;
    now.left = (tick & 16) != 0;
    now.right = false;
    now.beam = true;
    now.clock[0] = (char)('0' + minutes / 600 % 10);
    now.clock[1] = (char)('0' + minutes / 60 % 10);
    now.clock[2] = ':';
    now.clock[3] = (char)('0' + minutes % 60 / 10);
    now.clock[4] = (char)('0' + minutes % 10);
}

/* An arrow of a turn signal, `way` 1 to the right. */
static void draw_arrow(const struct etch_surface *s, int16_t x, int16_t way, bool lit)
{
    static const int8_t outline[7][2] = {{10, 0},  {0, 9},  {0, 4}, {-9, 4},
                                         {-9, -4}, {0, -4}, {0, -9}};
    struct etch_point_q8 v[7];

    for (int i = 0; i < 7; i++)
        v[i] = corner((int16_t)(x + way * outline[i][0]), (int16_t)(19 + outline[i][1]));
    shape(s, v, 7, solid(lit ? GREEN : TRACK));
}

/* A headlamp with its beam. */
static void draw_beam(const struct etch_surface *s, int16_t x, int16_t y, struct ink ink)
{
    arc(s, corner(x, y), 7 * 16, 5 * 16 + 4, 49152 - 900, 32768 + 1800, ink);
    line(s, corner((int16_t)(x - 1), (int16_t)(y - 6)), corner((int16_t)(x - 1), (int16_t)(y + 6)),
         28, ink);
    for (int16_t i = -5; i <= 5; i = (int16_t)(i + 5))
        line(s, corner((int16_t)(x - 13), (int16_t)(y + i)),
             corner((int16_t)(x - 5), (int16_t)(y + i)), 26, ink);
}

static void draw_top(const struct etch_surface *s)
{
    draw_arrow(s, 20, -1, now.left);
    draw_arrow(s, 220, 1, now.right);
    text(s, &etch_font_sans_16, BRIGHT, DIAL_X, 25, ETCH_ALIGN_CENTRE, now.clock);
    draw_beam(s, 66, 19, solid(now.beam ? 0x4DA3FF : TRACK));
    text(s, &etch_font_sans_12, GREEN, 176, 24, ETCH_ALIGN_CENTRE, "ECO");
}

static void draw_ticks(const struct etch_surface *s)
{
    for (int32_t v = 0; v <= SPEED_MOST; v += 10) {
        const uint16_t angle = dial_angle(v * 16);
        const bool major = v % 20 == 0;
        const uint32_t rgb = v >= 150 ? RED : major ? BRIGHT : FAINT;

        line(s, polar(DIAL_X, DIAL_Y, major ? 80 * 16 : 84 * 16, angle),
             polar(DIAL_X, DIAL_Y, 88 * 16, angle), major ? 36 : 20, solid(rgb));
        if (major) {
            const struct etch_point_q8 p = polar(DIAL_X, DIAL_Y, 66 * 16, angle);
            char digits[24];

            text(s, &etch_font_sans_12, v >= 150 ? RED : 0xC4CCDA, (int16_t)(p.x >> 8),
                 (int16_t)((p.y >> 8) + 5), ETCH_ALIGN_CENTRE, number(digits, v, 0, ""));
        }
    }
}

/* The arc of what is driven now, its colours along the dial. */
static void draw_sweep(const struct etch_surface *s)
{
    static const struct etch_stop stops[] = {
        {0, 0x22, 0xD3, 0xEE}, {26000, 0x3B, 0x82, 0xF6}, {65535, 0xB4, 0x5C, 0xFF}};
    static uint16_t colors[64];
    struct etch_ramp ramp;
    struct etch_gradient_linear across;
    const struct etch_cover_brush_paint paint = {{PANEL_COVER_BRUSH}, &across.brush, 255};
    const uint32_t sweep = (uint32_t)(DIAL_SWEEP / 16 * now.speed_q4 / SPEED_MOST);

    arc(s, etch_pixel_q8(DIAL_X, DIAL_Y), 104 * 16, 93 * 16, DIAL_FROM, DIAL_SWEEP, solid(TRACK));
    (void)etch_ramp_init(&ramp, colors, 6, stops, 3); /* both by constants */
    (void)etch_gradient_linear_init(&across, &ramp, 40, 200, 220, 90);
    etch_smooth_arc(s, etch_pixel_q8(DIAL_X, DIAL_Y), 104 * 256, 93 * 256, DIAL_FROM, sweep,
                    &paint.paint, cover_row);
    arc(s, etch_pixel_q8(DIAL_X, DIAL_Y), 107 * 16, 105 * 16 + 8, dial_angle(150 * 16),
        DIAL_SWEEP / 6, solid(RED));
}

/* A needle from radius r0 to r1, as wide as `wide` sixteenths at its root. */
static void draw_needle(const struct etch_surface *s, int16_t x, int16_t y, int16_t r0, int16_t r1,
                        int16_t wide, uint16_t angle, struct ink ink)
{
    const struct etch_point_q8 side = polar(0, 0, wide / 2, (uint16_t)(angle + 16384));
    const struct etch_point_q8 root = polar(x, y, r0 * 16, angle),
                               tip = polar(x, y, r1 * 16, angle);
    const int32_t dx = side.x - 128, dy = side.y - 128;
    const struct etch_point_q8 v[] = {{root.x + dx, root.y + dy},
                                      {tip.x + dx / 4, tip.y + dy / 4},
                                      {tip.x - dx / 4, tip.y - dy / 4},
                                      {root.x - dx, root.y - dy}};

    shape(s, v, 4, ink);
}

static void draw_speed(const struct etch_surface *s)
{
    const struct etch_point_q8 middle = etch_pixel_q8(DIAL_X, DIAL_Y);
    char digits[24];

    draw_needle(s, DIAL_X + 1, DIAL_Y + 2, 40, 90, 136, dial_angle(now.speed_q4), glass(0, 110));
    draw_needle(s, DIAL_X, DIAL_Y, 40, 91, 128, dial_angle(now.speed_q4), solid(NEEDLE));
    disc(s, middle, 50 * 16, solid(0x151C2B));
    ring(s, middle, 50 * 16, 48 * 16, solid(0x3A465E));
    text(s, &etch_font_digits_40, BRIGHT, DIAL_X + 1, DIAL_Y + 12, ETCH_ALIGN_CENTRE,
         number(digits, (now.speed_q4 + 8) / 16, 0, ""));
    text(s, &etch_font_sans_12, FAINT, DIAL_X, DIAL_Y + 31, ETCH_ALIGN_CENTRE, "km/h");
}

static void draw_gear(const struct etch_surface *s)
{
    const struct etch_rect r = {102, 208, 138, 238};

    box(s, r, 8, solid(0x151C2B));
    border(s, r, 8, 24, solid(0x3A465E));
    text(s, &etch_font_sans_24, GREEN, 120, 232, ETCH_ALIGN_CENTRE, "D");
}

/* A half dial: `part` of 1000, of which the stretch from..to is a warning. */
static void draw_small(const struct etch_surface *s, int16_t x, int32_t part, int32_t from,
                       int32_t to, const char *low, const char *high)
{
    const struct etch_point_q8 middle = etch_pixel_q8(x, SMALL_Y);
    const uint16_t angle = (uint16_t)(32768 + SMALL_SWEEP * part / 1000);

    arc(s, middle, 34 * 16, 29 * 16, 32768, SMALL_SWEEP, solid(TRACK));
    arc(s, middle, 34 * 16, 29 * 16, (uint16_t)(32768 + SMALL_SWEEP * from / 1000),
        (uint32_t)(SMALL_SWEEP * (to - from) / 1000), solid(RED));
    for (int32_t i = 0; i <= 4; i++)
        line(s, polar(x, SMALL_Y, 23 * 16, (uint16_t)(32768 + 8192 * i)),
             polar(x, SMALL_Y, 25 * 16 + 8, (uint16_t)(32768 + 8192 * i)), 20, solid(FAINT));
    draw_needle(s, x, SMALL_Y, -7, 30, 64, angle, solid(NEEDLE));
    disc(s, middle, 5 * 16, solid(0x3A465E));
    disc(s, middle, 2 * 16, solid(FACE));
    text(s, &etch_font_sans_12, FAINT, (int16_t)(x - 31), SMALL_Y + 15, ETCH_ALIGN_CENTRE, low);
    text(s, &etch_font_sans_12, FAINT, (int16_t)(x + 32), SMALL_Y + 15, ETCH_ALIGN_CENTRE, high);
}

static void draw_bottom(const struct etch_surface *s)
{
    const struct etch_rect rule = {12, 294, 228, 295};
    char digits[24];

    draw_small(s, 52, now.charge * 10, 0, 150, "E", "F");
    draw_small(s, 188, (now.celsius - 20) * 10, 800, 1000, "C", "H");
    text(s, &etch_font_sans_16, BRIGHT, 120, 270, ETCH_ALIGN_CENTRE,
         number(digits, now.charge * 2, 0, " km"));
    text(s, &etch_font_sans_12, FAINT, 120, 284, ETCH_ALIGN_CENTRE, "range");
    box(s, rule, 0, solid(TRACK));
    text(s, &etch_font_sans_12, FAINT, 12, 311, ETCH_ALIGN_LEFT, "ODO");
    text(s, &etch_font_sans_12, BRIGHT, 45, 311, ETCH_ALIGN_LEFT,
         number(digits, 12846 + now.metres / 1000, 0, " km"));
    text(s, &etch_font_sans_12, BRIGHT, 228, 311, ETCH_ALIGN_RIGHT,
         number(digits, now.metres / 100, 1, " km"));
    text(s, &etch_font_sans_12, FAINT, 134, 311, ETCH_ALIGN_LEFT, "TRIP");
}

static void draw(const struct etch_surface *s)
{
    fill_all(s, FACE);
    draw_top(s);
    draw_sweep(s);
    draw_ticks(s);
    draw_speed(s);
    draw_gear(s);
    draw_bottom(s);
}

const struct product_screen product_cluster = {"cluster", prepare, draw};
