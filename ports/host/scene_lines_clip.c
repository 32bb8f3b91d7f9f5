/* ports/host/scene_lines_clip.c: lines, polygons and triangles cut as geometry. scene.c finds the
 * statements by name, scene_draw.c calls what they append. */
#include "../../core/fragment/flat.h"
#include "../../core/raster/clip_polygon.h"
#include "../../core/raster/line_runs.h"
#include "../../core/raster/polygon.h"
#include "../../core/vertex/clip_line.h"
#include "../../core/vertex/clip_volume.h"
#include "scene_lines.h"

#define POLYGON_MOST 64

/* What a step keeps of a 2D statement: bounds, vertices and colour. */
struct shape {
    struct etch_bounds bounds;
    bool liang_barsky;
    uint8_t rgb[3];
    int n;
    struct etch_point_s32 p[POLYGON_MOST];
};

/* .. and of one in clip space. */
struct volume {
    bool all_planes;
    struct etch_clip_vertex v[3];
};

static etch_scene_draw_function draw_clipline, draw_cvline, draw_cvtri;

/* What a step draws with follows from its first word. */
enum {
    COHEN,
    LIANG,
    LINE_GUARD,
    LINE_VOLUME,
    TRIANGLE_GUARD,
    TRIANGLE_VOLUME
};

static const struct etch_scene_statement variant[] = {
    {"clipline", NULL, draw_clipline, "etch_line_clip_cohen_sutherland", NULL},
    {"clipline", NULL, draw_clipline, "etch_line_clip_liang_barsky", NULL},
    {"cvline", NULL, draw_cvline, "etch_clip_line", NULL},
    {"cvline", NULL, draw_cvline, "etch_clip_line_volume", NULL},
    {"cvtri", NULL, draw_cvtri, "etch_assemble_triangle", NULL},
    {"cvtri", NULL, draw_cvtri, "etch_assemble_triangle_volume", NULL},
};

static bool read_pixel(struct etch_scene_reader *reader, const char *name, int32_t *value)
{
    int64_t v;

    if (!etch_text_integer(&reader->text, name, INT16_MIN, INT16_MAX, &v)) {
        return false;
    }
    *value = (int32_t)v;
    return true;
}

/* One of two words. */
static bool read_choice(struct etch_scene_reader *reader, const char *first, const char *second,
                        bool *is_second)
{
    *is_second = etch_scene_take(reader, second);
    return *is_second || etch_scene_take(reader, first) ||
           etch_text_fail(&reader->text, "%s or %s is missing", first, second);
}

/* LEFT TOP RIGHT BOTTOM: the first and last pixels inside */
static bool read_bounds(struct etch_scene_reader *reader, struct etch_bounds *b)
{
    if (!read_pixel(reader, "left", &b->x0) || !read_pixel(reader, "top", &b->y0) ||
        !read_pixel(reader, "right", &b->x1) || !read_pixel(reader, "bottom", &b->y1)) {
        return false;
    }
    return (b->x0 <= b->x1 && b->y0 <= b->y1) ||
           etch_text_fail(&reader->text, "the bounds are empty");
}

static bool read_point(struct etch_scene_reader *reader, struct shape *s)
{
    if (s->n == POLYGON_MOST) {
        return etch_text_fail(&reader->text, "more than %d vertices", POLYGON_MOST);
    }
    return read_pixel(reader, "x", &s->p[s->n].x) && read_pixel(reader, "y", &s->p[s->n++].y);
}

/* ---- clipline ------------------------------------------------------------------------------ */

static bool read_clipline(struct etch_scene_reader *reader,
                          const struct etch_scene_statement *statement)
{
    struct etch_scene_step *step = etch_scene_append(reader, statement);
    struct shape *s = step != NULL ? etch_scene_data(reader, sizeof *s) : NULL;

    if (s == NULL || !read_choice(reader, "cohen", "liang", &s->liang_barsky)) {
        return false;
    }
    step->of.data = s;
    step->statement = &variant[s->liang_barsky ? LIANG : COHEN];
    return read_bounds(reader, &s->bounds) && read_point(reader, s) && read_point(reader, s) &&
           etch_scene_read_rgb(reader, s->rgb);
}

static void draw_clipline(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct shape *s = step->of.data;
    struct etch_point_s32 p[2] = {s->p[0], s->p[1]};
    struct etch_flat_paint paint = {{etch_scene_flat(run)}, etch_scene_color(run, s->rgb)};

    if (s->liang_barsky ? etch_line_clip_liang_barsky(&s->bounds, p)
                        : etch_line_clip_cohen_sutherland(&s->bounds, p)) {
        etch_line_runs(&run->surface, (int16_t)p[0].x, (int16_t)p[0].y, (int16_t)p[1].x,
                       (int16_t)p[1].y, &paint.paint);
    }
}

/* ---- clippolygon --------------------------------------------------------------------------- */

static bool read_clippolygon(struct etch_scene_reader *reader,
                             const struct etch_scene_statement *statement)
{
    struct etch_scene_step *step = etch_scene_append(reader, statement);
    struct shape *s = step != NULL ? etch_scene_data(reader, sizeof *s) : NULL;

    if (s == NULL || !read_bounds(reader, &s->bounds) || !etch_scene_read_rgb(reader, s->rgb)) {
        return false;
    }
    step->of.data = s;
    while (s->n < 3 || etch_text_more(&reader->text)) {
        if (!read_point(reader, s)) {
            return false;
        }
    }
    return true;
}

/* The polygon that the pipeline's vertices go to, edge by edge. */
struct filling {
    struct etch_polygon polygon;
    struct etch_polygon_edge edge[POLYGON_MOST * 5 + 8];
    struct etch_point_q8 first, last;
    bool any;
};

static void take_vertex(void *context, struct etch_point_s32 p)
{
    struct filling *f = context;
    const struct etch_point_q8 at = {p.x, p.y};

    if (f->any) {
        (void)etch_polygon_add_edge(&f->polygon, f->last, at);
    } else {
        f->first = at;
    }
    f->any = true;
    f->last = at;
}

/* Sides of the rectangle run round its pixels; vertices are pixel centres. Both in 1/256 px. */
static void draw_clippolygon(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct shape *s = step->of.data;
    const struct etch_bounds bounds = {s->bounds.x0 * 256, s->bounds.y0 * 256,
                                       s->bounds.x1 * 256 + 256, s->bounds.y1 * 256 + 256};
    const struct etch_flat_paint paint = {{etch_scene_flat(run)}, etch_scene_color(run, s->rgb)};
    struct etch_clip_polygon clip;
    struct filling f;

    f.any = false;
    etch_polygon_init(&f.polygon, f.edge, sizeof f.edge / sizeof f.edge[0]);
    etch_clip_polygon_begin(&clip, &bounds, take_vertex, &f);
    for (int i = 0; i < s->n; i++) {
        const struct etch_point_s32 p = {s->p[i].x * 256 + 128, s->p[i].y * 256 + 128};

        etch_clip_polygon_vertex(&clip, p);
    }
    etch_clip_polygon_end(&clip);
    if (f.any) {
        (void)etch_polygon_add_edge(&f.polygon, f.last, f.first);
        etch_polygon_runs_evenodd(&run->surface, &f.polygon, &paint.paint);
    }
}

/* ---- clip space ---------------------------------------------------------------------------- */

/* X Y Z W r g b */
static bool read_clip_vertex(struct etch_scene_reader *reader, struct etch_clip_vertex *v)
{
    uint8_t rgb[3];

    if (!etch_text_q16(&reader->text, "x", &v->x) || !etch_text_q16(&reader->text, "y", &v->y) ||
        !etch_text_q16(&reader->text, "z", &v->z) || !etch_text_q16(&reader->text, "w", &v->w) ||
        !etch_scene_read_rgb(reader, rgb)) {
        return false;
    }
    v->r = rgb[0], v->g = rgb[1], v->b = rgb[2], v->a = 255;
    return true;
}

/* guard|volume V V [V] [alpha A A [A]] */
static bool read_volume(struct etch_scene_reader *reader,
                        const struct etch_scene_statement *statement)
{
    struct etch_scene_step *step = etch_scene_append(reader, statement);
    struct volume *v = step != NULL ? etch_scene_data(reader, sizeof *v) : NULL;
    const bool is_line = statement->name[2] == 'l';

    if (v == NULL || !read_choice(reader, "guard", "volume", &v->all_planes)) {
        return false;
    }
    uint8_t *const alpha[3] = {&v->v[0].a, &v->v[1].a, &v->v[2].a};

    step->of.data = v;
    step->statement = &variant[(is_line ? LINE_GUARD : TRIANGLE_GUARD) + v->all_planes];
    for (int i = 0; i < (is_line ? 2 : 3); i++) {
        if (!read_clip_vertex(reader, &v->v[i])) {
            return false;
        }
    }
    if (!etch_scene_read_alphas(reader, alpha, is_line ? 2 : 3)) {
        return false;
    }
    for (int i = 1; i < 3 && reader->state.shade == 1; i++) { /* flat */
        v->v[i].r = v->v[0].r, v->v[i].g = v->v[0].g;
        v->v[i].b = v->v[0].b, v->v[i].a = v->v[0].a;
    }
    return etch_scene_lines_pipeline(reader, step, is_line ? ETCH_SCENE_LINE : ETCH_SCENE_VOLUME);
}

static struct etch_viewport whole_frame(const struct etch_scene_run *run)
{
    const struct etch_rect frame = {0, 0, run->scene->width, run->scene->height};
    struct etch_viewport viewport;

    (void)etch_viewport_init(&viewport, frame);
    return viewport;
}

static void draw_cvline(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct volume *v = step->of.data;
    const struct etch_viewport viewport = whole_frame(run);
    struct etch_clip_vertex cut[2];
    struct etch_vertex p[2];

    if (v->all_planes ? etch_clip_line_volume(v->v, cut) : etch_clip_line(&viewport, v->v, cut)) {
        etch_viewport_project(&viewport, &cut[0], &p[0]);
        etch_viewport_project(&viewport, &cut[1], &p[1]);
        etch_scene_paint_line(run, step, p);
    }
}

static void draw_cvtri(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct volume *v = step->of.data;
    struct etch_scene_sink sink;
    struct etch_assembly assembly = {
        .viewport = whole_frame(run), .cull = ETCH_CULL_NONE, .sink = &sink.raster.sink};

    etch_scene_sink_init(&sink, run, step->pipeline);
    (v->all_planes ? etch_assemble_triangle_volume : etch_assemble_triangle)(&assembly, v->v);
}

/* ---- the table --------------------------------------------------------------------------- */

const struct etch_scene_statement etch_scene_line_clip_statements[] = {
    {"clipline", read_clipline, NULL, NULL, NULL},
    {"clippolygon", read_clippolygon, draw_clippolygon, "etch_clip_polygon_vertex", NULL},
    {"cvline", read_volume, NULL, NULL, NULL},
    {"cvtri", read_volume, NULL, NULL, NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
