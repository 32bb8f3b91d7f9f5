/* tests/oracle: familiar shapes, one pixel at a time. tests/unit/familiar.c compares. See gfx.h. */
#include "gfx.h"

static uint16_t expected[48][64];
static struct etch_rect window, clip;

void oracle_gfx_open(struct etch_rect whole, struct etch_rect part, uint16_t background)
{
    window = whole;
    clip = part;
    for (int j = 0; j < 48; j++)
        for (int i = 0; i < 64; i++)
            expected[j][i] = background;
}

uint16_t oracle_gfx_at(int32_t x, int32_t y)
{
    return expected[y - window.y0][x - window.x0];
}

void oracle_gfx_pixel(int32_t x, int32_t y, uint16_t color)
{
    if (x >= clip.x0 && x < clip.x1 && y >= clip.y0 && y < clip.y1)
        expected[y - window.y0][x - window.x0] = color;
}

/* Along the longer axis from the end where it is smaller; the error starts at half of that axis,
 * rounded down, and a step across is taken when it falls below 0. */
void oracle_gfx_line(int32_t x0, int32_t y0, int32_t x1, int32_t y1, uint16_t color)
{
    const int32_t wide = x1 < x0 ? x0 - x1 : x1 - x0, high = y1 < y0 ? y0 - y1 : y1 - y0;
    const bool steep = high > wide;
    const int32_t a = steep ? y0 : x0, b = steep ? y1 : x1;
    const int32_t from = a < b ? a : b, to = a < b ? b : a;
    const int32_t start = steep ? (a < b ? x0 : x1) : (a < b ? y0 : y1);
    const int32_t end = steep ? (a < b ? x1 : x0) : (a < b ? y1 : y0);
    int32_t across = start, error = (to - from) / 2;

    for (int32_t along = from; along <= to; along++) {
        oracle_gfx_pixel(steep ? across : along, steep ? along : across, color);
        error -= start < end ? end - start : start - end;
        if (error < 0) {
            across += start < end ? 1 : -1;
            error += to - from;
        }
    }
}

static int32_t most(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

void oracle_gfx_fill_rect(int32_t x, int32_t y, int32_t w, int32_t h, uint16_t color)
{
    for (int32_t j = most(y, clip.y0); j < y + h && j < clip.y1; j++)
        for (int32_t i = most(x, clip.x0); i < x + w && i < clip.x1; i++)
            oracle_gfx_pixel(i, j, color);
}

/* How high the circle of radius r is in column x >= 0 from its middle: the midpoint circle's
 * octant, and its mirror image. `outer` chooses the outermost pixel of a column, else the
 * innermost. */
static int32_t column(int32_t r, int32_t x)
{
    int32_t a = 0, b = r, found = -1;

    for (;;) {
        if (a == x)
            found = most(found, b);
        if (b == x)
            found = most(found, a);
        if (a >= b)
            return found;
        /* The point (a + 1, b - 1/2) outside the circle: the next row. */
        a++;
        if (4 * a * a + (2 * b - 1) * (2 * b - 1) > 4 * r * r)
            b--;
    }
}

static void plot_octants(int32_t x, int32_t y, int32_t a, int32_t b, uint16_t color)
{
    for (int turn = 0; turn < 4; turn++) {
        const int32_t u = (turn & 1) != 0 ? -a : a, v = (turn & 2) != 0 ? -b : b;

        oracle_gfx_pixel(x + u, y + v, color);
        oracle_gfx_pixel(x + v, y + u, color);
    }
}

void oracle_gfx_circle(int32_t x, int32_t y, int32_t r, uint16_t color)
{
    int32_t b = r;

    for (int32_t a = 0; a <= b; a++) {
        plot_octants(x, y, a, b, color);
        if (4 * (a + 1) * (a + 1) + (2 * b - 1) * (2 * b - 1) > 4 * r * r)
            b--;
    }
}

void oracle_gfx_disc(int32_t x, int32_t y, int32_t r, uint16_t color)
{
    for (int32_t i = -r; i <= r; i++) {
        const int32_t high = column(r, i < 0 ? -i : i);

        oracle_gfx_fill_rect(x + i, y - high, 1, 2 * high + 1, color);
    }
}

static int32_t radius(int32_t w, int32_t h, int32_t r)
{
    const int32_t half = (w < h ? w : h) / 2;

    return r < 0 ? 0 : r > half ? half : r;
}

/* Quarters of circles, without the pixels of their axes. */
static void plot_quarter(int32_t x, int32_t y, int32_t r, int32_t dx, int32_t dy, uint16_t color)
{
    int32_t b = r;

    for (int32_t a = 0; a <= b; a++) {
        if (a > 0) {
            oracle_gfx_pixel(x + dx * a, y + dy * b, color);
            oracle_gfx_pixel(x + dx * b, y + dy * a, color);
        }
        if (4 * (a + 1) * (a + 1) + (2 * b - 1) * (2 * b - 1) > 4 * r * r)
            b--;
    }
}

void oracle_gfx_round_rect(int32_t x, int32_t y, int32_t w, int32_t h, int32_t r, uint16_t color)
{
    if (w <= 0 || h <= 0)
        return;
    r = radius(w, h, r);
    oracle_gfx_fill_rect(x + r, y, w - 2 * r, 1, color);
    oracle_gfx_fill_rect(x + r, y + h - 1, w - 2 * r, 1, color);
    oracle_gfx_fill_rect(x, y + r, 1, h - 2 * r, color);
    oracle_gfx_fill_rect(x + w - 1, y + r, 1, h - 2 * r, color);
    if (r == 0)
        return;
    plot_quarter(x + r, y + r, r, -1, -1, color);
    plot_quarter(x + w - r - 1, y + r, r, 1, -1, color);
    plot_quarter(x + r, y + h - r - 1, r, -1, 1, color);
    plot_quarter(x + w - r - 1, y + h - r - 1, r, 1, 1, color);
}

/* Columns of discs, taller by the straight part. */
void oracle_gfx_fill_round_rect(int32_t x, int32_t y, int32_t w, int32_t h, int32_t r,
                                uint16_t color)
{
    if (w <= 0 || h <= 0)
        return;
    r = radius(w, h, r);
    oracle_gfx_fill_rect(x + r, y, w - 2 * r, h, color);
    for (int32_t i = 1; i <= r; i++) {
        const int32_t high = column(r, i), tall = 2 * high + h - 2 * r;

        oracle_gfx_fill_rect(x + r - i, y + r - high, 1, tall, color);
        oracle_gfx_fill_rect(x + w - 1 - r + i, y + r - high, 1, tall, color);
    }
}

static int32_t edge_at(const int32_t *a, const int32_t *b, int32_t y)
{
    return a[0] + (int32_t)((int64_t)(b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]));
}

void oracle_gfx_fill_triangle(int32_t x0, int32_t y0, int32_t x1, int32_t y1, int32_t x2,
                              int32_t y2, uint16_t color)
{
    const int32_t corner[3][2] = {{x0, y0}, {x1, y1}, {x2, y2}};
    const int32_t *v[3] = {corner[0], corner[1], corner[2]};

    for (int pass = 0; pass < 3; pass++) {
        const int k = pass == 1 ? 1 : 0;

        if (v[k][1] > v[k + 1][1]) {
            const int32_t *const kept = v[k];

            v[k] = v[k + 1];
            v[k + 1] = kept;
        }
    }
    for (int32_t y = clip.y0; y < clip.y1; y++) {
        int32_t a, b;

        if (y < v[0][1] || y > v[2][1])
            continue;
        if (v[0][1] == v[2][1]) {
            a = -most(most(-v[0][0], -v[1][0]), -v[2][0]);
            b = most(most(v[0][0], v[1][0]), v[2][0]);
        } else {
            /* The lower half has the row of the middle corner, unless its edge is level. */
            const bool lower = y >= v[1][1] && v[1][1] != v[2][1];

            a = lower ? edge_at(v[1], v[2], y) : edge_at(v[0], v[1], y);
            b = edge_at(v[0], v[2], y);
        }
        oracle_gfx_fill_rect(a < b ? a : b, y, (a < b ? b - a : a - b) + 1, 1, color);
    }
}
