/* tests/unit: frames that are drawn several times: accumulation against sums in 64 bits, offsets of
 * jitter by their definition. (Larger frames: supersample.c; images exchanged: exchange.c.) */
#include "core/base/rgb565.h"
#include "core/frame/accumulation.h"
#include "core/frame/jitter.h"
#include "tests/harness/canvas.h"
#include "tests/unit/passes_parts.h"

void suite_passes(void);

static struct test_canvas canvas;
static uint16_t sums[3 * PIXELS];

/* ---- accumulation ------------------------------------------------------------------------------
 */

/* Sums as they should be, per channel of each pixel. */
static uint64_t expected[3 * PIXELS];

static void expect(const struct etch_surface *s, uint16_t weight, bool load)
{
    int32_t x, y, i;

    for (y = s->clip.y0; y < s->clip.y1; y++) {
        for (x = s->clip.x0; x < s->clip.x1; x++) {
            for (i = 0; i < 3; i++) {
                uint64_t *sum = &expected[3 * (y * WIDTH + x) + i];
                const uint16_t c = s->pixels[etch_surface_index(s, (int16_t)x, (int16_t)y)];

                *sum = (load ? 0 : *sum) + (uint64_t)channel(c, i) * weight;
                *sum = *sum < 65535 ? *sum : 65535;
            }
        }
    }
}

static void check_sums(void)
{
    int32_t i, wrong = 0;

    for (i = 0; i < 3 * PIXELS; i++)
        wrong += sums[i] != expected[i];
    CHECK_EQ(wrong, 0);
}

static void check_returned(const struct etch_surface *s, uint32_t divisor, bool swapped)
{
    int32_t x, y, i, wrong = 0;

    for (y = s->clip.y0; y < s->clip.y1; y++) {
        for (x = s->clip.x0; x < s->clip.x1; x++) {
            uint16_t got = s->pixels[etch_surface_index(s, (int16_t)x, (int16_t)y)];

            if (swapped)
                got = etch_rgb565_swap(got);
            for (i = 0; i < 3; i++) {
                const uint64_t n = (2 * expected[3 * (y * WIDTH + x) + i] + divisor) /
                                   (2 * divisor);
                const uint64_t most = i == 1 ? 63 : 31;

                wrong += channel(got, i) != (n < most ? n : most);
            }
        }
    }
    if (!CHECK_EQ(wrong, 0))
        test_note("divisor", divisor);
}

static void accumulation_is_the_exact_weighted_average(void)
{
    const int32_t count = TEST_COUNT(400);
    uint32_t seed = 1;
    int32_t n, i;

    for (n = 0; n < count && !test_failed(); n++) {
        const int32_t frames = test_range(&seed, 1, 20);
        const int32_t most = n % 4 == 3 ? 65535 : 1040 / frames;
        struct etch_accumulation a;
        uint32_t weights = 0;

        for (i = 0; i < 3 * PIXELS; i++)
            expected[i] = sums[i] = 0;
        CHECK_EQ(etch_accumulation_init(&a, sums, frame, WIDTH), ETCH_OK);
        test_canvas_open(&canvas, frame);
        for (i = 0; i < frames; i++) {
            const uint16_t weight = (uint16_t)test_range(&seed, 0, most);

            if (n % 2 == 1)
                test_canvas_clip(&canvas, random_clip(frame, &seed));
            fill_random(&canvas.surface, &seed);
            expect(&canvas.surface, weight, i == 0);
            weights += weight;
            (i == 0 ? etch_accumulation_load : etch_accumulation_add)(&a, &canvas.surface, weight);
        }
        check_sums();
        if (n % 4 >= 2 || weights == 0 || weights > 65535)
            weights = (uint32_t)test_range(&seed, 1, n % 4 == 2 ? 300 : 65535);
        test_canvas_wipe(&canvas);
        (n % 3 == 0 ? etch_accumulation_return_swapped
                    : etch_accumulation_return)(&a, &canvas.surface, (uint16_t)weights);
        CHECK_ONCE(&canvas);
        check_returned(&canvas.surface, weights, n % 3 == 0);
    }
}

/* Every sum and divisor that 8-bit weights make, and the largest. */
static void returning_rounds_every_sum_once(void)
{
    struct etch_accumulation a;
    uint32_t divisor, i, n;

    CHECK_EQ(etch_accumulation_init(&a, sums, frame, WIDTH), ETCH_OK);
    test_canvas_open(&canvas, frame);
    for (n = 1; n <= (uint32_t)TEST_COUNT(300) && !test_failed(); n++) {
        divisor = n < 290 ? n : n < 295 ? 65535 - n : 1040 + n;
        for (i = 0; i < 3 * PIXELS; i++)
            expected[i] = sums[i] = (uint16_t)(i < 2000 ? i * divisor / 31 : 65535 - i);
        etch_accumulation_return(&a, &canvas.surface, (uint16_t)divisor);
        check_returned(&canvas.surface, divisor, false);
    }
    test_canvas_wipe(&canvas);
    etch_accumulation_return(&a, &canvas.surface, 0); /* nothing */
    CHECK(!test_canvas_drawn(&canvas, 0, 0));
}

static void sums_are_multiplied_by_a_fraction(void)
{
    const int32_t count = TEST_COUNT(200);
    uint32_t seed = 2;
    int32_t n, i, wrong = 0;
    struct etch_accumulation a;

    CHECK_EQ(etch_accumulation_init(&a, sums, frame, WIDTH), ETCH_OK);
    for (n = 0; n < count; n++) {
        const struct etch_rect area = n % 3 == 0 ? frame : random_clip(frame, &seed);
        const uint16_t up = (uint16_t)test_range(&seed, 0, n % 2 == 0 ? 16 : 65535);
        const uint16_t down = (uint16_t)test_range(&seed, 0, n % 2 == 0 ? 16 : 65535);

        for (i = 0; i < 3 * PIXELS; i++) {
            const int32_t x = i / 3 % WIDTH, y = i / 3 / WIDTH;
            const bool inside = x >= area.x0 && x < area.x1 && y >= area.y0 && y < area.y1;
            uint64_t v = sums[i] = (uint16_t)(test_random(&seed) >> 16);

            if (inside && down != 0)
                v = (v * up * 2 + down) / (2ULL * down);
            expected[i] = v < 65535 ? v : 65535;
        }
        etch_accumulation_multiply(&a, area, up, down);
        for (i = 0; i < 3 * PIXELS; i++)
            wrong += sums[i] != expected[i];
    }
    CHECK_EQ(wrong, 0);
}

static void accumulation_refuses_what_is_no_plane(void)
{
    struct etch_accumulation a;
    const struct etch_rect none = {4, 4, 4, 8}, left = {-1, 0, 3, 3};

    CHECK_EQ(etch_accumulation_init(&a, NULL, frame, WIDTH), ETCH_EINVAL);
    CHECK_EQ(etch_accumulation_init(&a, sums, none, WIDTH), ETCH_EINVAL);
    CHECK_EQ(etch_accumulation_init(&a, sums, left, WIDTH), ETCH_EINVAL);
    CHECK_EQ(etch_accumulation_init(&a, sums, frame, WIDTH - 1), ETCH_EINVAL);
}

/* ---- jitter
 * ---------------------------------------------------------------------------------------- */

static void offsets_take_every_row_and_column_once(void)
{
    int32_t j, i;

    for (j = 0; j < 4; j++) {
        const int32_t n = jitters[j].n;
        int32_t x = 0, y = 0, columns = 0, rows = 0;

        for (i = 0; i < n; i++) {
            const struct etch_offset_q8 o = jitters[j].offset[i];

            x += o.x;
            y += o.y;
            columns |= 1 << (o.x + 128) * n / 256;
            rows |= 1 << (o.y + 128) * n / 256;
            CHECK_EQ((o.x + 128) * n % 256, 128); /* the middle of its column */
            CHECK_EQ((o.y + 128) * n % 256, 128);
        }
        CHECK_EQ(x, 0);
        CHECK_EQ(y, 0);
        CHECK_EQ(columns, (1 << n) - 1);
        CHECK_EQ(rows, (1 << n) - 1);
    }
}

static struct etch_vertex caught[3];
static int caught_count;

static void catch_triangle(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    (void)sink;
    for (caught_count = 0; caught_count < 3; caught_count++)
        caught[caught_count] = *v[caught_count];
}

static void catch_line(struct etch_sink *sink, const struct etch_vertex *const v[2])
{
    (void)sink;
    for (caught_count = 0; caught_count < 2; caught_count++)
        caught[caught_count] = *v[caught_count];
}

static void catch_point(struct etch_sink *sink, const struct etch_vertex *v)
{
    (void)sink;
    caught[0] = *v;
    caught_count = 1;
}

static void the_jitter_sink_moves_every_vertex(void)
{
    static const struct etch_vertex vertex[3] = {
        {10, 20, 30, 1, 2, 3, 4}, {-10, 0, 31, 5, 6, 7, 8}, {99, 98, 97, 96, 95, 94, 93}};
    const struct etch_vertex *const v[3] = {&vertex[0], &vertex[1], &vertex[2]};
    struct etch_sink sink = {catch_triangle, catch_line, catch_point};
    const struct etch_offset_q8 offset = {-96, 32};
    struct etch_jitter_sink jitter;
    int n, i;

    etch_jitter_sink_init(&jitter, &sink, offset);
    for (n = 1; n <= 3; n++) {
        if (n == 1)
            jitter.sink.point(&jitter.sink, v[0]);
        else if (n == 2)
            jitter.sink.line(&jitter.sink, v);
        else
            jitter.sink.triangle(&jitter.sink, v);
        CHECK_EQ(caught_count, n);
        for (i = 0; i < n; i++) {
            CHECK_EQ(caught[i].x_q8, vertex[i].x_q8 + 96);
            CHECK_EQ(caught[i].y_q8, vertex[i].y_q8 - 32);
            CHECK_EQ(caught[i].z_q16, vertex[i].z_q16);
            CHECK_EQ(caught[i].g, vertex[i].g);
            CHECK_EQ(caught[i].a, vertex[i].a);
        }
    }
}

void suite_passes(void)
{
    RUN(accumulation_is_the_exact_weighted_average);
    RUN(returning_rounds_every_sum_once);
    RUN(sums_are_multiplied_by_a_fraction);
    RUN(accumulation_refuses_what_is_no_plane);
    RUN(offsets_take_every_row_and_column_once);
    RUN(the_jitter_sink_moves_every_vertex);
}
