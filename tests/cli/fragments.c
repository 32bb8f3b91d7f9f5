/* tests/cli: random triangles in random states, through scene files, against the definition of the
 * pipeline: colours within their bound, depths and stencil values exactly. Each also in strips, which
 * change nothing. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ports/host/scene.h"
#include "tests/harness/harness.h"
#include "tests/oracle/fragment.h"

void suite_fragments(void);

enum {
    WIDTH = 20,
    HEIGHT = 14,
    PIXELS = WIDTH * HEIGHT
};

static const char *const functions[] = {"off",     "never",    "less",   "equal", "lequal",
                                        "greater", "notequal", "gequal", "always"};
static const char *const operations[] = {"keep", "zero",   "replace",  "incr",
                                         "decr", "invert", "incrwrap", "decrwrap"};
static const char *const blends[] = {"off", "alpha", "add", "mul", "addalpha", "constant"};
static const char *const logics[] = {/* by truth table */
                                     "clear",      "nor",       "andinverted", "copyinverted",
                                     "andreverse", "invert",    "xor",         "nand",
                                     "and",        "equiv",     "noop",        "orinverted",
                                     "copy",       "orreverse", "or",          "set"};
static const char *const texs[] = {"off", "replace", "modulate", "decal"};
static const char *const wraps[] = {"repeat", "clamp", "mirror"};

static uint16_t texels[12];
static uint8_t texel_alpha[12];

/* One case: the state, the triangle, what is there before. */
struct sample {
    struct oracle_state state;
    struct oracle_vertex vertex[3];
    int32_t x[3], y[3]; /* 1/16 px */
    int cull, front, scissor[4];
    bool scissored, swapped;
    struct oracle_pixel before[PIXELS];
};

static struct sample sample;
static uint16_t pixels[PIXELS], depths[PIXELS];
static uint8_t stencils[PIXELS];
static uint32_t seed;
static int32_t compared, doubtful, drawn;

static int pick(int n)
{
    return test_range(&seed, 0, n - 1);
}

static bool often(int one_in)
{
    return pick(one_in) == 0;
}

static void make_state(struct oracle_state *s)
{
    const struct oracle_state plain = {.persp = !often(3),
                                       .zwrite = !often(4),
                                       .write_mask = 255,
                                       .atest = -1,
                                       .logic = -1,
                                       .color_mask = 0xFFFF,
                                       .texels = texels,
                                       .texel_alpha = texel_alpha};

    *s = plain;
    s->flat = often(4);
    s->ztest = often(2) ? pick(9) : 0;
    s->stencil = often(2) ? pick(9) : 0;
    s->reference = pick(256);
    s->mask = often(3) ? pick(256) : 255;
    s->write_mask = often(4) ? pick(256) : 255;
    for (int i = 0; i < 3; i++)
        s->operation[i] = pick(8);
    s->blend = often(2) ? pick(6) : 0;
    s->constant = pick(256);
    s->atest = often(4) ? pick(256) : -1;
    s->fog = often(4) ? 1 + pick(2) : 0;
    s->start = pick(40000);
    s->end = s->start + 1 + pick(25000);
    s->density = pick(4 * 65536);
    for (int i = 0; i < 3; i++)
        s->fog_rgb[i] = pick(256);
    s->logic = often(6) ? pick(16) : -1;
    s->color_mask = often(6) ? 0xF800 * pick(2) | 0x07E0 * pick(2) | 0x001F * pick(2) : 0xFFFF;
    s->tex = often(3) ? pick(4) : 0;
    s->wrap = pick(3);
    s->width = often(2) ? 3 : 4;
    s->height = often(2) ? 3 : 2;
}

static void make_sample(struct sample *s)
{
    const bool equal_w = often(3), flat_z = often(3);
    const int w = 1 + pick(30000), z = pick(65536), ratio = pick(16);

    make_state(&s->state);
    for (int i = 0; i < 3; i++) {
        struct oracle_vertex *v = &s->vertex[i];

        s->x[i] = test_range(&seed, -100, WIDTH * 16 + 100);
        s->y[i] = test_range(&seed, -100, HEIGHT * 16 + 100);
        v->z = flat_z ? z : pick(65536);
        v->w = (uint32_t)(equal_w ? w : 1 + pick(2 << (ratio < 14 ? ratio : 14)));
        for (int k = 0; k < 4; k++)
            v->rgba[k] = (uint8_t)(often(4) ? 255 * pick(2) : pick(256));
        v->u = test_range(&seed, -8 * 65536, 8 * 65536) / 4096 * 4096; /* 1/16 */
        v->v = test_range(&seed, -8 * 65536, 8 * 65536) / 4096 * 4096;
    }
    s->cull = often(4) ? pick(3) : 0;
    s->front = pick(2);
    s->scissored = often(4);
    s->scissor[0] = pick(WIDTH) - 3;
    s->scissor[1] = pick(HEIGHT) - 3;
    s->scissor[2] = pick(WIDTH);
    s->scissor[3] = pick(HEIGHT);
    s->swapped = often(4);
    for (int i = 0; i < 12; i++) {
        texels[i] = (uint16_t)pick(65536);
        texel_alpha[i] = (uint8_t)(often(3) ? 255 * pick(2) : pick(256));
    }
    for (int i = 0; i < PIXELS; i++) {
        s->before[i].color = (uint16_t)(often(4) ? 65535 * pick(2) : pick(65536));
        s->before[i].depth = (uint16_t)(flat_z && often(2) ? z : pick(65536));
        s->before[i].stencil = (uint8_t)(often(3) ? s->state.reference : pick(256));
    }
}

/* ---- the scene ---------------------------------------------------------------------------------- */

static int eight(int value, int full)
{
    return (2 * 255 * value + full) / (2 * full);
}

static void write_before(FILE *f, const struct sample *s)
{
    for (int i = 0; i < PIXELS; i++) {
        const struct oracle_pixel *p = &s->before[i];

        (void)fprintf(f, "point %d %d %d %d %d\n", i % WIDTH, i / WIDTH, eight(p->color >> 11, 31),
                      eight(p->color >> 5 & 63, 63), eight(p->color & 31, 31));
        if (s->state.ztest != 0 || s->state.stencil != 0)
            (void)fprintf(f,
                          "state scissor %d %d 1 1\ncleardepth %d\nclearstencil %d\n"
                          "state scissor off\n",
                          i % WIDTH, i / WIDTH, p->depth, p->stencil);
    }
}

static void write_texture(FILE *f, const struct oracle_state *s)
{
    (void)fprintf(f, "texture %d %d", s->width, s->height);
    for (int i = 0; i < s->width * s->height; i++)
        (void)fprintf(f, " %02X%02X%02X%02X", (unsigned)eight(s->texels[i] >> 11, 31),
                      (unsigned)eight(s->texels[i] >> 5 & 63, 63),
                      (unsigned)eight(s->texels[i] & 31, 31), s->texel_alpha[i]);
    (void)fprintf(f, "\nstate tex %s\nstate wrap %s\n", texs[s->tex], wraps[s->wrap]);
}

static void write_state(FILE *f, const struct sample *sample_)
{
    static const char *const culls[] = {"off", "back", "front"};
    const struct oracle_state *s = &sample_->state;

    (void)fprintf(f, "state shade %s\nstate persp %d\nstate ztest %s\nstate zwrite %d\n",
                  s->flat ? "flat" : "smooth", s->persp, functions[s->ztest], s->zwrite);
    (void)fprintf(f, "state cull %s\nstate front %s\n", culls[sample_->cull],
                  sample_->front != 0 ? "cw" : "ccw");
    if (sample_->scissored)
        (void)fprintf(f, "state scissor %d %d %d %d\n", sample_->scissor[0], sample_->scissor[1],
                      sample_->scissor[2], sample_->scissor[3]);
    if (s->stencil != 0)
        (void)fprintf(f, "state stencil %s %d %d %s %s %s\nstate stencilmask %d\n",
                      functions[s->stencil], s->reference, s->mask, operations[s->operation[0]],
                      operations[s->operation[1]], operations[s->operation[2]], s->write_mask);
    (void)fprintf(f, "state blend %s", blends[s->blend]);
    if (s->blend == 5)
        (void)fprintf(f, " %d", s->constant);
    if (s->atest >= 0)
        (void)fprintf(f, "\nstate atest %d", s->atest);
    if (s->fog == 1)
        (void)fprintf(f, "\nstate fog linear %d %d", s->start, s->end);
    if (s->fog == 2) /* five digits are 1/65536 to the nearest */
        (void)fprintf(f, "\nstate fog exp %d.%06d", (int)(s->density >> 16),
                      (int)((s->density & 65535) * 1000000 / 65536 + 1));
    if (s->fog != 0)
        (void)fprintf(f, " %d %d %d", s->fog_rgb[0], s->fog_rgb[1], s->fog_rgb[2]);
    (void)fprintf(f, "\nstate logic %s\nstate colormask %d %d %d\n",
                  s->logic >= 0 ? logics[s->logic] : "off", s->color_mask >> 15 & 1,
                  s->color_mask >> 10 & 1, s->color_mask & 1);
    write_texture(f, s);
}

static void write_scene(FILE *f, const struct sample *s)
{
    (void)fprintf(f, "scene %d %d\nfrac 4\nformat %s\n", WIDTH, HEIGHT,
                  s->swapped ? "rgb565_swapped" : "rgb565");
    write_before(f, s);
    write_state(f, s);
    (void)fprintf(f, "tri");
    for (int i = 0; i < 3; i++) {
        const struct oracle_vertex *v = &s->vertex[i];

        (void)fprintf(f, " %d %d %d %u %d %d %d %d %de-4 %de-4", s->x[i], s->y[i], v->z, v->w,
                      v->rgba[0], v->rgba[1], v->rgba[2], v->rgba[3], v->u / 4096 * 625,
                      v->v / 4096 * 625);
    }
    (void)fprintf(f, "\n");
}

/* Draws the scene in strips of `rows`. */
static bool draw(const struct sample *s, int rows)
{
    static struct etch_error error;
    const char *folder = getenv("TMPDIR");
    struct etch_scene scene;
    char path[512];
    FILE *file;
    bool ok;

    (void)snprintf(path, sizeof path, "%s/etch-fragments-%p.scene",
                   folder != NULL ? folder : "/tmp", (void *)&scene);
    file = fopen(path, "wb");
    if (!CHECK(file != NULL))
        return false;
    write_scene(file, s);
    (void)fclose(file);
    ok = etch_scene_open(&scene, path, &error);
    if (!CHECK(ok)) {
        test_print(error.text);
        return false;
    }
    (void)remove(path);
    for (int y = 0; y < HEIGHT; y += rows) {
        const struct etch_rect window = {0, (int16_t)y, WIDTH,
                                         (int16_t)(y + rows < HEIGHT ? y + rows : HEIGHT)};
        struct etch_surface surface;

        CHECK_EQ(etch_surface_init(&surface, pixels + y * WIDTH, window, WIDTH), ETCH_OK);
        surface.depth = depths + y * WIDTH;
        surface.stencil = stencils + y * WIDTH;
        CHECK(etch_scene_draw(&scene, &surface, NULL));
    }
    etch_scene_close(&scene);
    return true;
}

/* ---- comparing ------------------------------------------------------------------------------------ */

static bool is_culled(const struct sample *s)
{
    const int64_t area = (int64_t)(s->x[1] - s->x[0]) * (s->y[2] - s->y[0]) -
                         (int64_t)(s->x[2] - s->x[0]) * (s->y[1] - s->y[0]);
    const bool clockwise = area > 0, front = clockwise == (s->front != 0);

    return s->cull == (front ? 2 : 1);
}

static bool is_inside(const struct sample *s, int x, int y)
{
    return !s->scissored || (x >= s->scissor[0] && x < s->scissor[0] + s->scissor[2] &&
                             y >= s->scissor[1] && y < s->scissor[1] + s->scissor[3]);
}

static void note(const struct sample *s, int x, int y, const struct oracle_fragment *f)
{
    FILE *file = fopen("/tmp/etch-fragments-failed.scene", "wb");

    if (file != NULL) {
        write_scene(file, s);
        (void)fclose(file);
    }
    test_note("x", x);
    test_note("y", y);
    test_note("red", f->channel[0]);
    test_note("green", f->channel[1]);
    test_note("blue", f->channel[2]);
}

static void compare(const struct sample *s)
{
    const bool planes = s->state.ztest != 0 || s->state.stencil != 0;
    int32_t xs[3], ys[3];
    struct oracle_triangle t;

    for (int i = 0; i < 3; i++) {
        xs[i] = s->x[i] * 16;
        ys[i] = s->y[i] * 16;
    }
    oracle_triangle_make(&t, xs, ys);
    for (int i = 0; i < PIXELS && !test_failed(); i++) {
        const int x = i % WIDTH, y = i / WIDTH;
        const uint16_t color = (uint16_t)(s->swapped ? (pixels[i] << 8 | pixels[i] >> 8) & 0xFFFF
                                                     : pixels[i]);
        struct oracle_fragment f = {.pixel = s->before[i]};

        if (oracle_triangle_covers(&t, x, y) && is_inside(s, x, y) && !is_culled(s))
            oracle_fragment(&f, &s->state, &t, s->vertex, x, y, s->before[i]);
        compared++;
        doubtful += f.doubtful;
        drawn += f.drawn && !f.doubtful;
        if (f.doubtful)
            continue;
        /* 1/64 of a step, and what fog errs by */
        if (!CHECK(oracle_fragment_color_ok(&f, &s->state, s->before[i], color,
                                            ORACLE_ONE / (s->state.fog != 0 ? 48 : 64))) ||
            (planes &&
             (!CHECK_EQ(depths[i], f.pixel.depth) || !CHECK_EQ(stencils[i], f.pixel.stencil))))
            note(s, x, y, &f);
    }
}

static void states_are_their_definition(void)
{
    static uint16_t whole[2][PIXELS];
    static uint8_t whole_stencil[PIXELS];

    seed = 97;
    for (int32_t i = 0; i < TEST_COUNT(1500) && !test_failed(); i++) {
        make_sample(&sample);
        if (!draw(&sample, HEIGHT))
            return;
        compare(&sample);
        memcpy(whole[0], pixels, sizeof pixels);
        memcpy(whole[1], depths, sizeof depths);
        memcpy(whole_stencil, stencils, sizeof stencils);
        if (i % 4 == 0 && draw(&sample, 1 + i / 4 % 6))
            CHECK(memcmp(whole[0], pixels, sizeof pixels) == 0 &&
                  memcmp(whole[1], depths, sizeof depths) == 0 &&
                  memcmp(whole_stencil, stencils, sizeof stencils) == 0);
    }
    CHECK(doubtful * 4 < drawn);
}

void suite_fragments(void)
{
    compared = doubtful = drawn = 0;
    RUN(states_are_their_definition);
    test_print_count("", drawn, " fragments drawn in random states, as the pipeline defines them");
    test_print_count("", doubtful, " decided by less than their bound, not compared");
}
