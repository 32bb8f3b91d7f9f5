/* tests/unit: model space to clip space to the frame, and culling, against their definitions. */
#include "core/vertex/cull.h"
#include "core/vertex/reciprocal.h"
#include "core/vertex/viewport.h"
#include "tests/harness/harness.h"
#include "tests/oracle/wide.h"

void suite_vertex(void);

static const struct etch_rect rects[] = {
    {0, 0, 320, 240},     {0, 0, 240, 320},     {10, 20, 20, 23},
    {-100, -5, 500, 995}, {0, 0, 32767, 32767}, {-32768, -32768, 32767, 32767},
    {0, 0, 1, 1},         {5, 5, 69, 69},       {32000, 0, 32767, 10}};
#define RECTS ((int)(sizeof rects / sizeof rects[0]))

/* A number of random size, often at an end. */
static int32_t any_size(uint32_t *seed)
{
    const int32_t v = (int32_t)test_random(seed) >> test_range(seed, 0, 31);

    return test_range(seed, 0, 20) > 0 ? v : v < 0 ? INT32_MIN : INT32_MAX;
}

/* ---- transform ------------------------------------------------------------------------------- */

static int64_t exact_row(const etch_q16 row[4], const int16_t p[3], uint8_t bits)
{
    const int64_t unit = INT64_C(1) << bits;
    const int64_t sum = (int64_t)row[0] * p[0] + (int64_t)row[1] * p[1] + (int64_t)row[2] * p[2] +
                        row[3] * unit;
    const int64_t rounded = (sum + unit / 2) >> bits;

    return rounded > INT32_MAX ? INT32_MAX : rounded < INT32_MIN ? INT32_MIN : rounded;
}

static void transform_is_rounded_once(void)
{
    uint32_t seed = 1;
    int32_t n, narrow = 0;

    for (n = 0; n < TEST_COUNT(200000); n++) {
        const uint16_t extent = (uint16_t)(test_random(&seed) % (UINT32_C(32769) >> (n % 14)));
        const uint8_t bits = (uint8_t)test_range(&seed, 0, 15);
        const int32_t down = test_range(&seed, 0, 24);
        struct etch_matrix m;
        struct etch_transform t, wide;
        struct etch_clip_vertex out = {0, 0, 0, 0, 1, 2, 3, 4}, slow;
        int16_t p[3];
        int i;

        for (i = 0; i < 16; i++)
            m.m[i / 4][i % 4] = any_size(&seed) >> down;
        for (i = 0; i < 3; i++) {
            const int32_t v = test_range(&seed, 0, 5) == 0
                                  ? extent
                                  : test_range(&seed, -(int32_t)extent, (int32_t)extent);

            p[i] = (int16_t)(v > INT16_MAX ? INT16_MIN : v);
        }
        etch_transform_init(&t, &m, bits, extent);
        narrow += t.narrow;
        etch_transform_position(&t, p, &out);
        wide = t;
        wide.narrow = false;
        etch_transform_position(&wide, p, &slow);
        CHECK_EQ(out.x, exact_row(m.m[0], p, bits));
        CHECK_EQ(out.y, exact_row(m.m[1], p, bits));
        CHECK_EQ(out.z, exact_row(m.m[2], p, bits));
        CHECK_EQ(out.w, exact_row(m.m[3], p, bits));
        CHECK(out.x == slow.x && out.y == slow.y && out.z == slow.z && out.w == slow.w);
        CHECK(out.r == 1 && out.g == 2 && out.b == 3 && out.a == 4);
    }
    CHECK(narrow > n / 20 && narrow < n);
}

/* The bound of the header's example: a usual camera and a 12-bit mesh multiply in 32 bits. */
static void usual_transforms_are_narrow(void)
{
    struct etch_matrix m;
    struct etch_transform t;
    int i;

    for (i = 0; i < 16; i++)
        m.m[i / 4][i % 4] = i % 4 == 3 ? 30000 * 65536 : 2 * 65536;
    etch_transform_init(&t, &m, 0, 400);
    CHECK(t.narrow);
    for (i = 0; i < 16; i++)
        m.m[i / 4][i % 4] = i % 4 == 3 ? 4 * 65536 : 2 * 65536;
    etch_transform_init(&t, &m, 11, 4095);
    CHECK(t.narrow);
    etch_transform_init(&t, &m, 11, 32768);
    CHECK(!t.narrow);
}

/* ---- outcodes -------------------------------------------------------------------------------- */

static uint8_t exact_outcode(const struct etch_viewport *v, const struct etch_clip_vertex *in)
{
    const int64_t x = in->x, y = in->y, z = in->z, w = in->w;
    const int64_t wide = w * (INT64_C(1) << v->guard_x), high = w * (INT64_C(1) << v->guard_y);
    const bool eye = x == 0 && y == 0 && z == 0 && w == 0;

    return (uint8_t)((x < -w ? ETCH_OUT_LEFT : 0) | (x > w ? ETCH_OUT_RIGHT : 0) |
                     (y < -w ? ETCH_OUT_BOTTOM : 0) | (y > w ? ETCH_OUT_TOP : 0) |
                     (z < -w || eye ? ETCH_OUT_NEAR : 0) | (z > w ? ETCH_OUT_FAR : 0) |
                     (x < -wide || x > wide || y < -high || y > high ? ETCH_OUT_GUARD : 0));
}

static void outcodes_are_exact(void)
{
    uint32_t seed = 1;
    int32_t n;

    for (n = 0; n < TEST_COUNT(300000); n++) {
        struct etch_viewport v;
        struct etch_clip_vertex in = {
            any_size(&seed), any_size(&seed), any_size(&seed), any_size(&seed), 0, 0, 0, 0};

        if (n % 3 == 0) /* on the planes and beside them */
            in.x = (int32_t)test_range(&seed, -3, 3) + (in.w >> 8);
        if (n % 7 == 0)
            in.x = in.w;
        if (n % 11 == 0 && in.w > INT32_MIN)
            in.z = -in.w;
        if (n % 50 == 0)
            in.x = in.y = in.z = 0;
        CHECK_EQ(etch_viewport_init(&v, rects[n % RECTS]), ETCH_OK);
        CHECK_EQ(etch_viewport_outcode(&v, &in), exact_outcode(&v, &in));
    }
}

/* The guard planes lie outside the viewport and inside the range of positions. */
static void guards_are_in_range(void)
{
    uint32_t seed = 1;
    int32_t n;

    for (n = 0; n < TEST_COUNT(100000); n++) {
        struct etch_rect r = {(int16_t)any_size(&seed), (int16_t)any_size(&seed),
                              (int16_t)any_size(&seed), (int16_t)any_size(&seed)};
        struct etch_viewport v = {{1, 2, 3, 4}, 5, 6};

        if (r.x1 <= r.x0 || r.y1 <= r.y0) {
            CHECK_EQ(etch_viewport_init(&v, r), ETCH_EINVAL);
            CHECK(v.rect.x1 == 3 && v.guard_x == 5);
            continue;
        }
        CHECK_EQ(etch_viewport_init(&v, r), ETCH_OK);
        const int64_t reach_x = ((int64_t)r.x1 - r.x0) << v.guard_x;
        const int64_t reach_y = ((int64_t)r.y1 - r.y0) << v.guard_y;

        CHECK(r.x0 + r.x1 + reach_x <= 65536 && r.x0 + r.x1 - reach_x >= -65536);
        CHECK(r.y0 + r.y1 + reach_y <= 65536 && r.y0 + r.y1 - reach_y >= -65536);
        CHECK(v.guard_x <= 10 && v.guard_y <= 10);
    }
}

/* ---- projection ------------------------------------------------------------------------------ */

/* position = 128 (size v / w + centre) rounded half up: -w <= 2 (position w - exact w) < w, and
 * the tie goes up. */
static bool is_placed(int32_t position, int64_t size, int64_t centre, int64_t v, int64_t w)
{
    const int64_t twice_error = 2 * (position * w - 128 * (size * v + centre * w));

    return twice_error > -w && twice_error <= w;
}

/* depth = N / 2w rounded half up, N = (z + w) (2^32 - 2^16): that is
 * 2 w depth - w <= N < 2 w depth + w. */
static bool is_depth(uint32_t depth, int64_t z, int64_t w)
{
    const struct wide n = wide_product((uint64_t)(z + w), UINT64_C(0xFFFF0000));
    const struct wide above = wide_product((uint64_t)depth * 2 + 1, (uint64_t)w);
    const struct wide more = {0, (uint64_t)w * 2};

    return !wide_at_most(above, n) && wide_at_most(above, wide_sum(n, more));
}

static void check_projection(const struct etch_viewport *v, const struct etch_clip_vertex *in)
{
    const struct etch_rect r = v->rect;
    struct etch_vertex out;

    etch_viewport_project(v, in, &out);
    if (!CHECK(is_placed(out.x_q8, r.x1 - r.x0, r.x0 + r.x1, in->x, in->w)) ||
        !CHECK(is_placed(out.y_q8, r.y0 - r.y1, r.y0 + r.y1, in->y, in->w)) ||
        !CHECK(is_depth(out.z_q16, in->z, in->w))) {
        test_note("x", in->x);
        test_note("y", in->y);
        test_note("z", in->z);
        test_note("w", in->w);
    }
    CHECK(out.x_q8 >= -(INT32_C(1) << 23) && out.x_q8 <= INT32_C(1) << 23);
    CHECK(out.y_q8 >= -(INT32_C(1) << 23) && out.y_q8 <= INT32_C(1) << 23);
    CHECK(out.r == 9 && out.g == 8 && out.b == 7 && out.a == 6);
}

static void projection_is_rounded_once(void)
{
    uint32_t seed = 1;
    int32_t n, projected = 0;

    for (n = 0; n < TEST_COUNT(600000); n++) {
        const int32_t w = (int32_t)(test_random(&seed) >> test_range(&seed, 1, 31));
        const int32_t far = n % 4 == 0 ? test_range(&seed, 0, 10) : 0;
        struct etch_clip_vertex in = {0, 0, 0, w, 9, 8, 7, 6};
        struct etch_viewport v;

        in.x = w >> 23 >= INT32_C(128) >> far ? test_range(&seed, -w, w)
                                              : test_range(&seed, -w, w) * (1 << far);
        in.y = test_range(&seed, -w, w);
        in.z = n % 5 == 0 ? (n % 2 ? w : -w) : test_range(&seed, -w, w);
        if (n % 9 == 0)
            in.x = in.z;
        CHECK_EQ(etch_viewport_init(&v, rects[n % RECTS]), ETCH_OK);
        if ((etch_viewport_outcode(&v, &in) & ETCH_OUT_CLIP) != 0)
            continue;
        check_projection(&v, &in);
        projected++;
    }
    CHECK(projected > n / 2);
}

/* Exact ties, w a power of two: halves of 1/256 px go up, in both directions. */
static void ties_go_up(void)
{
    static const struct etch_rect square = {0, 0, 256, 256};
    struct etch_viewport v;
    struct etch_vertex out;
    int32_t i;

    CHECK_EQ(etch_viewport_init(&v, square), ETCH_OK);
    for (i = -1000; i <= 1000; i++) { /* 128 * 256 * i / 65536 = i / 2 */
        const struct etch_clip_vertex in = {i, -i, 0, 65536, 9, 8, 7, 6};

        etch_viewport_project(&v, &in, &out);
        CHECK_EQ(out.x_q8, 32768 + ((i + 1) >> 1));
        CHECK_EQ(out.y_q8, 32768 + ((i + 1) >> 1));
    }
}

static void corners_of_the_volume(void)
{
    uint32_t seed = 1;
    int n;

    for (n = 0; n < 2000; n++) {
        const struct etch_rect r = rects[n % RECTS];
        const int32_t w = (int32_t)(test_random(&seed) >> test_range(&seed, 1, 30)) | 1;
        const struct etch_clip_vertex low = {-w, -w, -w, w, 0, 0, 0, 0};
        const struct etch_clip_vertex high = {w, w, w, w, 0, 0, 0, 0};
        struct etch_viewport v;
        struct etch_vertex out;

        CHECK_EQ(etch_viewport_init(&v, r), ETCH_OK);
        etch_viewport_project(&v, &low, &out);
        CHECK_EQ(out.x_q8, r.x0 * 256);
        CHECK_EQ(out.y_q8, r.y1 * 256);
        CHECK_EQ(out.z_q16, 0);
        etch_viewport_project(&v, &high, &out);
        CHECK_EQ(out.x_q8, r.x1 * 256);
        CHECK_EQ(out.y_q8, r.y0 * 256);
        CHECK_EQ(out.z_q16, UINT32_C(0xFFFF0000));
    }
}

/* ---- winding --------------------------------------------------------------------------------- */

static void winding_is_exact(void)
{
    uint32_t seed = 1;
    int32_t n;

    for (n = 0; n < TEST_COUNT(200000); n++) {
        const int32_t size = INT32_C(1) << test_range(&seed, 0, 23);
        struct etch_vertex v[3] = {
            {0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0}};
        const struct etch_vertex *const t[3] = {&v[0], &v[1], &v[2]};
        const struct etch_vertex *const turned[3] = {&v[2], &v[1], &v[0]};
        int i;

        for (i = 0; i < 3; i++) {
            v[i].x_q8 = test_range(&seed, -size, size);
            v[i].y_q8 = n % 8 == 0 ? v[i].x_q8 / 3 * 2 : test_range(&seed, -size, size);
            if (n % 16 == 1) {
                v[i].x_q8 = v[i].x_q8 < 0 ? -size : size;
                v[i].y_q8 = v[i].y_q8 < 0 ? -size : size;
            }
        }
        const int64_t area = (int64_t)(v[1].x_q8 - v[0].x_q8) * (v[2].y_q8 - v[0].y_q8) -
                             (int64_t)(v[1].y_q8 - v[0].y_q8) * (v[2].x_q8 - v[0].x_q8);
        const int sign = area > 0 ? 1 : area < 0 ? -1 : 0;

        CHECK_EQ(etch_winding(t), sign);
        CHECK_EQ(etch_winding(turned), -sign);
        CHECK_EQ(etch_cull_keeps(ETCH_CULL_NONE, t), sign != 0);
        CHECK_EQ(etch_cull_keeps(ETCH_CULL_CLOCKWISE, t), sign < 0);
        CHECK_EQ(etch_cull_keeps(ETCH_CULL_COUNTER_CLOCKWISE, t), sign > 0);
    }
}

/* Both forms, for every divisor. */
static void first_reciprocals_are_quotients(void)
{
    for (uint32_t d = (UINT32_C(1) << 15) + 1; d <= UINT32_C(1) << 16; d++) {
        const uint32_t quotient = UINT32_C(0xFFFFFFFF) / d;

        CHECK_EQ(etch_reciprocal_by_division(d), quotient);
        CHECK_EQ(etch_reciprocal_by_iteration(d), quotient);
        CHECK_EQ(etch_reciprocal(d), quotient);
    }
}

void suite_vertex(void)
{
    RUN(transform_is_rounded_once);
    RUN(usual_transforms_are_narrow);
    RUN(outcodes_are_exact);
    RUN(guards_are_in_range);
    RUN(first_reciprocals_are_quotients);
    RUN(projection_is_rounded_once);
    RUN(ties_go_up);
    RUN(corners_of_the_volume);
    RUN(winding_is_exact);
}
