/* tests/product: shapes and text in one colour; every screen calls these. See parts.h. */
#include "parts.h"

#include "core/base/trig.h"
#include "core/draw/shapes.h"
#include "core/fragment/blend_fused.h"
#include "core/fragment/cover.h"
#include "core/raster/rect.h"
#include "product.h"

int16_t cover_row[PRODUCT_WIDTH + 1];

uint16_t color_of(uint32_t rgb)
{
    return etch_rgb565((uint8_t)(rgb >> 16), (uint8_t)(rgb >> 8), (uint8_t)rgb);
}

static struct etch_cover_flat_paint paint_of(struct ink ink)
{
    const struct etch_cover_flat_paint paint = {{PANEL_COVER_FLAT}, color_of(ink.rgb), ink.opacity};

    return paint;
}

struct etch_point_q8 polar(int16_t cx, int16_t cy, int32_t radius_q4, uint16_t angle)
{
    /* |radius| < 2^12, so products are below 2^29; 16ths times 16 are 256ths. */
    const int32_t x = radius_q4 * (etch_cos_q16(angle) / 4) / 1024;
    const int32_t y = radius_q4 * (etch_sin_q16(angle) / 4) / 1024;
    struct etch_point_q8 p = etch_pixel_q8(cx, cy);

    p.x += x;
    p.y += y;
    return p;
}

void fill_all(const struct etch_surface *s, uint32_t rgb)
{
    etch_surface_clear(s, PANEL_SWAP(color_of(rgb)));
}

void disc(const struct etch_surface *s, struct etch_point_q8 centre, int32_t radius_q4,
          struct ink ink)
{
    const struct etch_cover_flat_paint paint = paint_of(ink);

    etch_smooth_disc(s, centre, radius_q4 * 16, &paint.paint, cover_row);
}

void ring(const struct etch_surface *s, struct etch_point_q8 centre, int32_t outer_q4,
          int32_t inner_q4, struct ink ink)
{
    const struct etch_cover_flat_paint paint = paint_of(ink);

    etch_smooth_ring(s, centre, outer_q4 * 16, inner_q4 * 16, &paint.paint, cover_row);
}

void arc(const struct etch_surface *s, struct etch_point_q8 centre, int32_t outer_q4,
         int32_t inner_q4, uint16_t from, uint32_t sweep, struct ink ink)
{
    const struct etch_cover_flat_paint paint = paint_of(ink);

    etch_smooth_arc(s, centre, outer_q4 * 16, inner_q4 * 16, from, sweep, &paint.paint, cover_row);
}

void line(const struct etch_surface *s, struct etch_point_q8 a, struct etch_point_q8 b,
          int32_t width_q4, struct ink ink)
{
    const struct etch_cover_flat_paint paint = paint_of(ink);

    etch_smooth_line_round(s, a, b, width_q4 * 16, &paint.paint, cover_row);
}

/* Whole pixels: the same colours as covers of 4096 give, in far less time. */
static void fill(const struct etch_surface *s, struct etch_rect r, struct ink ink)
{
    struct etch_flat_blend_paint paint;

    if (ink.opacity == 255) {
        etch_rect_fill(s, r.x0, r.y0, (int16_t)(r.x1 - r.x0), (int16_t)(r.y1 - r.y0),
                       PANEL_SWAP(color_of(ink.rgb)));
        return;
    }
    etch_flat_blend_init(&paint, PANEL_FLAT_BLEND, color_of(ink.rgb), ink.opacity);
    etch_rect_runs(s, r, &paint.paint);
}

/* The rows of r from y0 to y1, with its round corners. */
static void round_rows(const struct etch_surface *s, struct etch_rect r, int16_t radius, int16_t y0,
                       int16_t y1, const struct etch_cover_paint *paint)
{
    const struct etch_rect rows = {r.x0, y0, r.x1, y1};
    struct etch_surface part = *s;

    part.clip = etch_rect_intersect(s->clip, rows);
    if (!etch_rect_is_empty(part.clip))
        etch_smooth_round_rect(&part, corner(r.x0, r.y0), corner(r.x1, r.y1), radius * INT32_C(256),
                               paint, cover_row);
}

void box(const struct etch_surface *s, struct etch_rect r, int16_t radius, struct ink ink)
{
    const struct etch_cover_flat_paint paint = paint_of(ink);
    const struct etch_rect middle = {r.x0, (int16_t)(r.y0 + radius), r.x1,
                                     (int16_t)(r.y1 - radius)};

    round_rows(s, r, radius, r.y0, middle.y0, &paint.paint);
    fill(s, middle, ink);
    round_rows(s, r, radius, middle.y1, r.y1, &paint.paint);
}

void border(const struct etch_surface *s, struct etch_rect r, int16_t radius, int32_t width_q4,
            struct ink ink)
{
    const struct etch_cover_flat_paint paint = paint_of(ink);

    etch_smooth_round_frame(s, corner(r.x0, r.y0), corner(r.x1, r.y1), radius * INT32_C(256),
                            width_q4 * 16, &paint.paint, cover_row);
}

void shape(const struct etch_surface *s, const struct etch_point_q8 *v, uint16_t n, struct ink ink)
{
    const struct etch_cover_flat_paint paint = paint_of(ink);
    struct etch_smooth_edge edge[8];

    (void)etch_smooth_polygon(s, v, n, edge, 8, &paint.paint, cover_row); /* n <= 8: fits */
}

void text(const struct etch_surface *s, const struct etch_font *font, uint32_t rgb, int16_t x,
          int16_t y, enum etch_align align, const char *string)
{
    const struct etch_text_style style = {font, PANEL_GLYPH, PANEL_SWAP(color_of(rgb)), 0};

    (void)etch_text_draw_aligned(s, &style, x, y, align, string, NULL);
}

char *number(char to[24], int32_t value, uint8_t decimals, const char *unit)
{
    uint32_t left = value < 0 ? (uint32_t)-value : (uint32_t)value;
    char backwards[16];
    uint8_t n = 0, out = 0;

    for (uint8_t digits = 0; left != 0 || digits <= decimals; digits++) {
        if (digits == decimals && decimals != 0)
            backwards[n++] = '.';
        if (digits > decimals && (digits - decimals) % 3 == 0)
            backwards[n++] = ' ';
        backwards[n++] = (char)('0' + left % 10);
        left /= 10;
    }
    if (value < 0)
        to[out++] = '-';
    while (n != 0)
        to[out++] = backwards[--n];
    while (*unit != '\0' && out < 23)
        to[out++] = *unit++;
    to[out] = '\0';
    return to;
}
