/* tests/fuzz: bytes to arguments, hostile ones more often than others; see calls.h. */
#include "calls.h"

uint8_t fuzz_byte(struct fuzz_calls *c)
{
    return c->at < c->end ? *c->at++ : 0;
}

uint16_t fuzz_word(struct fuzz_calls *c)
{
    const uint16_t low = fuzz_byte(c);

    return (uint16_t)(low | (uint16_t)fuzz_byte(c) << 8);
}

uint32_t fuzz_long(struct fuzz_calls *c)
{
    const uint32_t low = fuzz_word(c);

    return low | (uint32_t)fuzz_word(c) << 16;
}

uint16_t fuzz_below(struct fuzz_calls *c, uint16_t n)
{
    return (uint16_t)(n <= 256 ? fuzz_byte(c) % n : fuzz_word(c) % n);
}

/* Two thirds are beside `near`, the others at the ends of the range or anywhere. */
static int16_t coordinate(struct fuzz_calls *c, int16_t near)
{
    static const int16_t end[] = {INT16_MIN, INT16_MIN + 1, -16384, -1, 0, 16383, 32766, INT16_MAX};
    const uint8_t kind = fuzz_byte(c);
    int32_t v;

    if (kind >= 192) {
        return end[kind % 8];
    }
    if (kind >= 168) {
        return (int16_t)fuzz_word(c);
    }
    v = (int32_t)near + kind % 64 - 12;
    return (int16_t)(v > INT16_MAX ? INT16_MAX : v);
}

int16_t fuzz_x(struct fuzz_calls *c)
{
    return coordinate(c, c->s.window.x0);
}

int16_t fuzz_y(struct fuzz_calls *c)
{
    return coordinate(c, c->s.window.y0);
}

int16_t fuzz_size(struct fuzz_calls *c)
{
    return coordinate(c, 8);
}

static int32_t coordinate_q8(struct fuzz_calls *c, int16_t near)
{
    const uint8_t fraction = fuzz_byte(c);
    const int32_t v = coordinate(c, near) * INT32_C(256);

    if (fraction == 255 && v > 8000000) {
        return 8388608;
    }
    return v + (fraction < 64 ? 128 : fraction < 128 ? 0 : fraction);
}

int32_t fuzz_x_q8(struct fuzz_calls *c)
{
    return coordinate_q8(c, c->s.window.x0);
}

int32_t fuzz_y_q8(struct fuzz_calls *c)
{
    return coordinate_q8(c, c->s.window.y0);
}

int32_t fuzz_s32(struct fuzz_calls *c)
{
    static const int32_t end[] = {INT32_MIN, INT32_MIN + 1, -65536,        -1,
                                  0,         65536,         INT32_MAX - 1, INT32_MAX};
    const uint8_t kind = fuzz_byte(c);

    if (kind >= 224) {
        return end[kind % 8];
    }
    if (kind >= 160) {
        return (int32_t)fuzz_long(c);
    }
    if (kind >= 80) {
        return fuzz_word(c) - 32768;
    }
    return kind - 8;
}

struct etch_rect fuzz_rect(struct fuzz_calls *c)
{
    const int16_t x0 = fuzz_x(c), y0 = fuzz_y(c), x1 = fuzz_x(c), y1 = fuzz_y(c);

    return (struct etch_rect){x0, y0, x1, y1};
}

struct etch_vertex fuzz_vertex(struct fuzz_calls *c)
{
    struct etch_vertex v = {.x_q8 = fuzz_x_q8(c), .y_q8 = fuzz_y_q8(c)};
    const uint8_t depth = fuzz_byte(c);

    v.z_q16 = depth < 64    ? 0
              : depth < 128 ? UINT32_C(0xFFFF0000)
                            : (uint32_t)depth << 16 | (uint32_t)depth << 8;
    if (depth >= 192) {
        v.z_q16 = fuzz_long(c) % (UINT32_C(0xFFFF0000) + 1);
    }
    v.r = fuzz_byte(c);
    v.g = fuzz_byte(c);
    v.b = (uint8_t)(v.r ^ v.g);
    v.a = (uint8_t)(depth * 3);
    return v;
}

/* ---- paints that look ------------------------------------------------------------------------ */

struct watching {
    struct etch_paint paint;
    uint16_t color;
};

/* Runs lie inside the clip, in rows that do, none backwards. */
static void watch(const struct etch_surface *s, int16_t y0, const struct etch_run *runs, uint8_t n,
                  const struct etch_paint *paint)
{
    const struct watching *w = (const struct watching *)(const void *)paint;

    if (n < 1 || n > ETCH_RUN_BLOCK || y0 < s->clip.y0 || y0 + n > s->clip.y1) {
        fuzz_fail("rows outside the clip");
    }
    for (uint8_t i = 0; i < n; i++) {
        if (runs[i].x0 > runs[i].x1 ||
            (runs[i].x0 < runs[i].x1 && (runs[i].x0 < s->clip.x0 || runs[i].x1 > s->clip.x1))) {
            fuzz_fail("a run outside the clip");
        }
        for (int16_t x = runs[i].x0; x < runs[i].x1; x++) {
            s->pixels[etch_surface_index(s, x, (int16_t)(y0 + i))] = w->color;
        }
    }
}

const struct etch_paint *fuzz_paint(struct fuzz_calls *c)
{
    static struct watching paint;

    paint = (struct watching){{watch}, fuzz_word(c)};
    return &paint.paint;
}

static void watch_covers(const struct etch_surface *s, int16_t x, int16_t y, uint16_t n,
                         const int16_t *cover, const struct etch_cover_paint *paint)
{
    static const struct etch_cover_flat_paint red = {{etch_cover_flat}, 0xF800, 200};

    (void)paint;
    if (n < 1 || y < s->clip.y0 || y >= s->clip.y1 || x < s->clip.x0 || x + n > s->clip.x1) {
        fuzz_fail("covers outside the clip");
    }
    for (uint16_t i = 0; i < n; i++) {
        if (cover[i] < 1 || cover[i] > ETCH_COVER_ONE) {
            fuzz_fail("a cover that is none");
        }
    }
    (n % 2 == 0 ? etch_cover_flat : etch_cover_flat_swapped)(s, x, y, n, cover, &red.paint);
}

const struct etch_cover_paint *fuzz_cover_paint(struct fuzz_calls *c)
{
    static const struct etch_cover_paint paint = {watch_covers};

    (void)c;
    return &paint;
}
