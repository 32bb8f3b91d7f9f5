/* ports/host/scene_implicit.c: the statements bezier, quadric and implicit. scene.c finds them by
 * name, scene_draw.c calls what they append. */
#include "../../core/base/trig.h"
#include "../../core/fragment/flat.h"
#include "../../core/raster/curve.h"
#include "../../core/raster/implicit.h"
#include "../../core/raster/quadric.h"
#include "scene_steps.h"

/* Flat runs, counted if there are stats. */
static struct etch_flat_paint flat(struct etch_scene_run *run, const uint8_t rgb[3])
{
    const struct etch_flat_paint paint = {
        {run->stats != NULL ? etch_scene_count : etch_kernel_flat}, etch_scene_color(run, rgb)};

    run->kernel = etch_kernel_flat;
    return paint;
}

static bool read_numbers(struct etch_scene_reader *reader, const char *const names[], int16_t *at)
{
    for (int i = 0; names[i] != NULL; i++) {
        int64_t value;

        if (!etch_text_integer(&reader->text, names[i], INT16_MIN, INT16_MAX, &value)) {
            return false;
        }
        at[i] = (int16_t)value;
    }
    return true;
}

/* ---- curves --------------------------------------------------------------------------------- */

struct curve {
    struct etch_point p[4];
    uint8_t rgb[3];
};

static void draw_quadratic(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct curve *c = step->of.data;

    etch_quadratic_draw(&run->surface, c->p, etch_scene_color(run, c->rgb));
}

static void draw_cubic(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct curve *c = step->of.data;

    etch_cubic_draw(&run->surface, c->p, etch_scene_color(run, c->rgb));
}

/* quadratic X Y X Y X Y R G B | cubic X Y X Y X Y X Y R G B */
static bool read_bezier(struct etch_scene_reader *reader,
                        const struct etch_scene_statement *statement)
{
    static const struct etch_scene_statement rows[] = {
        {"bezier", NULL, draw_quadratic, "etch_quadratic_draw", NULL},
        {"bezier", NULL, draw_cubic, "etch_cubic_draw", NULL}};
    static const char *const kinds[] = {"quadratic", "cubic", NULL};
    static const char *const names[] = {"x", "y", NULL};
    struct etch_scene_step *step;
    struct curve *c;
    int kind;

    (void)statement;
    if (!etch_text_choice(&reader->text, "curve", kinds, &kind) ||
        (step = etch_scene_append(reader, &rows[kind])) == NULL ||
        (c = etch_scene_data(reader, sizeof *c)) == NULL) {
        return false;
    }
    step->of.data = c;
    for (int i = 0; i < 3 + kind; i++) {
        int16_t at[2];

        if (!read_numbers(reader, names, at)) {
            return false;
        }
        c->p[i] = (struct etch_point){at[0], at[1]};
    }
    return etch_scene_read_rgb(reader, c->rgb);
}

/* ---- quadrics ------------------------------------------------------------------------------- */

struct conic {
    struct etch_quadric q;
    uint8_t rgb[3];
};

static void draw_quadric(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct conic *c = step->of.data;
    const struct etch_flat_paint paint = flat(run, c->rgb);

    etch_quadric_runs(&run->surface, &c->q, &paint.paint);
}

/* A B C D E F R G B */
static bool read_quadric(struct etch_scene_reader *reader,
                         const struct etch_scene_statement *statement)
{
    static const char *const names[] = {"a", "b", "c", "d", "e", "f"};
    static const int bits[] = {30, 30, 30, 44, 44, 61};
    struct etch_scene_step *step = etch_scene_append(reader, statement);
    struct conic *c = step != NULL ? etch_scene_data(reader, sizeof *c) : NULL;
    int64_t v[6];

    for (int i = 0; c != NULL && i < 6; i++) {
        const int64_t limit = INT64_C(1) << bits[i];

        if (!etch_text_integer(&reader->text, names[i], -limit, limit, &v[i])) {
            return false;
        }
    }
    if (c == NULL) {
        return false;
    }
    c->q = (struct etch_quadric){(int32_t)v[0], (int32_t)v[1], (int32_t)v[2], v[3], v[4], v[5]};
    step->of.data = c;
    return etch_scene_read_rgb(reader, c->rgb);
}

/* ---- implicit shapes: two examples of functions of one's own --------------------------------- */

struct shape {
    struct etch_implicit of; /* first */
    uint8_t rgb[3];
    int32_t x, y, r; /* of a superellipse */
    int32_t step, level;
};

static int32_t cube(int32_t v)
{
    return v * v * v;
}

/* |dx|^3 + |dy|^3 - r^3; within the box |dx|, |dy| <= r <= 1000, so all sums fit 32 bits. */
static int32_t superellipse(const struct etch_implicit *of, int16_t x, int16_t y)
{
    const struct shape *s = (const struct shape *)(const void *)of;
    const int32_t dx = x < s->x ? s->x - x : x - s->x, dy = y < s->y ? s->y - y : y - s->y;

    return cube(dx) + (cube(dy) - cube(s->r));
}

/* The nearest (or the farthest) of lo .. hi from c. */
static int16_t pick(int32_t c, int32_t lo, int32_t hi, bool nearest)
{
    if (nearest && c >= lo && c <= hi) {
        return (int16_t)c;
    }
    return (int16_t)((c - lo < hi - c) == nearest ? lo : hi);
}

/* It grows with |dx| and |dy|: its bounds are at the nearest and the farthest pixel. */
static enum etch_implicit_side superellipse_side(const struct etch_implicit *of,
                                                 struct etch_rect tile)
{
    const struct shape *s = (const struct shape *)(const void *)of;
    int32_t bound[2];

    for (int i = 0; i < 2; i++) {
        bound[i] = superellipse(of, pick(s->x, tile.x0, tile.x1 - 1, i == 0),
                                pick(s->y, tile.y0, tile.y1 - 1, i == 0));
    }
    return etch_implicit_side_bounds(bound[0], bound[1]);
}

/* sin x + sin y - level */
static int32_t waves(const struct etch_implicit *of, int16_t x, int16_t y)
{
    const struct shape *s = (const struct shape *)(const void *)of;

    return etch_sin_q16((uint16_t)((x * s->step) & 0xFFFF)) +
           etch_sin_q16((uint16_t)((y * s->step) & 0xFFFF)) - s->level;
}

static void draw_implicit(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct shape *s = step->of.data;
    const struct etch_flat_paint paint = flat(run, s->rgb);

    etch_implicit_runs(&run->surface, &s->of, &paint.paint);
}

/* X Y RADIUS R G B */
static bool read_superellipse(struct etch_scene_reader *reader, struct shape *s)
{
    static const char *const names[] = {"x", "y", NULL};
    int16_t at[2];
    int64_t r;

    if (!read_numbers(reader, names, at) ||
        !etch_text_integer(&reader->text, "radius", 0, 1000, &r)) {
        return false;
    }
    s->of.value = superellipse;
    s->of.side = superellipse_side;
    s->x = at[0], s->y = at[1], s->r = (int32_t)r;
    s->of.box = etch_rect_from_size((int16_t)(at[0] < INT16_MIN + 1000 ? INT16_MIN : at[0] - s->r),
                                    (int16_t)(at[1] < INT16_MIN + 1000 ? INT16_MIN : at[1] - s->r),
                                    (int16_t)(2 * s->r + 1), (int16_t)(2 * s->r + 1));
    return etch_scene_read_rgb(reader, s->rgb);
}

/* PERIOD LEVEL R G B: a sine changes by at most 2 pi of its angle, and 1 for its rounding. */
static bool read_waves(struct etch_scene_reader *reader, struct shape *s)
{
    int64_t period, level;

    if (!etch_text_integer(&reader->text, "period", 2, 32767, &period) ||
        !etch_text_integer(&reader->text, "level", -200, 200, &level)) {
        return false;
    }
    s->step = (int32_t)(65536 / period);
    s->level = (int32_t)(level * 65536 / 100);
    s->of.value = waves;
    s->of.side = etch_implicit_side_slope;
    s->of.slope = (uint32_t)s->step * 7 + 1;
    s->of.box = (struct etch_rect){INT16_MIN, INT16_MIN, INT16_MAX, INT16_MAX};
    return etch_scene_read_rgb(reader, s->rgb);
}

static bool read_implicit(struct etch_scene_reader *reader,
                          const struct etch_scene_statement *statement)
{
    static const char *const kinds[] = {"superellipse", "waves", NULL};
    struct etch_scene_step *step = etch_scene_append(reader, statement);
    struct shape *s = step != NULL ? etch_scene_data(reader, sizeof *s) : NULL;
    int kind;

    if (s == NULL || !etch_text_choice(&reader->text, "implicit", kinds, &kind)) {
        return false;
    }
    step->of.data = s;
    return kind == 0 ? read_superellipse(reader, s) : read_waves(reader, s);
}

const struct etch_scene_statement etch_scene_implicit_statements[] = {
    {"bezier", read_bezier, NULL, NULL, NULL},
    {"quadric", read_quadric, draw_quadric, "etch_quadric_runs etch_kernel_flat", NULL},
    {"implicit", read_implicit, draw_implicit, "etch_implicit_runs etch_kernel_flat", NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
