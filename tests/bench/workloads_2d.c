/* bench/workloads_2d.c: W1..W5, clear, rectangles, lines, circles and discs. See bench.h. */
#include "bench.h"

#include "../../core/draw/shapes.h"
#include "../../core/raster/circle.h"
#include "../../core/raster/line.h"

static wl_rect rects[WL_NRECT];
static wl_line lines[WL_NLINE];
static wl_circ circles[WL_NCIRC];

static void prepare_nothing(void)
{
}

static void prepare_rects(void)
{
    wl_make_rects(rects);
}

static void prepare_lines(void)
{
    wl_make_lines(lines);
}

static void prepare_circles(void)
{
    wl_make_circles(circles);
}

static void draw_clear(const struct etch_surface *s, uint8_t frame)
{
    (void)frame;
    etch_surface_clear(s, BENCH_CLEAR_COLOR);
}

static void draw_rects(const struct etch_surface *s, uint8_t frame)
{
    (void)frame;
    for (const wl_rect *p = rects; p < rects + WL_NRECT; p++)
        etch_rect_fill(s, p->x, p->y, p->w, p->h, p->c);
}

static void draw_lines(const struct etch_surface *s, uint8_t frame)
{
    (void)frame;
    for (const wl_line *p = lines; p < lines + WL_NLINE; p++)
        etch_line_draw(s, p->x0, p->y0, p->x1, p->y1, p->c);
}

static void draw_circles(const struct etch_surface *s, uint8_t frame)
{
    (void)frame;
    for (const wl_circ *p = circles; p < circles + WL_NCIRC; p++)
        etch_circle_draw(s, p->x, p->y, p->r, p->c);
}

static void draw_discs(const struct etch_surface *s, uint8_t frame)
{
    (void)frame;
    for (const wl_circ *p = circles; p < circles + WL_NCIRC; p++)
        etch_circle_fill(s, p->x, p->y, p->r, p->c);
}

const struct bench_workload bench_w1 = {1, false, prepare_nothing, draw_clear};
const struct bench_workload bench_w2 = {1, false, prepare_rects, draw_rects};
const struct bench_workload bench_w3 = {1, false, prepare_lines, draw_lines};
const struct bench_workload bench_w4 = {1, false, prepare_circles, draw_circles};
const struct bench_workload bench_w5 = {1, false, prepare_circles, draw_discs};
