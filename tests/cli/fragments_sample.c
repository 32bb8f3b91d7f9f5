/* tests/cli: random states and primitives, and the scenes that draw them. See fragments_sample.h.
 */
#include "fragments_sample.h"

#include <stdlib.h>

#include "ports/host/scene.h"
#include "tests/harness/harness.h"

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

static uint32_t *seed;

static int pick(int n)
{
    return test_range(seed, 0, n - 1);
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

void fragments_make(struct fragments_sample *s, enum fragments_kind kind, uint32_t *of)
{
    seed = of;
    s->kind = kind;
    s->size = often(4) ? 16 : 1 + pick(120);

    const bool equal_w = often(3), flat_z = often(3);
    const int w = 1 + pick(30000), z = pick(65536), ratio = pick(16);

    make_state(&s->state);
    for (int i = 0; i < 3; i++) {
        struct oracle_vertex *v = &s->vertex[i];

        s->x[i] = test_range(seed, -100, FRAGMENTS_WIDTH * 16 + 100);
        s->y[i] = test_range(seed, -100, FRAGMENTS_HEIGHT * 16 + 100);
        v->z = flat_z ? z : pick(65536);
        v->w = (uint32_t)(equal_w ? w : 1 + pick(2 << (ratio < 14 ? ratio : 14)));
        for (int k = 0; k < 4; k++)
            v->rgba[k] = (uint8_t)(often(4) ? 255 * pick(2) : pick(256));
        v->u = test_range(seed, -8 * 65536, 8 * 65536) / 4096 * 4096; /* 1/16 */
        v->v = test_range(seed, -8 * 65536, 8 * 65536) / 4096 * 4096;
    }
    s->cull = often(4) ? pick(3) : 0;
    s->front = pick(2);
    s->scissored = often(4);
    s->scissor[0] = pick(FRAGMENTS_WIDTH) - 3;
    s->scissor[1] = pick(FRAGMENTS_HEIGHT) - 3;
    s->scissor[2] = pick(FRAGMENTS_WIDTH);
    s->scissor[3] = pick(FRAGMENTS_HEIGHT);
    s->swapped = often(4);
    for (int i = 0; i < 12; i++) {
        texels[i] = (uint16_t)pick(65536);
        texel_alpha[i] = (uint8_t)(often(3) ? 255 * pick(2) : pick(256));
    }
    for (int i = 0; i < FRAGMENTS_PIXELS; i++) {
        s->before[i].color = (uint16_t)(often(4) ? 65535 * pick(2) : pick(65536));
        s->before[i].depth = (uint16_t)(flat_z && often(2) ? z : pick(65536));
        s->before[i].stencil = (uint8_t)(often(3) ? s->state.reference : pick(256));
    }
}

/* ---- the scene ----------------------------------------------------------------------------------
 */

static int eight(int value, int full)
{
    return (2 * 255 * value + full) / (2 * full);
}

static void write_before(FILE *f, const struct fragments_sample *s)
{
    for (int i = 0; i < FRAGMENTS_PIXELS; i++) {
        const struct oracle_pixel *p = &s->before[i];

        (void)fprintf(f, "point %d %d %d %d %d\n", i % FRAGMENTS_WIDTH, i / FRAGMENTS_WIDTH,
                      eight(p->color >> 11, 31), eight(p->color >> 5 & 63, 63),
                      eight(p->color & 31, 31));
        if (s->state.ztest != 0 || s->state.stencil != 0)
            (void)fprintf(f,
                          "state scissor %d %d 1 1\ncleardepth %d\nclearstencil %d\n"
                          "state scissor off\n",
                          i % FRAGMENTS_WIDTH, i / FRAGMENTS_WIDTH, p->depth, p->stencil);
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

static void write_state(FILE *f, const struct fragments_sample *sample_)
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

static void write_triangle(FILE *f, const struct fragments_sample *s)
{
    (void)fprintf(f, "tri");
    for (int i = 0; i < 3; i++) {
        const struct oracle_vertex *v = &s->vertex[i];

        (void)fprintf(f, " %d %d %d %u %d %d %d %d %de-4 %de-4", s->x[i], s->y[i], v->z, v->w,
                      v->rgba[0], v->rgba[1], v->rgba[2], v->rgba[3], v->u / 4096 * 625,
                      v->v / 4096 * 625);
    }
    (void)fprintf(f, "\n");
}

static void write_line(FILE *f, const struct fragments_sample *s)
{
    static const char *const names[] = {"", "cline", "wideline", "cpoint square", "cpoint round"};
    const int n = s->kind == FRAGMENTS_LINE || s->kind == FRAGMENTS_WIDE ? 2 : 1;

    (void)fprintf(f, "%s", names[s->kind]);
    if (s->kind != FRAGMENTS_LINE)
        (void)fprintf(f, " %de-4", s->size * 625);
    for (int i = 0; i < n; i++)
        (void)fprintf(f, " %d %d %d %d %d %d", s->x[i], s->y[i], s->vertex[i].z,
                      s->vertex[i].rgba[0], s->vertex[i].rgba[1], s->vertex[i].rgba[2]);
    (void)fprintf(f, " alpha");
    for (int i = 0; i < n; i++)
        (void)fprintf(f, " %d", s->vertex[i].rgba[3]);
    (void)fprintf(f, "\n");
}

static void write_scene(FILE *f, const struct fragments_sample *s)
{
    (void)fprintf(f, "scene %d %d\nfrac 4\nformat %s\n", FRAGMENTS_WIDTH, FRAGMENTS_HEIGHT,
                  s->swapped ? "rgb565_swapped" : "rgb565");
    write_before(f, s);
    write_state(f, s);
    if (s->kind == FRAGMENTS_TRI)
        write_triangle(f, s);
    else
        write_line(f, s);
}

bool fragments_draw(const struct fragments_sample *s, int rows, struct fragments_planes *planes)
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
    for (int y = 0; y < FRAGMENTS_HEIGHT; y += rows) {
        const struct etch_rect window = {
            0, (int16_t)y, FRAGMENTS_WIDTH,
            (int16_t)(y + rows < FRAGMENTS_HEIGHT ? y + rows : FRAGMENTS_HEIGHT)};
        struct etch_surface surface;

        CHECK_EQ(etch_surface_init(&surface, planes->color + y * FRAGMENTS_WIDTH, window,
                                   FRAGMENTS_WIDTH),
                 ETCH_OK);
        surface.depth = planes->depth + y * FRAGMENTS_WIDTH;
        surface.stencil = planes->stencil + y * FRAGMENTS_WIDTH;
        CHECK(etch_scene_draw(&scene, &surface, NULL));
    }
    etch_scene_close(&scene);
    return true;
}

bool fragments_is_inside(const struct fragments_sample *s, int x, int y)
{
    return !s->scissored || (x >= s->scissor[0] && x < s->scissor[0] + s->scissor[2] &&
                             y >= s->scissor[1] && y < s->scissor[1] + s->scissor[3]);
}

void fragments_keep(const struct fragments_sample *s)
{
    FILE *file = fopen("/tmp/etch-fragments-failed.scene", "wb");

    if (file != NULL) {
        write_scene(file, s);
        (void)fclose(file);
    }
}
