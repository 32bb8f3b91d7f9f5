/* tests/product: the chart's plot: samples, and the lines through them. chart.c calls it. See
 * plot.h. */
#include "plot.h"

#include "core/base/trig.h"
#include "core/fragment/cover.h"
#include "core/raster/stroke.h"

struct series warm = {.low = 1500, .high = 2700, .rgb = 0xE8590C, .width_q8 = 640};
struct series wet = {.low = 2000, .high = 8000, .rgb = 0x1C7ED6, .width_q8 = 448};

enum {
    SLICE = 24,
    EDGES = 128
};

static struct etch_smooth_edge edge[EDGES];
static uint32_t taken;  /* samples so far */
static int16_t shifted; /* columns that the newest sample lies beyond the right edge */

static int32_t wave(uint32_t k, uint32_t turns, int32_t height)
{
    return height * (etch_sin_q16((uint16_t)(k * turns)) / 64) / 1024;
}

/* What sensors that are read every half minute say. */
static int16_t sense_warm(uint32_t k)
{
    return (int16_t)(2140 + wave(k, 890, 260) + wave(k, 2310, 110) + wave(k, 5200, 24));
}

static int16_t sense_wet(uint32_t k)
{
    return (int16_t)(4700 - wave(k + 9, 890, 900) + wave(k, 1730, 600) + wave(k, 4100, 220));
}

static void take(struct series *series, int16_t value)
{
    for (int i = 1; i < SAMPLES; i++)
        series->sample[i - 1] = series->sample[i];
    series->sample[SAMPLES - 1] = value;
}

void plot_prepare(uint32_t tick)
{
    const uint32_t newest = tick / STEP + SAMPLES;

    for (taken = tick / STEP; taken < newest; taken++) {
        take(&warm, sense_warm(taken));
        take(&wet, sense_wet(taken));
    }
    shifted = (int16_t)(STEP - tick % STEP);
}

uint32_t plot_newest(void)
{
    return taken;
}

struct etch_point_q8 plot_place(const struct series *series, int i)
{
    const int32_t from_right = (SAMPLES - 1 - i) * STEP - shifted;
    const int32_t up = (int32_t)(series->sample[i] - series->low) * (BOTTOM - TOP) * 256;
    const struct etch_point_q8 p = {(RIGHT - from_right) * INT32_C(256),
                                    BOTTOM * INT32_C(256) - up / (series->high - series->low)};

    return p;
}

/* The points of a series on and around columns x0 .. x1; returns how many. */
static uint16_t points(const struct series *series, int16_t x0, int16_t x1, struct etch_point_q8 *p)
{
    uint16_t n = 0;

    for (int i = 0; i < SAMPLES; i++) {
        const struct etch_point_q8 at = plot_place(series, i);

        if (at.x > (x0 - 2 * STEP) * 256 && at.x < (x1 + 2 * STEP) * 256)
            p[n++] = at;
    }
    return n;
}

static void draw_line(const struct etch_surface *s, const struct series *series,
                      const struct etch_point_q8 *p, uint16_t n)
{
    static const struct etch_cover_flat_paint none = {{PANEL_COVER_FLAT}, 0, 255};
    struct etch_cover_flat_paint paint = none;
    const struct etch_stroke stroke = {series->width_q8, etch_cap_butt, etch_join_bevel, 0};
    struct etch_smooth smooth;
    const struct etch_outline outline = {etch_outline_smooth, &smooth};

    paint.color = color_of(series->rgb);
    etch_smooth_init(&smooth, edge, EDGES);
    etch_smooth_window(&smooth, s);
    etch_stroke_outline(&outline, p, n, false, &stroke);
    etch_smooth_fill_nonzero(s, &smooth, &paint.paint, cover_row);
}

/* Down to the bottom of the plot; p has room for two more. */
static void draw_area(const struct etch_surface *s, struct etch_point_q8 *p, uint16_t n,
                      const struct etch_brush *brush)
{
    const struct etch_cover_brush_paint paint = {{PANEL_COVER_BRUSH}, brush, 255};
    struct etch_smooth smooth;

    p[n] = (struct etch_point_q8){p[n - 1].x, BOTTOM * INT32_C(256)};
    p[n + 1] = (struct etch_point_q8){p[0].x, BOTTOM * INT32_C(256)};
    etch_smooth_init(&smooth, edge, EDGES);
    etch_smooth_window(&smooth, s);
    (void)etch_smooth_add(&smooth, p, (uint16_t)(n + 2)); /* EDGES are enough */
    etch_smooth_fill_nonzero(s, &smooth, &paint.paint, cover_row);
}

void plot_lines(const struct etch_surface *s, const struct etch_brush *brush)
{
    struct etch_point_q8 p[SLICE / STEP + 4 + 2];

    for (int16_t x = LEFT; x < RIGHT; x = (int16_t)(x + SLICE)) {
        const struct etch_rect slice = {
            x, TOP - 4, (int16_t)(x + SLICE < RIGHT ? x + SLICE : RIGHT), BOTTOM - 1};
        struct etch_surface part = *s;

        part.clip = etch_rect_intersect(s->clip, slice);
        if (etch_rect_is_empty(part.clip))
            continue;
        draw_area(&part, p, points(&warm, slice.x0, slice.x1, p), brush);
        draw_line(&part, &wet, p, points(&wet, slice.x0, slice.x1, p));
        draw_line(&part, &warm, p, points(&warm, slice.x0, slice.x1, p));
    }
}

void plot_head(const struct etch_surface *s, const struct series *series)
{
    int i = SAMPLES - 1;
    struct etch_point_q8 a, b;

    while (plot_place(series, i - 1).x > RIGHT * 256)
        i--;
    a = plot_place(series, i - 1);
    b = plot_place(series, i);
    a.y += (b.y - a.y) * (RIGHT * 256 - a.x) / (b.x - a.x);
    a.x = RIGHT * 256;
    disc(s, a, 8 * 16, glass(series->rgb, 50));
    disc(s, a, 5 * 16, solid(0xFFFFFF));
    disc(s, a, 3 * 16 + 8, solid(series->rgb));
}
