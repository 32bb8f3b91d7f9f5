/* tests/harness: seeded triangles of every kind. Called by the suites. See shapes.h. */
#include "shapes.h"

#include "harness.h"

#define LIMIT (INT32_C(1) << 23)

const uint8_t test_orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                   {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};

static int32_t clamp(int32_t v)
{
    return v > LIMIT ? LIMIT : v < -LIMIT ? -LIMIT : v;
}

static int32_t pick(uint32_t *seed, int32_t lo, int32_t hi)
{
    return clamp(test_range(seed, lo, hi));
}

/* A vertex within `margin` px of the window, on a grid of `grid` / 256 px plus `offset`. */
static void near(struct test_triangle *t, int i, struct etch_rect w, int32_t margin, int32_t grid,
                 int32_t offset, uint32_t *seed)
{
    t->x[i] = clamp(test_range(seed, (w.x0 - margin) * 256 / grid, (w.x1 + margin) * 256 / grid) *
                        grid +
                    offset);
    t->y[i] = clamp(test_range(seed, (w.y0 - margin) * 256 / grid, (w.y1 + margin) * 256 / grid) *
                        grid +
                    offset);
}

static void anywhere(struct test_triangle *t, int i, uint32_t *seed)
{
    t->x[i] = pick(seed, -LIMIT, LIMIT);
    t->y[i] = pick(seed, -LIMIT, LIMIT);
}

/* Vertex 2 to a point on the line through 0 and 1, up to `off` / 256 px beside it. */
static void collinear(struct test_triangle *t, int32_t off, uint32_t *seed)
{
    const int32_t at = test_range(seed, -16, 48); /* in 1/32 of the edge */
    const int64_t dx = (int64_t)t->x[1] - t->x[0], dy = (int64_t)t->y[1] - t->y[0];

    t->x[2] = clamp((int32_t)(t->x[0] + dx * at / 32) + test_range(seed, -off, off));
    t->y[2] = clamp((int32_t)(t->y[0] + dy * at / 32) + test_range(seed, -off, off));
}

static int32_t extreme(int32_t near_value, uint32_t *seed)
{
    switch (test_range(seed, 0, 5)) {
    case 0:
    case 1: return LIMIT;
    case 2:
    case 3: return -LIMIT;
    case 4: return test_range(seed, 0, 1) ? LIMIT - 1 : -LIMIT + 1;
    default: return near_value;
    }
}

static void make_extreme(struct test_triangle *t, struct etch_rect w, uint32_t *seed)
{
    int i;

    for (i = 0; i < 3; i++) {
        near(t, i, w, 0, 1, 0, seed);
        t->x[i] = extreme(t->x[i], seed);
        t->y[i] = extreme(t->y[i], seed);
    }
}

static void make_degenerate(struct test_triangle *t, struct etch_rect w, uint32_t *seed)
{
    const int32_t grid = test_range(seed, 0, 1) ? 32 : 1;
    int i;

    for (i = 0; i < 3; i++)
        near(t, i, w, 10, grid, 0, seed);
    switch (test_range(seed, 0, 4)) {
    case 0:
        t->x[1] = t->x[0];
        t->y[1] = t->y[0];
        break;
    case 1:
        t->x[1] = t->x[0];
        t->x[2] = t->x[0];
        break;
    case 2:
        t->y[1] = t->y[0];
        t->y[2] = t->y[0];
        break;
    case 3: collinear(t, 0, seed); break;
    default: collinear(t, 1, seed); break;
    }
}

/* One vertex near, one far, and the third along the far one's direction or far too. */
static void make_far(struct test_triangle *t, struct etch_rect w, uint32_t *seed)
{
    near(t, 0, w, 4, 1, 0, seed);
    anywhere(t, 1, seed);
    if (test_range(seed, 0, 2) == 0)
        anywhere(t, 2, seed);
    else
        collinear(t, test_range(seed, 1, 2000), seed);
}

/* The first two vertices on both sides of the centre of pixel (x, y), which is exactly on their
 * edge, up to 512 px away. */
static void make_sliver(struct test_triangle *t, int32_t x, int32_t y, uint32_t *seed)
{
    const int32_t reach = INT32_C(1) << test_range(seed, 7, 14);
    const int32_t dx = 8 * test_range(seed, -reach, reach),
                  dy = 8 * test_range(seed, -reach, reach);
    const int32_t k = test_range(seed, 1, 8);

    t->x[0] = clamp(256 * x + 128 + dx);
    t->y[0] = clamp(256 * y + 128 + dy);
    t->x[1] = clamp(256 * x + 128 - dx / 8 * k);
    t->y[1] = clamp(256 * y + 128 - dy / 8 * k);
    collinear(t, INT32_C(1) << test_range(seed, 0, 10), seed);
}

/* Edge 0, 1 all but upright, from an end near the centre of pixel (x, y) up or down, or from end to
 * end of the plane past it; vertex 2 near the window or anywhere to one side. */
static void make_tall(struct test_triangle *t, int32_t x, int32_t y, uint32_t *seed)
{
    const int32_t up = 256 * y + 128 + test_range(seed, -2, 2);
    const int32_t tall = test_range(seed, INT32_C(1) << 22, LIMIT);

    t->x[0] = clamp(256 * x + 128 + test_range(seed, -2, 2));
    t->x[1] = clamp(t->x[0] + test_range(seed, -2, 2));
    t->y[0] = clamp(up);
    t->y[1] = up > 0 ? up - tall : up + tall;
    if (up + tall <= LIMIT && test_range(seed, 0, 1) == 0)
        t->y[1] = up + tall;
    if (test_range(seed, 0, 3) == 0) {
        t->y[0] = test_range(seed, 0, 2) - LIMIT;
        t->y[1] = LIMIT - test_range(seed, 0, 2);
    }
    if (test_range(seed, 0, 1) == 0)
        t->x[2] = pick(seed, -LIMIT, LIMIT);
}

void test_triangle_make(struct test_triangle *t, enum test_triangle_kind kind,
                        struct etch_rect window, uint32_t *seed)
{
    const int32_t x = test_range(seed, window.x0, window.x1);
    const int32_t y = test_range(seed, window.y0, window.y1);
    const struct etch_rect spot = {(int16_t)x, (int16_t)y, (int16_t)x, (int16_t)y};
    int i;

    for (i = 0; i < 3; i++) {
        switch (kind) {
        case TEST_TRIANGLE_tiny: near(t, i, spot, 1, 1, 0, seed); break;
        case TEST_TRIANGLE_huge: anywhere(t, i, seed); break;
        case TEST_TRIANGLE_centres: near(t, i, window, 6, 256, 128, seed); break;
        case TEST_TRIANGLE_corners: near(t, i, window, 6, 256, 0, seed); break;
        case TEST_TRIANGLE_sixteenths: near(t, i, window, 10, 16, 0, seed); break;
        case TEST_TRIANGLE_screen:
        case TEST_TRIANGLE_sliver: near(t, i, window, i == 0 ? 10 : 500, 1, 0, seed); break;
        default: near(t, i, window, 30, 1, 0, seed); break;
        }
    }
    if (kind == TEST_TRIANGLE_thin)
        collinear(t, 16, seed);
    else if (kind == TEST_TRIANGLE_sliver)
        make_sliver(t, x, y, seed);
    else if (kind == TEST_TRIANGLE_extreme)
        make_extreme(t, window, seed);
    else if (kind == TEST_TRIANGLE_degenerate)
        make_degenerate(t, window, seed);
    else if (kind == TEST_TRIANGLE_far)
        make_far(t, window, seed);
    else if (kind == TEST_TRIANGLE_tall)
        make_tall(t, x, y, seed);
}
