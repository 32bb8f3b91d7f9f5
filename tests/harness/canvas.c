/* tests/harness: the guarded surface and its pictures. Called by the suites. See canvas.h. */
#include "canvas.h"

#include "stores.h"

static void open(struct test_canvas *c, struct etch_rect window, uint16_t gap)
{
    const uint16_t width = (uint16_t)(window.x1 - window.x0);
    const uint16_t stride = (uint16_t)(width + gap);
    const int32_t height = (int32_t)window.y1 - window.y0;

    if (!CHECK(stride * height <= TEST_CANVAS_WORDS)) /* then what fits: nothing is spoiled */
        window.y1 = (int16_t)(window.y0 + (int16_t)(TEST_CANVAS_WORDS / stride));
    CHECK_EQ(etch_surface_init(&c->surface, c->pixels + TEST_GUARD_WORDS, window, stride), ETCH_OK);
    c->surface.depth = c->depth + TEST_GUARD_WORDS;
    test_canvas_wipe(c);
}

void test_canvas_open(struct test_canvas *c, struct etch_rect window)
{
    open(c, window, TEST_GAP);
}

void test_canvas_open_tight(struct test_canvas *c, struct etch_rect window)
{
    open(c, window, 0);
}

void test_canvas_clip(struct test_canvas *c, struct etch_rect clip)
{
    etch_surface_clip(&c->surface, clip);
    test_canvas_wipe(c);
}

void test_canvas_wipe(struct test_canvas *c)
{
    const struct etch_surface *s = &c->surface;
    size_t i;
    int32_t x, y;

    for (i = 0; i < sizeof c->pixels / sizeof c->pixels[0]; i++) {
        c->pixels[i] = TEST_GUARD;
        c->depth[i] = TEST_GUARD;
    }
    for (y = s->clip.y0; y < s->clip.y1; y++) {
        const size_t row = etch_surface_index(s, s->clip.x0, (int16_t)y);

        for (x = 0; x < s->clip.x1 - s->clip.x0; x++) {
            s->pixels[row + (size_t)x] = TEST_BACKGROUND;
            s->depth[row + (size_t)x] = UINT16_MAX;
        }
    }
    test_stores_watch(c);
}

uint16_t test_canvas_at(const struct test_canvas *c, int32_t x, int32_t y)
{
    return c->surface.pixels[etch_surface_index(&c->surface, (int16_t)x, (int16_t)y)];
}

bool test_canvas_drawn(const struct test_canvas *c, int32_t x, int32_t y)
{
    const struct etch_rect clip = c->surface.clip;

    return x >= clip.x0 && x < clip.x1 && y >= clip.y0 && y < clip.y1 &&
           test_canvas_at(c, x, y) != TEST_BACKGROUND;
}

static uint32_t mix_wrap(uint32_t hash, uint32_t v)
{
    hash = (hash ^ v) * UINT32_C(0x01000193);
    return hash ^ hash >> 15;
}

uint32_t test_canvas_hash(const struct test_canvas *c)
{
    const struct etch_surface *s = &c->surface;
    uint32_t hash = 1;
    int32_t x, y;

    for (y = s->window.y0; y < s->window.y1; y++) {
        for (x = s->window.x0; x < s->window.x1; x++) {
            const size_t i = etch_surface_index(s, (int16_t)x, (int16_t)y);

            hash = mix_wrap(hash, (uint32_t)s->pixels[i] << 16 | s->depth[i]);
        }
    }
    return hash;
}

/* Elements of the planes that do not hold the guard word, less the area of the clip. */
static bool guard_words_intact(const struct test_canvas *c)
{
    const struct etch_surface *s = &c->surface;
    const size_t first = TEST_GUARD_WORDS;
    size_t i = 0;
    int32_t y;

    for (y = s->clip.y0; y <= s->clip.y1; y++) {
        size_t end = sizeof c->pixels / sizeof c->pixels[0];

        if (y < s->clip.y1)
            end = first + etch_surface_index(s, s->clip.x0, (int16_t)y);
        for (; i < end; i++)
            if (c->pixels[i] != TEST_GUARD || c->depth[i] != TEST_GUARD)
                return false;
        i += (size_t)(s->clip.x1 - s->clip.x0);
    }
    return true;
}

bool test_canvas_check(const struct test_canvas *c, bool once, const char *file, int line)
{
    bool ok = test_check(guard_words_intact(c), "nothing written outside the clip", file, line);
    size_t i;

    ok = test_check(!c->strayed, "no store outside the clip", file, line) && ok;
    if (!TEST_STORES || !once)
        return ok;
    for (i = 0; i < TEST_CANVAS_WORDS && c->stores[i] <= 1; i++)
        continue;
    return test_check(i == TEST_CANVAS_WORDS, "each pixel stored once", file, line) && ok;
}

static char letter(const struct test_canvas *c, int32_t x, int32_t y)
{
    const uint16_t color = test_canvas_at(c, x, y);

    if (!test_canvas_drawn(c, x, y))
        return '.';
    return color >= 1 && color <= 26 ? (char)('a' + color - 1) : '#';
}

/* `picture` is width x height letters. */
static bool same_picture(const struct test_canvas *c, const char *picture)
{
    const struct etch_rect w = c->surface.window;
    int32_t x, y;

    for (y = w.y0; y < w.y1; y++)
        for (x = w.x0; x < w.x1; x++)
            if (*picture++ != letter(c, x, y)) /* also at the end of a short picture */
                return false;
    return *picture == 0;
}

bool test_picture(const struct test_canvas *c, const char *picture, const char *file, int line)
{
    const struct etch_rect w = c->surface.window;
    const bool same = same_picture(c, picture);
    char text[2] = {0, 0};
    int32_t x, y;

    test_check(same, "the picture", file, line);
    for (y = w.y0; !same && y < w.y1; y++) {
        test_write("     drawn ");
        for (x = w.x0; x < w.x1; x++) {
            text[0] = letter(c, x, y);
            test_write(text);
        }
        test_write("   expected ");
        for (x = w.x0; x < w.x1 && *picture != 0; x++) {
            text[0] = *picture++;
            test_write(text);
        }
        test_write("\n");
    }
    return same;
}
