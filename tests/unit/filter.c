/* tests/unit: passes that look at neighbours, against plain loops over the whole picture: 3 x 3
 * filters by convolution, edge smoothing by the four steps of its header; in strips of every
 * height, in any order and in parts of the frame. */
#include "core/base/rgb565.h"
#include "core/frame/filter.h"
#include "core/frame/smooth.h"
#include "tests/harness/canvas.h"

void suite_filter(void);

enum {
    WIDTH = 40,
    HEIGHT = 32,
    ROWS = 2
};

static const struct etch_rect frame = {0, 0, WIDTH, HEIGHT};
static uint16_t picture[WIDTH * HEIGHT], expected[WIDTH * HEIGHT];
static struct test_canvas canvas;

static int32_t hold(int32_t v, int32_t least, int32_t most)
{
    return v < least ? least : v > most ? most : v;
}

static uint16_t at(int32_t x, int32_t y)
{
    return picture[hold(y, 0, HEIGHT - 1) * WIDTH + hold(x, 0, WIDTH - 1)];
}

static int32_t channel(uint16_t color, int32_t i)
{
    return i == 0 ? color >> 11 : i == 1 ? color >> 5 & 63 : color & 31;
}

static uint16_t pack(const int32_t c[3])
{
    return (uint16_t)(c[0] << 11 | c[1] << 5 | c[2]);
}

/* floor(n / d) */
static int32_t floor_divide(int32_t n, int32_t d)
{
    return n >= 0 ? n / d : -((d - 1 - n) / d);
}

/* ---- what is expected
 * ---------------------------------------------------------------------------- */

static uint16_t convolved(const struct etch_filter_weights *w, int32_t x, int32_t y)
{
    int32_t c[3], i, k;

    for (i = 0; i < 3; i++) {
        const int32_t most = i == 1 ? 63 : 31, d = w->divisor == 0 ? 1 : w->divisor;
        const int32_t bias = floor_divide(2 * w->bias * most + 255, 510);
        int32_t sum = 0;

        for (k = 0; k < 9; k++)
            sum += w->weight[k] * channel(at(x + k % 3 - 1, y + k / 3 - 1), i);
        c[i] = hold(floor_divide(2 * (sum + bias * d) + d, 2 * d), 0, most);
    }
    return pack(c);
}

static uint16_t edges(int32_t x, int32_t y)
{
    static const int8_t gx[9] = {-1, 0, 1, -2, 0, 2, -1, 0, 1};
    int32_t c[3], i, k;

    for (i = 0; i < 3; i++) {
        int32_t across = 0, down = 0;

        for (k = 0; k < 9; k++) {
            across += gx[k] * channel(at(x + k % 3 - 1, y + k / 3 - 1), i);
            down += gx[k] * channel(at(x + k / 3 - 1, y + k % 3 - 1), i);
        }
        across = across < 0 ? -across : across;
        down = down < 0 ? -down : down;
        c[i] = hold((across + down + 2) / 4, 0, i == 1 ? 63 : 31);
    }
    return pack(c);
}

static int32_t luma(int32_t x, int32_t y)
{
    const uint16_t c = at(x, y);

    return 5 * (channel(c, 0) + channel(c, 1)) + 2 * channel(c, 2);
}

static int32_t size_of(int32_t v)
{
    return v < 0 ? -v : v;
}

/* |second difference| down or across, at column or row offset k. */
static int32_t bend(int32_t x, int32_t y, int32_t dx, int32_t dy)
{
    return size_of(luma(x - dx, y - dy) + luma(x + dx, y + dy) - 2 * luma(x, y));
}

static uint16_t smoothed(int32_t x, int32_t y)
{
    const int32_t near[5] = {luma(x, y), luma(x, y - 1), luma(x, y + 1), luma(x - 1, y),
                             luma(x + 1, y)};
    int32_t least = near[0], most = near[0], i, side, step, length[2], turn[2], c[3];

    for (i = 0; i < 5; i++) {
        least = near[i] < least ? near[i] : least;
        most = near[i] > most ? near[i] : most;
    }
    if (most - least < 24 || most - least < most / 8)
        return at(x, y);

    const bool row = bend(x - 1, y, 0, 1) + 2 * bend(x, y, 0, 1) + bend(x + 1, y, 0, 1) >=
                     bend(x, y - 1, 1, 0) + 2 * bend(x, y, 1, 0) + bend(x, y + 1, 1, 0);
    const int32_t before = row ? near[1] : near[3], after = row ? near[2] : near[4];

    side = size_of(before - near[0]) >= size_of(after - near[0]) ? -1 : 1;
    step = (side < 0 ? before : after) - near[0];
    if (step == 0)
        return at(x, y);
    for (i = 0; i < 2; i++) {
        const int32_t reach = row ? ETCH_SMOOTH_COLUMNS : ROWS, way = i == 0 ? -1 : 1;
        int32_t k;

        turn[i] = 0;
        for (k = 1; k <= reach; k++) {
            const int32_t sum = row ? luma(x + way * k, y) + luma(x + way * k, y + side)
                                    : luma(x, y + way * k) + luma(x + side, y + way * k);
            const int32_t change = sum - (2 * near[0] + step);

            if (2 * size_of(change) >= size_of(step)) {
                turn[i] = change;
                break;
            }
        }
        length[i] = k;
    }
    i = length[0] <= length[1] ? 0 : 1;
    if (turn[i] == 0 || (turn[i] < 0) != (step < 0))
        return at(x, y);

    const int32_t whole = length[0] + length[1] - 1, part = whole - 2 * length[i] + 1;
    const uint16_t other = row ? at(x, y + side) : at(x + side, y);

    for (i = 0; i < 3; i++) {
        const int32_t from = channel(at(x, y), i), to = channel(other, i);

        /* from + (to - from) part / (2 whole), half up */
        c[i] = floor_divide(2 * (2 * whole * from + (to - from) * part) + 2 * whole, 4 * whole);
    }
    return pack(c);
}

/* ---- pictures
 * ------------------------------------------------------------------------------------ */

/* Noise, noise of few colours, or areas with slanted edges, all seeded. */
static void make_picture(int32_t kind, uint32_t *seed)
{
    const int32_t a = test_range(seed, -9, 9), b = test_range(seed, -9, 9);
    const int32_t c = test_range(seed, -200, 200);
    const uint16_t ink = (uint16_t)(test_random(seed) >> 16);
    int32_t i;

    for (i = 0; i < WIDTH * HEIGHT; i++) {
        const bool inside = a * (i % WIDTH) + b * (i / WIDTH) + c > 0;
        const uint32_t noise = test_random(seed) >> 16;

        picture[i] = kind == 0   ? (uint16_t)noise
                     : kind == 1 ? (uint16_t)(noise & 0x8410)
                     : kind == 2 ? (uint16_t)((noise & 1) * 0xFFFF)
                                 : (uint16_t)(inside ? ink : ~ink & 0xFFFF);
    }
}

/* ---- the passes, behind one face
 * ----------------------------------------------------------------- */

struct pass {
    int32_t kind; /* 0 any kernel, 1 average, 2 Sobel, 3 smoothing */
    bool swapped;
    struct etch_filter_weights weights;
};

static void run_pass(const struct pass *p, struct etch_carry *c, const struct etch_surface *source,
                     const struct etch_surface *strip)
{
    if (p->kind == 0)
        (p->swapped ? etch_filter_draw_swapped : etch_filter_draw)(c, source, strip, &p->weights);
    else if (p->kind == 1)
        (p->swapped ? etch_filter_average_swapped : etch_filter_average)(c, source, strip);
    else if (p->kind == 2)
        (p->swapped ? etch_filter_sobel_swapped : etch_filter_sobel)(c, source, strip);
    else
        (p->swapped ? etch_smooth_draw_swapped : etch_smooth_draw)(c, source, strip);
}

static void make_expected(const struct pass *p)
{
    static const struct etch_filter_weights nine = {{1, 1, 1, 1, 1, 1, 1, 1, 1}, 9, 0};
    int32_t i;

    for (i = 0; i < WIDTH * HEIGHT; i++) {
        const int32_t x = i % WIDTH, y = i / WIDTH;
        const uint16_t color = p->kind == 0   ? convolved(&p->weights, x, y)
                               : p->kind == 1 ? convolved(&nine, x, y)
                               : p->kind == 2 ? edges(x, y)
                                              : smoothed(x, y);

        expected[i] = p->swapped ? etch_rgb565_swap(color) : color;
    }
}

static void make_pass(struct pass *p, int32_t n, uint32_t *seed)
{
    static const struct etch_filter_weights *const named[] = {
        &etch_filter_weights_average, &etch_filter_weights_blur,   &etch_filter_weights_sharpen,
        &etch_filter_weights_laplace, &etch_filter_weights_emboss, &etch_filter_weights_identity};
    int32_t i;

    p->kind = n % 4;
    p->swapped = n % 8 >= 4;
    p->weights = *named[test_range(seed, 0, 5)];
    if (n % 3 == 0) {
        p->weights.divisor = (uint8_t)test_range(seed, 0, n % 2 == 0 ? 20 : 255);
        p->weights.bias = (int16_t)test_range(seed, -255, 255);
        for (i = 0; i < 9; i++)
            p->weights.weight[i] = (int8_t)(n % 9 == 0 ? test_range(seed, 0, 1) * 255 - 128
                                                       : test_range(seed, -20, 20));
    }
}

static uint16_t kept[2 * ROWS * WIDTH], source_pixels[WIDTH * HEIGHT];
static int64_t rows_drawn; /* elements that sources were asked for */

static void open_carry(struct etch_carry *c, const struct pass *p, struct etch_surface *source)
{
    const bool smooth = p->kind == 3;

    CHECK_EQ(etch_carry_init(c, kept, frame, smooth ? ROWS : 1, smooth ? ETCH_SMOOTH_COLUMNS : 1),
             ETCH_OK);
    CHECK_EQ(etch_surface_init(source, source_pixels, frame, WIDTH), ETCH_OK);
}

/* Draws one strip or area, and compares it. */
static bool draw_area(const struct pass *p, struct etch_carry *c, struct etch_surface *source,
                      struct etch_rect area, struct etch_rect inside)
{
    int32_t x, y;
    bool same = true;

    test_canvas_open(&canvas, area);
    test_canvas_clip(&canvas, inside);
    if (etch_carry_begin(c, &canvas.surface, source)) {
        const struct etch_rect w = source->window;

        for (y = w.y0; y < w.y1; y++)
            for (x = w.x0; x < w.x1; x++)
                source->pixels[etch_surface_index(source, (int16_t)x, (int16_t)y)] = at(x, y);
        rows_drawn += (int64_t)(w.x1 - w.x0) * (w.y1 - w.y0);
    }
    run_pass(p, c, source, &canvas.surface);
    inside = canvas.surface.clip;
    for (y = inside.y0; y < inside.y1; y++)
        for (x = inside.x0; x < inside.x1; x++)
            same = same && test_canvas_at(&canvas, x, y) == expected[y * WIDTH + x];
    CHECK_ONCE(&canvas);
    return same;
}

/* ---- cases
 * --------------------------------------------------------------------------------------- */

static void strips_of_every_height_are_the_definition(void)
{
    static const int16_t heights[] = {1, 2, 3, 7, 16, HEIGHT};
    const int32_t count = TEST_COUNT(400);
    struct etch_surface source;
    struct etch_carry c;
    uint32_t seed = 1;
    int32_t n;

    for (n = 0; n < count && !test_failed(); n++) {
        const int16_t rows = heights[n / 8 % 6];
        struct pass p;
        int32_t y;

        make_pass(&p, n, &seed);
        make_picture(test_range(&seed, 0, 3), &seed);
        make_expected(&p);
        open_carry(&c, &p, &source);
        rows_drawn = 0;
        for (y = 0; y < HEIGHT; y += rows) {
            const struct etch_rect strip = {0, (int16_t)y, WIDTH,
                                            (int16_t)hold(y + rows, 0, HEIGHT)};

            if (!CHECK(draw_area(&p, &c, &source, strip, strip))) {
                test_note("n", n);
                test_note("rows", rows);
                test_note("y", y);
            }
        }
        CHECK_EQ(rows_drawn, WIDTH * HEIGHT); /* nothing twice */
    }
}

/* Areas of the frame, one after the other without order, with clips. */
static void areas_in_any_order_are_the_definition(void)
{
    const int32_t count = TEST_COUNT(60);
    struct etch_surface source;
    struct etch_carry c;
    uint32_t seed = 2;
    int32_t n, i;

    for (n = 0; n < count && !test_failed(); n++) {
        struct pass p;

        make_pass(&p, n, &seed);
        make_picture(test_range(&seed, 0, 3), &seed);
        make_expected(&p);
        open_carry(&c, &p, &source);
        for (i = 0; i < 12 && !test_failed(); i++) {
            struct etch_rect area, inside;

            area.x0 = (int16_t)(i % 2 == 0 ? 0 : test_range(&seed, 0, WIDTH - 1));
            area.x1 = (int16_t)(i % 2 == 0 ? WIDTH : test_range(&seed, area.x0 + 1, WIDTH));
            area.y0 = (int16_t)test_range(&seed, 0, HEIGHT - 1);
            area.y1 = (int16_t)test_range(&seed, area.y0 + 1, HEIGHT);
            inside = area;
            if (i % 3 == 0) {
                inside.x0 = (int16_t)test_range(&seed, area.x0, area.x1 - 1);
                inside.y0 = (int16_t)test_range(&seed, area.y0, area.y1 - 1);
            }
            CHECK(draw_area(&p, &c, &source, area, inside));
        }
    }
}

static void a_strip_outside_the_frame_is_nothing(void)
{
    const struct etch_rect outside = {50, 40, 60, 44};
    const struct pass p = {.kind = 1};
    struct etch_surface source;
    struct etch_carry c;

    open_carry(&c, &p, &source);
    test_canvas_open(&canvas, outside);
    CHECK(!etch_carry_begin(&c, &canvas.surface, &source));
    etch_filter_average(&c, &source, &canvas.surface);
    CHECK(!test_canvas_drawn(&canvas, 50, 40));
    CHECK_EQ(etch_carry_init(&c, NULL, frame, 1, 1), ETCH_EINVAL);
    CHECK_EQ(etch_carry_init(&c, kept, frame, 0, 1), ETCH_EINVAL);
    CHECK_EQ(etch_carry_init(&c, kept, (struct etch_rect){3, 3, 3, 9}, 1, 1), ETCH_EINVAL);
}

static bool smoothing_changes(void)
{
    const struct pass p = {.kind = 3};
    int32_t i;

    make_expected(&p);
    for (i = 0; i < WIDTH * HEIGHT; i++)
        if (expected[i] != picture[i])
            return true;
    return false;
}

/* What smoothing promises to leave alone, and what it is for. */
static void smoothing_leaves_straight_edges_and_dots(void)
{
    int32_t i;

    for (i = 0; i < WIDTH * HEIGHT; i++)
        picture[i] = i / WIDTH < 11 ? 0xFFFF : 0;
    CHECK(!smoothing_changes());
    for (i = 0; i < WIDTH * HEIGHT; i++)
        picture[i] = i % WIDTH < 17 ? 0xFFFF : 0;
    CHECK(!smoothing_changes());
    for (i = 0; i < WIDTH * HEIGHT; i++)
        picture[i] = i == 15 * WIDTH + 20 ? 0xFFFF : 0;
    CHECK(!smoothing_changes());
    for (i = 0; i < WIDTH * HEIGHT; i++)
        picture[i] = i / WIDTH < 10 + i % WIDTH / 6 ? 0xFFFF : 0;
    CHECK(smoothing_changes());
}

/* A stair of 6 px steps, white above black: half of each step is mixed, as the line through the
 * steps' middles covers it. */
static void a_stair_becomes_a_slope(void)
{
    static const uint8_t lower[6] = {0, 0, 0, 3, 8, 13}; /* round(31 (1, 3, 5) / 12) */
    const struct pass p = {.kind = 3};
    int32_t i;

    for (i = 0; i < WIDTH * HEIGHT; i++)
        picture[i] = i / WIDTH < 10 + i % WIDTH / 6 ? 0xFFFF : 0;
    make_expected(&p);
    for (i = 0; i < 6; i++) { /* row 12 is black up to column 17, row 11 white from column 12 on */
        CHECK_EQ(expected[12 * WIDTH + 12 + i] & 31, lower[i]);
        CHECK_EQ(expected[11 * WIDTH + 12 + i] & 31, 31 - lower[5 - i]);
    }
}

void suite_filter(void)
{
    RUN(strips_of_every_height_are_the_definition);
    RUN(areas_in_any_order_are_the_definition);
    RUN(a_strip_outside_the_frame_is_nothing);
    RUN(smoothing_leaves_straight_edges_and_dots);
    RUN(a_stair_becomes_a_slope);
    test_print_count("", TEST_COUNT(400), " pictures in strips of 1, 2, 3, 7, 16 and all rows");
}
