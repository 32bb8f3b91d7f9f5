/* ports/host/scene_polygon_ways.c: polygons filled in other ways than by scan lines: by edge
 * inversion and as triangles. scene_polygons.c reads them, scene_draw.c draws. */
#include "../../core/draw/shapes.h"
#include "../../core/raster/edge_flags.h"
#include "../../core/raster/triangulate.h"
#include "scene_polygons.h"

/* Integer vertices are pixel centres. */
static struct etch_point_q8 centre(struct etch_point v)
{
    const struct etch_point_q8 p = {v.x * INT32_C(256) + 128, v.y * INT32_C(256) + 128};

    return p;
}

/* How many vertices all contours have. */
static size_t count(const struct etch_scene_polygon *p)
{
    size_t n = 0;

    for (uint16_t i = 0; i < p->contours; i++) {
        n += p->size[i];
    }
    return n;
}

const struct etch_scene_statement *etch_scene_read_fill_way(struct etch_scene_reader *reader)
{
    if (etch_scene_take(reader, "inversion")) {
        return &etch_scene_fill_inversion;
    }
    return etch_scene_take(reader, "triangles") ? &etch_scene_fill_triangles : NULL;
}

/* ---- edge inversion -------------------------------------------------------------------------- */

/* A column more than the frame: samples that pixels share have it. */
bool etch_scene_open_inversion(struct etch_scene_reader *reader, struct etch_scene_polygon *p)
{
    p->bits = etch_scene_data(
        reader, ETCH_EDGE_FLAGS_BYTES(reader->scene->width + 1, reader->scene->height));
    return p->bits != NULL;
}

/* The bits are those of the clip, a strip or the scissor. */
static void draw_inversion(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct etch_scene_polygon *p = step->of.data;
    const struct etch_flat_paint paint = etch_scene_flat_paint(run, p);
    const struct etch_point *v = p->v;
    struct etch_edge_flags flags;

    if (etch_edge_flags_init(&flags, run->surface.clip, p->bits,
                             ETCH_EDGE_FLAGS_BYTES(run->scene->width + 1, run->scene->height)) !=
        ETCH_OK) {
        return; /* the clip is empty */
    }
    for (uint16_t i = 0; i < p->contours; v += p->size[i++]) {
        for (uint16_t k = 0; k < p->size[i]; k++) {
            const uint16_t next = (uint16_t)(k + 1 == p->size[i] ? 0 : k + 1);

            etch_edge_flags_add_edge(&flags, centre(v[k]), centre(v[next]));
        }
    }
    etch_edge_flags_runs(&run->surface, &flags, &paint.paint);
}

/* ---- triangles ------------------------------------------------------------------------------- */

static void take_triangle(void *context, const uint16_t vertex[3])
{
    struct etch_scene_polygon *p = context;

    for (int i = 0; i < 3; i++) {
        p->corner[3 * p->triangles + (size_t)i] = vertex[i];
    }
    p->triangles++;
}

/* A polygon of n corners and h holes has n + 2 h - 2 triangles. */
bool etch_scene_open_triangles(struct etch_scene_reader *reader, struct etch_scene_polygon *p)
{
    const size_t n = count(p), room = n + 2 * (size_t)p->contours;
    struct etch_point_q8 *v = etch_scene_data(reader, n * sizeof *v);
    struct etch_ring_node *node = etch_scene_data(reader, room * sizeof *node);

    p->corner = etch_scene_data(reader, 3 * room * sizeof *p->corner);
    if (v == NULL || node == NULL || p->corner == NULL) {
        return false;
    }
    for (size_t i = 0; i < n; i++) {
        v[i] = centre(p->v[i]);
    }
    return (room <= UINT16_MAX &&
            etch_triangulate_holes(v, p->size, p->contours, node, (uint16_t)room, take_triangle,
                                   p) == ETCH_OK) ||
           etch_text_fail(&reader->text, "this polygon has no triangles: its sides cross or touch, "
                                         "or a hole is not inside");
}

static const struct etch_point *corner_of(const struct etch_scene_polygon *p, size_t triangle,
                                          int i)
{
    return &p->v[p->corner[3 * triangle + (size_t)i]];
}

static void draw_triangles(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct etch_scene_polygon *p = step->of.data;
    const struct etch_flat_paint paint = etch_scene_flat_paint(run, p);

    for (size_t k = 0; k < p->triangles; k++) {
        const struct etch_point_q8 v[3] = {centre(*corner_of(p, k, 0)), centre(*corner_of(p, k, 1)),
                                           centre(*corner_of(p, k, 2))};
        struct etch_triangle t;

        if (run->stats != NULL) {
            run->stats->triangles++;
        }
        if (etch_triangle_setup(&t, v)) {
            etch_triangle_runs(&run->surface, &t, &paint.paint);
        }
    }
}

static void draw_outlines(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct etch_scene_polygon *p = step->of.data;
    const uint16_t color = etch_scene_color(run, p->rgb);

    for (size_t k = 0; k < p->triangles; k++) {
        const struct etch_point *a = corner_of(p, k, 0), *b = corner_of(p, k, 1);
        const struct etch_point *c = corner_of(p, k, 2);

        etch_triangle_draw(&run->surface, a->x, a->y, b->x, b->y, c->x, c->y, color);
    }
}

const struct etch_scene_statement etch_scene_fill_inversion = {
    "fillpolygon", NULL, draw_inversion, "etch_edge_flags_runs etch_kernel_flat", NULL};
const struct etch_scene_statement etch_scene_fill_triangles = {
    "fillpolygon", NULL, draw_triangles,
    "etch_triangulate_holes etch_triangle_runs etch_kernel_flat", NULL};
const struct etch_scene_statement etch_scene_outline_triangles = {
    "polygon", NULL, draw_outlines, "etch_triangulate_holes etch_triangle_draw", NULL};
