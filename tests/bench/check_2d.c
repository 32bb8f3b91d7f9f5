/* bench/check_2d.c: W1..W5 by their definitions. See check.h. */
#include <stdlib.h>

#include "bench.h"
#include "check.h"

static void put(struct check *c, int x, int y, uint16_t color)
{
    if (x < 0 || x >= WL_W || y < 0 || y >= WL_H)
        return;
    struct expected *e = &c->expected[y][x];
    e->drawn = true;
    e->channel[0] = (color >> 11) * 65536;
    e->channel[1] = (color >> 5 & 63) * 65536;
    e->channel[2] = (color & 31) * 65536;
    c->pixels++;
}

static void rectangle(struct check *c, int x, int y, int w, int h, uint16_t color)
{
    for (int j = y; j < y + h; j++)
        for (int i = x; i < x + w; i++)
            put(c, i, j, color);
}

/* From the end with the smaller major coordinate; a tie stays on that side. */
static void line(struct check *c, const wl_line *p)
{
    const bool steep = abs(p->y1 - p->y0) > abs(p->x1 - p->x0);
    const int a0 = steep ? p->y0 : p->x0, b0 = steep ? p->x0 : p->y0;
    const int a1 = steep ? p->y1 : p->x1, b1 = steep ? p->x1 : p->y1;
    const int from = a0 <= a1 ? a0 : a1, base = a0 <= a1 ? b0 : b1, far = a0 <= a1 ? b1 : b0;
    const int major = abs(a1 - a0), minor = abs(b1 - b0);

    for (int k = 0; k <= major; k++) {
        const int m = major == 0 ? 0 : (2 * k * minor + major - 1) / (2 * major);
        const int a = from + k, b = far >= base ? base + m : base - m;
        put(c, steep ? b : a, steep ? a : b, p->c);
    }
}

/* round(sqrt(n)); there are no ties. */
static int nearest_root(int n)
{
    int y = 0;

    while (y * y + y < n)
        y++;
    return y;
}

static void circle(struct check *c, const wl_circ *p, bool filled)
{
    int extent[101] = {0}; /* of row +-y: the outermost pixel of the outline */
    static bool on[101][101];

    for (int y = 0; y <= p->r; y++)
        for (int x = 0; x <= p->r; x++)
            on[y][x] = false;
    for (int x = 0; x <= p->r; x++) {
        const int y = nearest_root(p->r * p->r - x * x);
        if (x <= y) {
            on[y][x] = on[x][y] = true;
            extent[y] = extent[y] > x ? extent[y] : x;
            extent[x] = extent[x] > y ? extent[x] : y;
        }
    }
    for (int y = -p->r; y <= p->r; y++)
        for (int x = -p->r; x <= p->r; x++)
            if (filled ? abs(x) <= extent[abs(y)] : on[abs(y)][abs(x)])
                put(c, p->x + x, p->y + y, p->c);
}

void check_2d(struct check *c, int workload)
{
    static wl_rect rects[WL_NRECT];
    static wl_line lines[WL_NLINE];
    static wl_circ circles[WL_NCIRC];

    wl_make_rects(rects);
    wl_make_lines(lines);
    wl_make_circles(circles);
    switch (workload) {
    case WL_CLEAR:
        c->primitives = 1;
        rectangle(c, 0, 0, WL_W, WL_H, BENCH_CLEAR_COLOR);
        break;
    case WL_RECT:
        c->primitives = WL_NRECT;
        for (const wl_rect *p = rects; p < rects + WL_NRECT; p++)
            rectangle(c, p->x, p->y, p->w, p->h, p->c);
        break;
    case WL_LINE:
        c->primitives = WL_NLINE;
        for (const wl_line *p = lines; p < lines + WL_NLINE; p++)
            line(c, p);
        break;
    default:
        c->primitives = WL_NCIRC;
        for (const wl_circ *p = circles; p < circles + WL_NCIRC; p++)
            circle(c, p, workload == WL_DISC);
    }
}
