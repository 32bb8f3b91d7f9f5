/* tests/exhaustive: every line and circle of a small grid under every clip rectangle. See grid.h.
 */
#include "core/etch.h"
#include "core/draw/shapes_small.h"
#include "core/raster/line_small.h"
#include "grid.h"
#include "tests/oracle/circle.h"
#include "tests/oracle/line.h"

enum {
    SIDE = 12,
    RECTS = SIDE * (SIDE + 1) / 2,
    PIXELS = SIDE * SIDE
};

/* Shape number n: how it is drawn, and which pixels it has. */
typedef void draw_function(const struct etch_surface *s, int64_t n);
typedef bool covers_function(int64_t n, int x, int y);

static void wipe(uint16_t pixels[PIXELS])
{
    for (int i = 0; i < PIXELS; i++)
        pixels[i] = 0;
}

/* from[r], to[r]: the r-th interval of 0 .. SIDE that is not empty. */
static void intervals(int16_t from[RECTS], int16_t to[RECTS])
{
    int n = 0;

    for (int a = 0; a < SIDE; a++)
        for (int b = a + 1; b <= SIDE; b++, n++)
            from[n] = (int16_t)a, to[n] = (int16_t)b;
}

static void define(uint16_t pixels[PIXELS], covers_function *covers, int64_t shape)
{
    for (int i = 0; i < PIXELS; i++)
        pixels[i] = covers(shape, i % SIDE, i / SIDE);
}

static bool is_masked(const uint16_t *clipped, const uint16_t *whole, struct etch_rect c)
{
    for (int y = 0, i = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++, i++)
            if (clipped[i] != (x >= c.x0 && x < c.x1 && y >= c.y0 && y < c.y1 ? whole[i] : 0))
                return false;
    return true;
}

static struct grid_count shapes(int64_t all, int64_t first, int64_t step, draw_function *draw,
                                covers_function *covers)
{
    struct grid_count count = {0, 0};
    uint16_t whole[PIXELS], clipped[PIXELS];
    int16_t from[RECTS], to[RECTS];
    int64_t defined = -1;
    struct etch_surface s;

    intervals(from, to);
    (void)etch_surface_init(&s, clipped, (struct etch_rect){0, 0, SIDE, SIDE}, SIDE);
    for (int64_t n = first; n < all * RECTS * RECTS; n += step) {
        const int x = (int)(n % RECTS), y = (int)(n / RECTS % RECTS);
        const int64_t shape = n / RECTS / RECTS;

        if (shape != defined)
            define(whole, covers, shape);
        defined = shape;
        s.clip = (struct etch_rect){from[x], from[y], to[x], to[y]};
        wipe(clipped);
        draw(&s, shape);
        count.tried++;
        count.wrong += !is_masked(clipped, whole, s.clip);
    }
    return count;
}

/* ---- lines: two pixels, fast or small ---------------------------------------------------------
 */

struct ends {
    int16_t x0, y0, x1, y1;
};

static struct ends ends_of(int64_t n)
{
    const int a = (int)(n / 2 % PIXELS), b = (int)(n / 2 / PIXELS);

    return (struct ends){(int16_t)(a % SIDE), (int16_t)(a / SIDE), (int16_t)(b % SIDE),
                         (int16_t)(b / SIDE)};
}

static void draw_line(const struct etch_surface *s, int64_t n)
{
    const struct ends e = ends_of(n);

    if (n % 2 == 0)
        etch_line_draw(s, e.x0, e.y0, e.x1, e.y1, 1);
    else
        etch_line_draw_small(s, e.x0, e.y0, e.x1, e.y1, 1);
}

static bool line_covers(int64_t n, int x, int y)
{
    const struct ends e = ends_of(n);

    return oracle_line_covers(e.x0, e.y0, e.x1, e.y1, x, y);
}

struct grid_count grid_lines(int64_t first, int64_t step)
{
    return shapes((int64_t)2 * PIXELS * PIXELS, first, step, draw_line, line_covers);
}

/* ---- circles: a centre and a radius, fast, small or filled -------------------------------------
 */

struct round {
    int16_t x, y, r;
};

static struct round round_of(int64_t n)
{
    const int centre = (int)(n / 3 % PIXELS);

    return (struct round){(int16_t)(centre % SIDE), (int16_t)(centre / SIDE),
                          (int16_t)(n / 3 / PIXELS - 1)};
}

static void draw_circle(const struct etch_surface *s, int64_t n)
{
    const struct round c = round_of(n);

    if (n % 3 == 0)
        etch_circle_draw(s, c.x, c.y, c.r, 1);
    else if (n % 3 == 1)
        etch_circle_draw_small(s, c.x, c.y, c.r, 1);
    else
        etch_circle_fill(s, c.x, c.y, c.r, 1);
}

static bool circle_covers(int64_t n, int x, int y)
{
    const struct round c = round_of(n);

    return n % 3 == 2 ? oracle_disc_covers(c.r, x - c.x, y - c.y)
                      : oracle_circle_covers(c.r, x - c.x, y - c.y);
}

struct grid_count grid_circles(int64_t first, int64_t step)
{
    return shapes((int64_t)3 * 9 * PIXELS, first, step, draw_circle, circle_covers);
}
