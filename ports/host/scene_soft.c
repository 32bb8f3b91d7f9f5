/* ports/host/scene_soft.c: the statement soft: smooth shapes without memory for edges. scene.c
 * finds it by name, scene_draw.c calls what it appends. */
#include "../../core/raster/smooth_shapes.h"
#include "scene_brush.h"

enum {
    NUMBERS = 6,
    POINTS = 256
};

struct shape;

struct kind {
    const char *name;
    void (*draw)(const struct shape *shape, const struct etch_surface *s,
                 const struct etch_cover_paint *paint);
    const char *numbers[NUMBERS + 1]; /* "from" to 65535, "sweep" to 65536, others in 2^-frac px */
    struct etch_scene_statement statement;
};

/* A shape as it was read. */
struct shape {
    const struct kind *kind;
    int32_t at[NUMBERS];
    uint8_t rgb[3], opacity;
    const struct etch_scene_brush *brush;
    int16_t *cover;
    uint16_t count; /* of a polygon */
    struct etch_point_q8 *v;
    struct etch_smooth_edge *edge;
};

/* ---- the shapes --------------------------------------------------------------------------------
 */

#define SHAPE(name, call)                                                                          \
    static void name(const struct shape *p, const struct etch_surface *s,                          \
                     const struct etch_cover_paint *paint)                                         \
    {                                                                                              \
        const int32_t *const at = p->at;                                                           \
                                                                                                   \
        call;                                                                                      \
    }

static struct etch_point_q8 point(const int32_t *at)
{
    const struct etch_point_q8 p = {at[0], at[1]};

    return p;
}

SHAPE(disc, etch_smooth_disc(s, point(at), at[2], paint, p->cover))
SHAPE(circle, etch_smooth_circle(s, point(at), at[2], at[3], paint, p->cover))
SHAPE(ring, etch_smooth_ring(s, point(at), at[2], at[3], paint, p->cover))
SHAPE(arc, etch_smooth_arc(s, point(at), at[2], at[3], (uint16_t)at[4], (uint32_t)at[5], paint,
                           p->cover))
SHAPE(round_rect, etch_smooth_round_rect(s, point(at), point(at + 2), at[4], paint, p->cover))
SHAPE(frame, etch_smooth_round_frame(s, point(at), point(at + 2), at[4], at[5], paint, p->cover))
SHAPE(line, etch_smooth_line(s, point(at), point(at + 2), at[4], paint, p->cover))
SHAPE(round_line, etch_smooth_line_round(s, point(at), point(at + 2), at[4], paint, p->cover))

static void polygon(const struct shape *p, const struct etch_surface *s,
                    const struct etch_cover_paint *paint)
{
    (void)etch_smooth_polygon(s, p->v, p->count, p->edge, p->count, paint, p->cover);
}

/* ---- drawing -----------------------------------------------------------------------------------
 */

static void draw_shape(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct shape *shape = step->of.data;
    struct etch_scene_brushed memory;
    const struct etch_cover_paint *paint = etch_scene_brush_cover(run, shape->brush, shape->rgb,
                                                                  shape->opacity, &memory);
    const struct etch_scene_cover_counter counter = etch_scene_count_covers(run, paint);

    shape->kind->draw(shape, &run->surface, run->stats != NULL ? &counter.paint : paint);
}

#define NEEDS(function)                                                                            \
    {                                                                                              \
        "soft", NULL, draw_shape, function, NULL                                                   \
    }

static const struct kind kinds[] = {
    {"disc", disc, {"x", "y", "radius"}, NEEDS("etch_smooth_disc")},
    {"circle", circle, {"x", "y", "radius", "width"}, NEEDS("etch_smooth_circle")},
    {"ring", ring, {"x", "y", "outer", "inner"}, NEEDS("etch_smooth_ring")},
    {"arc", arc, {"x", "y", "outer", "inner", "from", "sweep"}, NEEDS("etch_smooth_arc")},
    {"roundrect", round_rect, {"x0", "y0", "x1", "y1", "radius"}, NEEDS("etch_smooth_round_rect")},
    {"frame", frame, {"x0", "y0", "x1", "y1", "radius", "width"}, NEEDS("etch_smooth_round_frame")},
    {"line", line, {"x0", "y0", "x1", "y1", "width"}, NEEDS("etch_smooth_line")},
    {"roundline", round_line, {"x0", "y0", "x1", "y1", "width"}, NEEDS("etch_smooth_line_round")},
    {"polygon", polygon, {NULL}, NEEDS("etch_smooth_polygon")},
};

/* ---- reading -----------------------------------------------------------------------------------
 */

static const struct kind *read_kind(struct etch_scene_reader *reader)
{
    static const char *names[sizeof kinds / sizeof kinds[0] + 1];
    int kind;

    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++) {
        names[i] = kinds[i].name;
    }
    return etch_text_choice(&reader->text, "shape", names, &kind) ? &kinds[kind] : NULL;
}

static bool read_number(struct etch_scene_reader *reader, const char *name, int32_t *at)
{
    const bool is_angle = name[0] == 'f', is_sweep = name[0] == 's'; /* from, sweep */
    int64_t value;

    if (!is_angle && !is_sweep) {
        return etch_scene_read_position(reader, name, at);
    }
    if (!etch_text_integer(&reader->text, name, 0, is_angle ? UINT16_MAX : 65536, &value)) {
        return false;
    }
    *at = (int32_t)value;
    return true;
}

static bool read_polygon(struct etch_scene_reader *reader, struct shape *shape)
{
    shape->v = etch_scene_data(reader, POINTS * sizeof *shape->v);
    shape->edge = etch_scene_data(reader, POINTS * sizeof *shape->edge);
    shape->count = shape->v != NULL && shape->edge != NULL
                       ? etch_scene_read_points(reader, shape->v, POINTS, 3)
                       : 0;
    return shape->count != 0;
}

static bool read_soft(struct etch_scene_reader *reader,
                      const struct etch_scene_statement *statement)
{
    struct shape *shape = etch_scene_data(reader, sizeof *shape);
    struct etch_scene_step *step;

    (void)statement;
    if (shape == NULL || !etch_scene_read_byte(reader, "opacity", &shape->opacity) ||
        (shape->kind = read_kind(reader)) == NULL) {
        return false;
    }
    step = etch_scene_append(reader, &shape->kind->statement);
    shape->cover = etch_scene_covers(reader);
    if (step == NULL || shape->cover == NULL ||
        (step->needs = etch_scene_brush_needs(reader, true)) == NULL) {
        return false;
    }
    step->of.data = shape;
    shape->brush = reader->brush;
    for (int i = 0; shape->kind->numbers[i] != NULL; i++) {
        if (!read_number(reader, shape->kind->numbers[i], &shape->at[i])) {
            return false;
        }
    }
    return (shape->kind->draw != polygon || read_polygon(reader, shape)) &&
           etch_scene_read_rgb(reader, shape->rgb);
}

const struct etch_scene_statement etch_scene_soft_statements[] = {
    {"soft", read_soft, NULL, NULL, NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
