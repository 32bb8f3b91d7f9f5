/* tests/unit: what the tests of panels share: a picture, what each panel must show of it, and a
 * frame through the frame loop. */
#ifndef TESTS_PANEL_PARTS_H
#define TESTS_PANEL_PARTS_H

#include "core/draw/shapes.h"
#include "core/raster/circle.h"
#include "core/raster/line.h"
#include "hal/frame.h"
#include "ports/host/panel_port.h"
#include "tests/harness/harness.h"

enum {
    PANEL_MOST = 480 * 320
};

/* Draws picture `number` on a strip in byte order `format`: a pattern without symmetry, and
 * shapes across the strips' borders. */
static inline void panel_picture(struct etch_surface *s, uint8_t format, int number)
{
    const bool swapped = format == ETCH_FORMAT_RGB565_SWAPPED;
    const uint16_t red = swapped ? 0x00F8 : 0xF800, blue = swapped ? 0x1F00 : 0x001F;

    for (int16_t y = s->window.y0; y < s->window.y1; y++) {
        for (int16_t x = s->window.x0; x < s->window.x1; x++) {
            const uint16_t c = (uint16_t)((uint32_t)x * 263 + (uint32_t)y * 41 +
                                          (uint32_t)number * 4099);

            s->pixels[etch_surface_index(s, x, y)] = swapped ? etch_rgb565_swap(c) : c;
        }
    }
    etch_circle_fill(s, 30, 40, 25, red);
    etch_line_draw(s, -5, 3, 200, 70, blue);
    etch_rect_fill(s, 60, 9, 11, 30, (uint16_t)0xFFFF);
}

/* One frame of picture `number`, in strips of up to `rows` rows; the loop's status. */
static inline int panel_frame(struct etch_panel_port *port, int number, int rows, int buffers)
{
    static uint16_t buffer[2][PANEL_MOST];
    const struct etch_display *d = &port->lcd.display;
    const struct etch_frame_memory memory = {.pixels = {buffer[0], buffers == 2 ? buffer[1] : NULL},
                                             .size = (uint32_t)rows * (uint32_t)d->width};
    struct etch_frame frame;
    int status = etch_frame_init(&frame, d, memory);

    if (status < 0)
        return status;
    for (struct etch_surface *s = etch_frame_begin(&frame); s != NULL; s = etch_frame_next(&frame))
        panel_picture(s, d->format, number);
    return etch_frame_end(&frame);
}

/* Bayer's matrix by its definition: M(2n) = 4 M(n) + the 2 x 2 cell {0 2, 3 1}. */
static inline int panel_bayer(int n, int x, int y)
{
    static const int cell[2][2] = {{0, 2}, {3, 1}};

    return n == 1 ? 0
                  : 4 * panel_bayer(n / 2, x % (n / 2), y % (n / 2)) +
                        cell[y / (n / 2) & 1][x / (n / 2) & 1];
}

/* What a panel shows, 0xRRGGBB, of a pixel rrrrrggggggbbbbb at (x, y) of the frame. */
static inline uint32_t panel_expected(const struct etch_panel_type *type, uint16_t color, int x,
                                      int y)
{
    uint32_t r = color >> 11, g = color >> 5 & 63, b = color & 31, light;
    int levels = 0;

    g = g << 2 | g >> 4;
    if (type->only_rgb666) { /* 5 bits to 6, then 6 to 8 */
        r = r << 1 | r >> 4, b = b << 1 | b >> 4;
        return (r << 2 | r >> 4) << 16 | g << 8 | (b << 2 | b >> 4);
    }
    r = r << 3 | r >> 2, b = b << 3 | b >> 2;
    levels = type->family == ETCH_PANEL_SSD1306 ? 1 : type->family == ETCH_PANEL_SSD0323 ? 15 : 0;
    if (levels == 0)
        return r << 16 | g << 8 | b;
    light = (77 * r + 150 * g + 29 * b) / 256;
    light = (light * (uint32_t)levels + (uint32_t)panel_bayer(8, x % 8, y % 8) * 4 + 2) / 255;
    return light * (levels == 1 ? 0xFFFFFF : 0x111111);
}

/* Checks that the viewer sees picture `number`, and that nothing was illegal. */
static inline void panel_check(const struct etch_panel_port *port, int number)
{
    static uint16_t picture[PANEL_MOST];
    const struct etch_display *d = &port->lcd.display;
    const struct etch_rect all = {0, 0, d->width, d->height};
    const uint16_t *p = picture;
    struct etch_surface s;

    if (!CHECK(port->panel.error[0] == 0)) {
        test_print(port->panel.type->name);
        test_print(port->panel.error);
    }
    CHECK_EQ(etch_surface_init(&s, picture, all, (uint16_t)d->width), ETCH_OK);
    panel_picture(&s, ETCH_FORMAT_RGB565, number);
    for (int y = 0; y < d->height && !test_failed(); y++) {
        for (int x = 0; x < d->width; x++, p++) {
            const uint32_t seen = etch_panel_view(&port->panel, port->turn, x, y);

            if (seen != panel_expected(port->panel.type, *p, x, y)) {
                CHECK_EQ(seen, panel_expected(port->panel.type, *p, x, y));
                test_print(port->panel.type->name);
                test_note("turn", port->turn);
                test_note("x", x);
                test_note("y", y);
                return;
            }
        }
    }
}

#endif
