/* tests/unit: varyings through clipping and projection, against exact rationals. */
#include "core/vertex/corner.h"
#include "core/vertex/varying.h"
#include "tests/harness/harness.h"
#include "tests/oracle/wide.h"

void suite_varying(void);

/* ---- a corner's value -------------------------------------------------------------------------
 */

/* A weight of any size up to `bits`, as the limbs of a corner and as a wide number. */
static struct wide random_weight(uint16_t limb[CORNER_LIMBS], int32_t bits, uint32_t *seed)
{
    struct wide w = {0, 0};
    int i;

    bits = test_range(seed, 0, bits);
    for (i = CORNER_LIMBS - 1; i >= 0; i--) {
        const int32_t room = bits - 15 * i < 0 ? 0 : bits - 15 * i > 15 ? 15 : bits - 15 * i;
        const uint32_t ones = test_range(seed, 0, 3) == 0 ? 0x7FFF : test_random(seed);

        limb[i] = (uint16_t)(ones & ((1u << room) - 1));
        w.hi = w.hi << 15 | w.lo >> 49;
        w.lo = (w.lo & ((UINT64_C(1) << 49) - 1)) << 15 | limb[i];
    }
    return w;
}

static int32_t random_value(uint32_t *seed)
{
    static const int32_t ends[] = {INT32_MIN, INT32_MAX, 0, 1, -1};

    return test_range(seed, 0, 3) == 0 ? ends[test_range(seed, 0, 4)]
                                       : (int32_t)test_random(seed) >> test_range(seed, 0, 31);
}

/* q = floor(sum / all + 1/2), that is 2 q all <= 2 sum + all < 2 q all + 2 all; from the least. */
static bool is_rounded(int64_t q, const struct wide weight[3], const int32_t value[3], uint8_t bits)
{
    const int64_t two = value[0] < value[1] ? value[0] : value[1];
    const int64_t least = two < value[2] ? two : value[2];
    const int64_t above = q - least * (INT64_C(1) << bits);
    struct wide all = {0, 0}, sum = {0, 0}, low, high;
    int i;

    for (i = 0; i < 3; i++) {
        all = wide_sum(all, weight[i]);
        sum = wide_sum(sum, wide_scale(weight[i], (uint32_t)(value[i] - least)));
    }
    if (above < 0 || above >> (32 + bits) != 0)
        return false;
    /* above = 2^bits a + b, so that every product stays below 2^128 */
    sum = wide_sum(wide_scale(wide_scale(sum, 1u << bits), 2), all);
    low = wide_scale(wide_scale(wide_scale(all, (uint32_t)(above >> bits)), 1u << bits), 2);
    low = wide_sum(low, wide_scale(all, 2 * (uint32_t)(above & ((INT64_C(1) << bits) - 1))));
    high = wide_sum(low, wide_scale(all, 2));
    return wide_at_most(low, sum) && !wide_at_most(high, sum);
}

static void values_are_rounded_once(void)
{
    uint32_t seed = 1;
    int32_t n;

    for (n = 0; n < TEST_COUNT(60000) && !test_failed(); n++) {
        const uint8_t bits = n % 2 == 0 ? 0 : 31;
        struct corner_weights corner;
        struct wide weight[3];
        int32_t value[3];
        int64_t got;
        int i;

        for (i = 0; i < 3; i++) {
            weight[i] = random_weight(corner.weight[i], bits == 0 ? 90 : 60, &seed);
            value[i] = random_value(&seed);
        }
        if ((weight[0].lo | weight[0].hi | weight[1].lo | weight[1].hi | weight[2].lo |
             weight[2].hi) == 0)
            continue;
        got = etch_corner_value(&corner, value, bits);
        if (!CHECK(is_rounded(got, weight, value, bits)))
            test_note("value", got);
    }
}

/* ---- triangles --------------------------------------------------------------------------------
 */

#define MOST 16

/* What the sink gets for etch_assemble_varying with three varyings. */
struct screen_vertex {
    struct etch_texture_vertex at;
    int32_t more;
};

struct clip_vertex {
    struct etch_clip_texture_vertex at;
    int32_t more;
};

struct store_sink {
    struct etch_sink sink;
    int n;
    bool wide;
    struct screen_vertex v[MOST][3];
};

static void store(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    struct store_sink *s = (struct store_sink *)(void *)sink;
    int i;

    if (!CHECK(s->n < MOST))
        return;
    for (i = 0; i < 3; i++) {
        if (s->wide)
            s->v[s->n][i] = *(const struct screen_vertex *)(const void *)v[i];
        else
            s->v[s->n][i].at.at = *v[i];
    }
    s->n++;
}

static struct store_sink plain = {.sink.triangle = store};
static struct store_sink wide = {.sink.triangle = store, .wide = true};

/* Coordinates of a scene (kind 0), of any size, or at the ends. */
static int32_t coordinate(int kind, uint32_t *seed)
{
    return kind == 0   ? test_range(seed, -(INT32_C(1) << 20), INT32_C(1) << 20)
           : kind == 1 ? (int32_t)test_random(seed) >> test_range(seed, 0, 31)
                       : random_value(seed);
}

/* A vertex whose varyings are x, y and w: then the screen position tells what they should be. */
static void random_vertex(struct clip_vertex *v, int kind, uint32_t *seed)
{
    const uint32_t color = test_random(seed);

    v->at.at.x = coordinate(kind, seed);
    v->at.at.y = coordinate(kind, seed);
    v->at.at.z = coordinate(kind, seed);
    v->at.at.w = coordinate(kind, seed);
    if (v->at.at.w < 0 && v->at.at.w > INT32_MIN && test_range(seed, 0, 3) != 0)
        v->at.at.w = -v->at.at.w;
    v->at.at.r = (uint8_t)color;
    v->at.at.g = (uint8_t)(color >> 8);
    v->at.at.b = (uint8_t)(color >> 16);
    v->at.at.a = (uint8_t)(color >> 24);
    v->at.u = v->at.at.x;
    v->at.v = v->at.at.y;
    v->more = v->at.at.w;
}

static bool same_vertex(const struct etch_vertex *a, const struct etch_vertex *b)
{
    return a->x_q8 == b->x_q8 && a->y_q8 == b->y_q8 && a->z_q16 == b->z_q16 && a->r == b->r &&
           a->g == b->g && a->b == b->b && a->a == b->a;
}

/* value / w is where the vertex stands: |(P - 128 centre) w - 128 size value| is at most
 * 4.5 w (clip.h's 1/64 px and the rounding) and what half a unit in value and w makes of it. */
static bool agrees(int32_t position, int32_t value, int32_t w, int64_t size, int64_t centre)
{
    const int64_t away = position - 128 * centre, error = away * w - 128 * size * value;
    const int64_t most = 5 * (int64_t)w + (away < 0 ? -away : away) +
                         128 * (size < 0 ? -size : size);

    return (error < 0 ? -error : error) <= most;
}

/* w is more's exact value in a unit of the triangle's, 2^-shift of it. */
static bool is_unit(const struct screen_vertex v[3], int shift)
{
    int i;

    for (i = 0; i < 3; i++) {
        const int64_t unit = INT64_C(1) << shift, error = v[i].at.w - v[i].more * unit;

        if (error < -(unit / 2) - 1 || error > unit / 2 + 1)
            return false;
    }
    return true;
}

static void check_triangle(const struct screen_vertex v[3], struct etch_rect r)
{
    int i, shift;

    for (i = 0; i < 3; i++) {
        CHECK(agrees(v[i].at.at.x_q8, v[i].at.u, v[i].more, r.x1 - r.x0, r.x0 + r.x1));
        CHECK(agrees(v[i].at.at.y_q8, v[i].at.v, v[i].more, r.y0 - r.y1, r.y0 + r.y1));
        CHECK(v[i].at.w != 0);
    }
    for (shift = 0; shift < 32 && !is_unit(v, shift); shift++)
        ;
    CHECK(shift < 32);
}

/* Plain triangles of the same vertices come out the same, and varyings go with their positions. */
static void varyings_go_with_positions(void)
{
    uint32_t seed = 2;
    int32_t n, clipped = 0, drawn = 0;

    for (n = 0; n < TEST_COUNT(40000) && !test_failed(); n++) {
        const struct etch_rect rect = {0, 0, n % 3 == 0 ? 32767 : 320, n % 5 == 0 ? 3 : 240};
        struct etch_assembly assembly = {.cull = (enum etch_cull)(n % 3), .flat = n % 7 == 0};
        struct clip_vertex v[3];
        const struct etch_clip_vertex *const in[3] = {&v[0].at.at, &v[1].at.at, &v[2].at.at};
        int i, k;

        (void)etch_viewport_init(&assembly.viewport, rect);
        for (i = 0; i < 3; i++)
            random_vertex(&v[i], n % 4 == 3 ? 0 : n % 4, &seed);

        const struct etch_clip_vertex bare[3] = {*in[0], *in[1], *in[2]};

        plain.n = wide.n = 0;
        assembly.sink = &plain.sink;
        etch_assemble_triangle(&assembly, bare);
        assembly.sink = &wide.sink;
        etch_assemble_varying(&assembly, in, 3);
        CHECK_EQ(wide.n, plain.n);
        for (k = 0; k < wide.n && !test_failed(); k++) {
            for (i = 0; i < 3; i++)
                CHECK(same_vertex(&wide.v[k][i].at.at, &plain.v[k][i].at.at));
            check_triangle(wide.v[k], rect);
        }
        drawn += wide.n != 0;
        clipped += wide.n > 1;
        if (test_failed())
            test_note("triangle", n);
    }
    CHECK(clipped > drawn / 20);
    test_print_count("", drawn, " triangles in sight, their varyings where their positions are");
    test_print_count("", clipped, " of them clipped to polygons");
}

static int32_t uneven;

static void check_w(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    const struct etch_texture_vertex *const a = (const void *)v[0], *const b = (const void *)v[1];
    const struct etch_texture_vertex *const c = (const void *)v[2];

    (void)sink;
    uneven += a->w != b->w || b->w != c->w;
}

/* A parallel projection keeps all w equal, also where it is clipped: painters then draw affine. */
static void equal_w_stays_equal(void)
{
    struct etch_sink sink = {.triangle = check_w};
    static const struct etch_rect rect = {0, 0, 320, 240};
    struct etch_assembly assembly = {.sink = &sink};
    uint32_t seed = 3;
    int32_t n;

    (void)etch_viewport_init(&assembly.viewport, rect);
    for (n = 0; n < TEST_COUNT(5000) && !test_failed(); n++) {
        struct etch_clip_texture_vertex v[3];
        int i;

        for (i = 0; i < 3; i++) {
            struct clip_vertex any;

            random_vertex(&any, 0, &seed);
            v[i] = any.at;
            v[i].at.z /= 8;
            v[i].at.w = 65536;
        }
        etch_assemble_textured(&assembly, v);
        CHECK_EQ(uneven, 0);
    }
}

void suite_varying(void)
{
    RUN(values_are_rounded_once);
    RUN(varyings_go_with_positions);
    RUN(equal_w_stays_equal);
}
