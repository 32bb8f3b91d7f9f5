/* ports/host/scene_polygons.c: the statements polygon and fillpolygon, and what scene_paths.c
 * shares with them. scene.c finds them by name, scene_draw.c calls what they append. */
#include "scene_polygons.h"

/* How many words are left on the line. */
static size_t count_words(const struct etch_scene_reader *reader)
{
    struct etch_text ahead = reader->text;
    struct etch_word word;
    size_t n = 0;

    while (etch_text_more(&ahead) && etch_text_word(&ahead, "", &word)) {
        n++;
    }
    return n;
}

/* Memory for a polygon of so many words. */
static struct etch_scene_polygon *open_polygon(struct etch_scene_reader *reader, size_t words)
{
    struct etch_scene_polygon *p = etch_scene_data(reader, sizeof *p);

    if (words > UINT16_MAX) {
        (void)etch_text_fail(&reader->text, "more than %d words", UINT16_MAX);
        return NULL;
    }
    if (p != NULL) {
        p->size = etch_scene_data(reader, (words + 1) * sizeof *p->size);
        p->v = etch_scene_data(reader, (words / 2 + 1) * sizeof *p->v);
    }
    return p != NULL && p->size != NULL && p->v != NULL ? p : NULL;
}

/* One of `left` words, of which the last three are the colour. */
static bool read_coordinate(struct etch_scene_reader *reader, const char *name, size_t *left,
                            int16_t *at)
{
    int64_t value;

    if (*left <= 3) {
        return etch_text_fail(&reader->text, "%s is missing", name);
    }
    if (!etch_text_integer(&reader->text, name, INT16_MIN, INT16_MAX, &value)) {
        return false;
    }
    --*left;
    *at = (int16_t)value;
    return true;
}

/* X Y X Y .., until the next hole or the colour */
static bool read_contour(struct etch_scene_reader *reader, size_t *left, struct etch_point *v,
                         uint16_t *size)
{
    while (*left > 3) {
        if (etch_scene_take(reader, "hole")) {
            --*left;
            break;
        }
        if (!read_coordinate(reader, "x", left, &v->x) ||
            !read_coordinate(reader, "y", left, &v->y)) {
            return false;
        }
        ++*size;
        v++;
    }
    return *size >= 3 || etch_text_fail(&reader->text, "a contour needs three corners");
}

/* X Y X Y .. [hole X Y ..] .. R G B */
static struct etch_scene_polygon *read_contours(struct etch_scene_reader *reader)
{
    size_t left = count_words(reader);
    struct etch_scene_polygon *p = open_polygon(reader, left);
    struct etch_point *v = p != NULL ? p->v : NULL;

    if (p == NULL) {
        return NULL;
    }
    do {
        uint16_t *size = &p->size[p->contours++];

        if (!read_contour(reader, &left, v, size)) {
            return NULL;
        }
        v += *size;
    } while (left > 3);
    return etch_scene_read_rgb(reader, p->rgb) ? p : NULL;
}

/* ---- outlines ------------------------------------------------------------------------------- */

static void draw_outline(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct etch_scene_polygon *p = step->of.data;
    const uint16_t color = etch_scene_color(run, p->rgb);
    const struct etch_point *v = p->v;

    for (uint16_t i = 0; i < p->contours; v += p->size[i++])
        etch_polygon_draw(&run->surface, v, p->size[i], color);
}

static bool read_outline(struct etch_scene_reader *reader,
                         const struct etch_scene_statement *statement)
{
    struct etch_scene_step *step = etch_scene_append(reader, statement);
    const bool triangles = step != NULL && etch_scene_take(reader, "triangles");
    struct etch_scene_polygon *p = step != NULL ? read_contours(reader) : NULL;

    if (p == NULL) {
        return false;
    }
    step->of.data = p;
    if (triangles) {
        step->statement = &etch_scene_outline_triangles;
        return etch_scene_open_triangles(reader, p);
    }
    return true;
}

/* ---- fills ---------------------------------------------------------------------------------- */

struct etch_flat_paint etch_scene_flat_paint(struct etch_scene_run *run,
                                             const struct etch_scene_polygon *p)
{
    const struct etch_flat_paint paint = {
        {run->stats != NULL ? etch_scene_count : etch_kernel_flat}, etch_scene_color(run, p->rgb)};

    run->kernel = etch_kernel_flat;
    return paint;
}

static void draw_evenodd(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct etch_scene_polygon *p = step->of.data;
    const struct etch_flat_paint paint = etch_scene_flat_paint(run, p);

    etch_polygon_runs_evenodd(&run->surface, p->of, &paint.paint);
}

static void draw_nonzero(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct etch_scene_polygon *p = step->of.data;
    const struct etch_flat_paint paint = etch_scene_flat_paint(run, p);

    etch_polygon_runs_nonzero(&run->surface, p->of, &paint.paint);
}

static const struct etch_scene_statement evenodd = {
    "fillpolygon", NULL, draw_evenodd, "etch_polygon_runs_evenodd etch_kernel_flat", NULL};
static const struct etch_scene_statement nonzero = {
    "fillpolygon", NULL, draw_nonzero, "etch_polygon_runs_nonzero etch_kernel_flat", NULL};

struct etch_scene_step *etch_scene_read_rule(struct etch_scene_reader *reader)
{
    static const char *const rules[] = {"evenodd", "nonzero", NULL};
    int rule;

    return etch_text_choice(&reader->text, "rule", rules, &rule)
               ? etch_scene_append(reader, rule == 0 ? &evenodd : &nonzero)
               : NULL;
}

bool etch_scene_open_edges(struct etch_scene_reader *reader, struct etch_scene_polygon *p, size_t n)
{
    struct etch_polygon_edge *edge = NULL;

    if (n > UINT16_MAX) {
        return etch_text_fail(&reader->text, "more than %d edges", UINT16_MAX);
    }
    p->of = etch_scene_data(reader, sizeof *p->of);
    if (p->of != NULL) {
        edge = etch_scene_data(reader, (n + 1) * sizeof *edge);
    }
    if (edge != NULL) {
        etch_polygon_init(p->of, edge, (uint16_t)n);
    }
    return edge != NULL;
}

/* The edges of all contours. */
static bool open_fill(struct etch_scene_reader *reader, struct etch_scene_polygon *p)
{
    const struct etch_point *v = p->v;
    size_t edges = 0;

    for (uint16_t i = 0; i < p->contours; i++) {
        edges += p->size[i];
    }
    if (!etch_scene_open_edges(reader, p, edges)) {
        return false;
    }
    for (uint16_t i = 0; i < p->contours; v += p->size[i++]) {
        (void)etch_polygon_add_pixels(p->of, v, p->size[i]);
    }
    return true;
}

/* evenodd|nonzero|inversion|triangles X Y .. */
static bool read_fill(struct etch_scene_reader *reader,
                      const struct etch_scene_statement *statement)
{
    const struct etch_scene_statement *way = etch_scene_read_fill_way(reader);
    struct etch_scene_step *step = way != NULL ? etch_scene_append(reader, way)
                                               : etch_scene_read_rule(reader);
    struct etch_scene_polygon *p = step != NULL ? read_contours(reader) : NULL;

    (void)statement;
    if (p == NULL) {
        return false;
    }
    step->of.data = p;
    return way == &etch_scene_fill_inversion   ? etch_scene_open_inversion(reader, p)
           : way == &etch_scene_fill_triangles ? etch_scene_open_triangles(reader, p)
                                               : open_fill(reader, p);
}

const struct etch_scene_statement etch_scene_polygon_statements[] = {
    {"polygon", read_outline, draw_outline, "etch_polygon_draw", NULL},
    {"fillpolygon", read_fill, NULL, NULL, NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
