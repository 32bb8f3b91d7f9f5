/* ports/host/scene_fill.c: the statements fill and draw: shapes in whole pixels through runs.
 * scene.c finds them by name, scene_draw.c calls what they append. */
#include "../../core/draw/line_stipple.h"
#include "../../core/raster/arc.h"
#include "../../core/raster/circle.h"
#include "../../core/raster/ellipse.h"
#include "../../core/raster/line_runs.h"
#include "../../core/raster/rect.h"
#include "../../core/raster/round_rect.h"
#include "../../core/raster/triangle.h"
#include "scene_brush.h"

enum {
    NUMBERS = 6
};

typedef void shape_runs(const struct etch_surface *s, const int32_t at[NUMBERS],
                        const struct etch_paint *paint);

struct kind {
    const char *name;
    shape_runs *runs;
    const char *numbers[NUMBERS + 1]; /* "from" to 65535, "sweep" to 65536, "pattern" of 4
                                         hexadecimal digits, others int16 */
    struct etch_scene_statement statement;
};

/* A shape as it was read. */
struct shape {
    const struct kind *kind;
    int32_t at[NUMBERS];
    uint8_t rgb[3];
    const struct etch_scene_brush *brush;
};

/* ---- the shapes --------------------------------------------------------------------------------
 */

static void rect(const struct etch_surface *s, const int32_t at[NUMBERS],
                 const struct etch_paint *paint)
{
    etch_rect_runs(
        s, etch_rect_from_size((int16_t)at[0], (int16_t)at[1], (int16_t)at[2], (int16_t)at[3]),
        paint);
}

static void disc(const struct etch_surface *s, const int32_t at[NUMBERS],
                 const struct etch_paint *paint)
{
    etch_circle_runs(s, (int16_t)at[0], (int16_t)at[1], (int16_t)at[2], paint);
}

static void triangle(const struct etch_surface *s, const int32_t at[NUMBERS],
                     const struct etch_paint *paint)
{
    struct etch_point_q8 p[3];
    struct etch_triangle t;

    for (int i = 0; i < 3; i++) {
        p[i].x = at[2 * i] * 256 + 128;
        p[i].y = at[2 * i + 1] * 256 + 128;
    }
    if (etch_triangle_setup(&t, p)) {
        etch_triangle_runs(s, &t, paint);
    }
}

static void line(const struct etch_surface *s, const int32_t at[NUMBERS],
                 const struct etch_paint *paint)
{
    etch_line_runs(s, (int16_t)at[0], (int16_t)at[1], (int16_t)at[2], (int16_t)at[3], paint);
}

static void dots(const struct etch_surface *s, const int32_t at[NUMBERS],
                 const struct etch_paint *paint)
{
    etch_line_stipple_runs(s, (int16_t)at[1], (int16_t)at[2], (int16_t)at[3], (int16_t)at[4],
                           (uint16_t)at[0], paint);
}

/* The functions of five integers, fill and outline. */
#define SHAPE(name, call)                                                                          \
    static void name(const struct etch_surface *s, const int32_t at[NUMBERS],                      \
                     const struct etch_paint *paint)                                               \
    {                                                                                              \
        call;                                                                                      \
    }

#define AT(i) (int16_t) at[i]
SHAPE(ellipse, etch_ellipse_runs(s, AT(0), AT(1), AT(2), AT(3), paint))
SHAPE(ellipse_outline, etch_ellipse_outline_runs(s, AT(0), AT(1), AT(2), AT(3), paint))
SHAPE(round_rect, etch_round_rect_runs(s, AT(0), AT(1), AT(2), AT(3), AT(4), paint))
SHAPE(round_rect_outline, etch_round_rect_outline_runs(s, AT(0), AT(1), AT(2), AT(3), AT(4), paint))
SHAPE(ring, etch_ring_runs(s, AT(0), AT(1), AT(2), AT(3), paint))
SHAPE(ring_outline, etch_ring_outline_runs(s, AT(0), AT(1), AT(2), AT(3), paint))
SHAPE(arc, etch_arc_runs(s, AT(0), AT(1), AT(2), AT(3), (uint16_t)at[4], (uint32_t)at[5], paint))
SHAPE(arc_line, etch_arc_line_runs(s, AT(0), AT(1), AT(2), (uint16_t)at[3], (uint32_t)at[4], paint))
SHAPE(pie, etch_arc_runs(s, AT(0), AT(1), AT(2), -1, (uint16_t)at[3], (uint32_t)at[4], paint))
SHAPE(pie_outline,
      etch_arc_outline_runs(s, AT(0), AT(1), AT(2), -1, (uint16_t)at[3], (uint32_t)at[4], paint))

/* ---- drawing -----------------------------------------------------------------------------------
 */

static void draw_shape(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct shape *shape = step->of.data;
    struct etch_scene_brushed memory;

    shape->kind->runs(&run->surface, shape->at,
                      etch_scene_brush_paint(run, shape->brush, shape->rgb, &memory));
}

#define NEEDS(name, function)                                                                      \
    {                                                                                              \
        name, NULL, draw_shape, function, NULL                                                     \
    }

static const struct kind fills[] = {
    {"rect", rect, {"x", "y", "w", "h"}, NEEDS("fill", "etch_rect_runs")},
    {"disc", disc, {"x", "y", "radius"}, NEEDS("fill", "etch_circle_runs")},
    {"triangle",
     triangle,
     {"x0", "y0", "x1", "y1", "x2", "y2"},
     NEEDS("fill", "etch_triangle_runs")},
    {"ellipse", ellipse, {"x", "y", "rx", "ry"}, NEEDS("fill", "etch_ellipse_runs")},
    {"roundrect",
     round_rect,
     {"x", "y", "w", "h", "radius"},
     NEEDS("fill", "etch_round_rect_runs")},
    {"ring", ring, {"x", "y", "outer", "inner"}, NEEDS("fill", "etch_ring_runs")},
    {"arc", arc, {"x", "y", "outer", "inner", "from", "sweep"}, NEEDS("fill", "etch_arc_runs")},
    {"pie", pie, {"x", "y", "radius", "from", "sweep"}, NEEDS("fill", "etch_arc_runs")},
    {NULL, NULL, {NULL}, NEEDS(NULL, "")},
};

static const struct kind outlines[] = {
    {"line", line, {"x0", "y0", "x1", "y1"}, NEEDS("draw", "etch_line_runs")},
    {"dots",
     dots,
     {"pattern", "x0", "y0", "x1", "y1"},
     NEEDS("draw", "etch_line_stipple_runs etch_kernel_line_stipple")},
    {"ellipse",
     ellipse_outline,
     {"x", "y", "rx", "ry"},
     NEEDS("draw", "etch_ellipse_outline_runs")},
    {"roundrect",
     round_rect_outline,
     {"x", "y", "w", "h", "radius"},
     NEEDS("draw", "etch_round_rect_outline_runs")},
    {"ring", ring_outline, {"x", "y", "outer", "inner"}, NEEDS("draw", "etch_ring_outline_runs")},
    {"arc", arc_line, {"x", "y", "radius", "from", "sweep"}, NEEDS("draw", "etch_arc_line_runs")},
    {"pie",
     pie_outline,
     {"x", "y", "radius", "from", "sweep"},
     NEEDS("draw", "etch_arc_outline_runs")},
    {NULL, NULL, {NULL}, NEEDS(NULL, "")},
};

/* ---- reading -----------------------------------------------------------------------------------
 */

static const struct kind *read_kind(struct etch_scene_reader *reader, const struct kind *kinds)
{
    struct etch_word word;

    if (!etch_text_word(&reader->text, "shape", &word)) {
        return NULL;
    }
    for (const struct kind *k = kinds; k->name != NULL; k++) {
        if (etch_word_is(word, k->name)) {
            return k;
        }
    }
    (void)etch_text_fail(&reader->text, "shape: \"%s\" is unknown", etch_word_show(word).text);
    return NULL;
}

static bool read_number(struct etch_scene_reader *reader, const char *name, int32_t *at)
{
    const bool is_angle = name[0] == 'f', is_sweep = name[0] == 's'; /* from, sweep */
    int64_t value;
    uint64_t bits;

    if (name[0] == 'p') {
        if (!etch_scene_read_hex(reader, name, 4, &bits)) {
            return false;
        }
        *at = (int32_t)bits;
        return true;
    }
    if (!etch_text_integer(&reader->text, name, is_angle || is_sweep ? 0 : INT16_MIN,
                           is_angle   ? UINT16_MAX
                           : is_sweep ? 65536
                                      : INT16_MAX,
                           &value)) {
        return false;
    }
    *at = (int32_t)value;
    return true;
}

static bool read_shape(struct etch_scene_reader *reader,
                       const struct etch_scene_statement *statement)
{
    const struct kind *kind = read_kind(reader, statement->name[0] == 'f' ? fills : outlines);
    struct etch_scene_step *step = kind != NULL ? etch_scene_append(reader, &kind->statement)
                                                : NULL;
    struct shape *shape = step != NULL ? etch_scene_data(reader, sizeof *shape) : NULL;

    if (shape == NULL) {
        return false;
    }
    step->of.data = shape;
    shape->kind = kind;
    shape->brush = reader->brush;
    for (int i = 0; kind->numbers[i] != NULL; i++) {
        if (!read_number(reader, kind->numbers[i], &shape->at[i])) {
            return false;
        }
    }
    step->needs = etch_scene_brush_needs(reader, false);
    return step->needs != NULL && etch_scene_read_rgb(reader, shape->rgb);
}

const struct etch_scene_statement etch_scene_fill_statements[] = {
    {"fill", read_shape, NULL, NULL, NULL},
    {"draw", read_shape, NULL, NULL, NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
