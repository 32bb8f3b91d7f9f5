/* ports/host/scene_toolkit.c: the statements smooth and solid: round shapes, polygons and thick
 * lines. scene.c finds them by name, scene_draw.c calls what they append. */
#include "../../core/raster/stroke.h"
#include "scene_brush.h"

enum {
    POINTS = 256,
    EDGES = 8192
};

/* A shape as it was read, and its edges. */
struct toolkit {
    uint8_t rgb[3], opacity;
    const struct etch_scene_brush *brush;
    struct etch_smooth smooth;
    struct etch_polygon polygon;
    int16_t *cover;
};

/* A shape while it is read. */
struct shape {
    struct etch_scene_reader *reader;
    const struct etch_outline *outline;
};

static bool read_length(struct etch_scene_reader *reader, const char *name, int32_t *q8)
{
    return etch_scene_read_position(reader, name, q8) &&
           (*q8 >= 0 || etch_text_fail(&reader->text, "%s: below 0", name));
}

static bool read_point(struct etch_scene_reader *reader, struct etch_point_q8 *p)
{
    return etch_scene_read_position(reader, "x", &p->x) &&
           etch_scene_read_position(reader, "y", &p->y);
}

uint16_t etch_scene_read_points(struct etch_scene_reader *reader, struct etch_point_q8 *v,
                                uint16_t most, uint16_t least)
{
    struct etch_text ahead = reader->text;
    struct etch_word word;
    size_t words = 0;
    uint16_t n = 0;

    while (etch_text_more(&ahead) && etch_text_word(&ahead, "", &word)) {
        words++;
    }
    for (; words >= 5 && n < most; words -= 2, n++) {
        if (!read_point(reader, &v[n])) {
            return 0;
        }
    }
    if (n < least) {
        (void)etch_text_fail(&reader->text, "needs %d points", least);
        return 0;
    }
    return n;
}

/* ---- shapes: each reads its numbers and gives its edges ----------------------------------------
 */

static bool read_polygon(const struct shape *s)
{
    struct etch_point_q8 v[POINTS];
    const uint16_t n = etch_scene_read_points(s->reader, v, POINTS, 3);

    for (uint16_t i = 0; i < n; i++) {
        s->outline->edge(s->outline->shape, v[i], v[i + 1 == n ? 0 : i + 1]);
    }
    return n != 0;
}

static bool read_ellipse(const struct shape *s)
{
    struct etch_point_q8 centre;
    int32_t rx, ry;

    if (!read_point(s->reader, &centre) || !read_length(s->reader, "radius", &rx) ||
        !read_length(s->reader, "radius", &ry)) {
        return false;
    }
    etch_outline_ellipse(s->outline, centre, rx, ry, false);
    return true;
}

static bool read_arc(const struct shape *s)
{
    struct etch_point_q8 centre;
    int32_t outer, inner;
    int64_t from, sweep;

    if (!read_point(s->reader, &centre) || !read_length(s->reader, "outer", &outer) ||
        !read_length(s->reader, "inner", &inner) ||
        !etch_text_integer(&s->reader->text, "from", 0, 65535, &from) ||
        !etch_text_integer(&s->reader->text, "sweep", 0, 65536, &sweep)) {
        return false;
    }
    etch_outline_arc(s->outline, centre, outer, inner, (uint16_t)from, (uint32_t)sweep);
    return true;
}

static bool read_round_rect(const struct shape *s)
{
    struct etch_point_q8 a, b;
    int32_t radius;

    if (!read_point(s->reader, &a) || !read_point(s->reader, &b) ||
        !read_length(s->reader, "radius", &radius)) {
        return false;
    }
    etch_outline_round_rect(s->outline, a, b, radius);
    return true;
}

/* CAP JOIN WIDTH */
static bool read_style(struct etch_scene_reader *reader, struct etch_stroke *stroke)
{
    static const char *const caps[] = {"butt", "square", "round", NULL};
    static const char *const joins[] = {"miter", "bevel", "round", NULL};
    static etch_stroke_part *const cap[] = {etch_cap_butt, etch_cap_square, etch_cap_round};
    static etch_stroke_part *const join[] = {etch_join_miter, etch_join_bevel, etch_join_round};
    int c, j;

    if (!etch_text_choice(&reader->text, "cap", caps, &c) ||
        !etch_text_choice(&reader->text, "join", joins, &j) ||
        !read_length(reader, "width", &stroke->width_q8)) {
        return false;
    }
    stroke->cap = cap[c];
    stroke->join = join[j];
    stroke->miter_q8 = 1024;
    return true;
}

static bool read_stroke(const struct shape *s)
{
    struct etch_point_q8 v[POINTS];
    struct etch_stroke stroke;
    uint16_t n;

    if (!read_style(s->reader, &stroke)) {
        return false;
    }
    const bool closed = etch_scene_take(s->reader, "closed");

    n = etch_scene_read_points(s->reader, v, POINTS, 2);
    etch_stroke_outline(s->outline, v, n, closed, &stroke);
    return n != 0;
}

static bool read_dashes(const struct shape *s)
{
    struct etch_point_q8 v[POINTS];
    struct etch_stroke stroke;
    int32_t dash[2], phase;
    uint16_t n;

    if (!read_style(s->reader, &stroke) || !read_length(s->reader, "on", &dash[0]) ||
        !read_length(s->reader, "off", &dash[1]) || !read_length(s->reader, "phase", &phase)) {
        return false;
    }
    n = etch_scene_read_points(s->reader, v, POINTS, 2);
    etch_stroke_dashes(s->outline, v, n, &stroke, dash, 2, phase);
    return n != 0;
}

/* ---- drawing -----------------------------------------------------------------------------------
 */

static void draw_smooth(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct toolkit *t = step->of.data;
    struct etch_scene_brushed memory;
    const struct etch_cover_paint *paint = etch_scene_brush_cover(run, t->brush, t->rgb, t->opacity,
                                                                  &memory);
    const struct etch_scene_cover_counter counter = etch_scene_count_covers(run, paint);
    struct etch_smooth smooth = t->smooth;

    etch_smooth_fill_nonzero(&run->surface, &smooth, run->stats != NULL ? &counter.paint : paint,
                             t->cover);
}

static void draw_solid(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct toolkit *t = step->of.data;
    struct etch_scene_brushed memory;
    struct etch_polygon polygon = t->polygon;

    etch_polygon_runs_nonzero(&run->surface, &polygon,
                              etch_scene_brush_paint(run, t->brush, t->rgb, &memory));
}

/* ---- statements --------------------------------------------------------------------------------
 */

static const char *const names[] = {"polygon", "ellipse", "arc", "roundrect",
                                    "stroke",  "dashes",  NULL};
static bool (*const read_shape[])(const struct shape *s) = {
    read_polygon, read_ellipse, read_arc, read_round_rect, read_stroke, read_dashes};

/* SHAPE .. R G B: the edges go to the outline's polygon. */
static bool read_toolkit(struct etch_scene_reader *reader, struct toolkit *t,
                         const struct etch_outline *outline)
{
    const struct shape s = {reader, outline};
    int kind;

    t->brush = reader->brush;
    return etch_text_choice(&reader->text, "shape", names, &kind) && read_shape[kind](&s) &&
           ((t->smooth.status == ETCH_OK && t->polygon.status == ETCH_OK) ||
            etch_text_fail(&reader->text, "the shape needs more than %d edges", EDGES)) &&
           etch_scene_read_rgb(reader, t->rgb);
}

static bool read_smooth(struct etch_scene_reader *reader,
                        const struct etch_scene_statement *statement)
{
    struct etch_scene_step *step = etch_scene_append(reader, statement);
    struct toolkit *t = step != NULL ? etch_scene_data(reader, sizeof *t) : NULL;
    struct etch_smooth_edge *edge = t != NULL ? etch_scene_data(reader, EDGES * sizeof *edge)
                                              : NULL;

    if (edge == NULL || !etch_scene_read_byte(reader, "opacity", &t->opacity)) {
        return false;
    }
    step->needs = etch_scene_brush_needs(reader, true);
    t->cover = etch_scene_covers(reader);
    if (t->cover == NULL || step->needs == NULL) {
        return false;
    }
    step->of.data = t;
    etch_smooth_init(&t->smooth, edge, EDGES);

    const struct etch_outline outline = {etch_outline_smooth, &t->smooth};

    return read_toolkit(reader, t, &outline);
}

static bool read_solid(struct etch_scene_reader *reader,
                       const struct etch_scene_statement *statement)
{
    struct etch_scene_step *step = etch_scene_append(reader, statement);
    struct toolkit *t = step != NULL ? etch_scene_data(reader, sizeof *t) : NULL;
    struct etch_polygon_edge *edge = t != NULL ? etch_scene_data(reader, EDGES * sizeof *edge)
                                               : NULL;

    if (edge == NULL || (step->needs = etch_scene_brush_needs(reader, false)) == NULL) {
        return false;
    }
    step->of.data = t;
    etch_polygon_init(&t->polygon, edge, EDGES);

    const struct etch_outline outline = {etch_outline_polygon, &t->polygon};

    return read_toolkit(reader, t, &outline);
}

const struct etch_scene_statement etch_scene_toolkit_statements[] = {
    {"smooth", read_smooth, draw_smooth, "etch_smooth_fill_nonzero", NULL},
    {"solid", read_solid, draw_solid, "etch_polygon_runs_nonzero", NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
