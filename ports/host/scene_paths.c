/* ports/host/scene_paths.c: the statement fillpath. scene.c finds it by name, scene_draw.c calls
 * what it appends. */
#include "../../core/raster/curve.h"
#include "scene_polygons.h"

/* A path while it is walked, edge by edge. */
struct path {
    struct etch_polygon *polygon; /* or NULL, to count */
    size_t edges;
    struct etch_point_q8 start, at;
};

static void add_edge(void *context, struct etch_point_q8 to)
{
    struct path *path = context;

    if (path->polygon != NULL) {
        (void)etch_polygon_add_edge(path->polygon, path->at, to);
    }
    path->edges++;
    path->at = to;
}

/* n points, in 2^-frac px. */
static bool read_points(struct etch_scene_reader *reader, struct etch_point_q8 *p, int n)
{
    const int64_t limit = INT64_C(1) << (15 + reader->frac);

    for (int i = 0; i < 2 * n; i++) {
        int32_t *const q8 = i % 2 == 0 ? &p[i / 2].x : &p[i / 2].y;
        int64_t value;

        if (!etch_text_integer(&reader->text, i % 2 == 0 ? "x" : "y", -limit, limit - 1, &value)) {
            return false;
        }
        *q8 = etch_snap_q8((etch_q16)(value * (INT32_C(1) << (16 - reader->frac))));
    }
    return true;
}

/* Takes a command; its place in the list is how many points it has, but for move. -1: none. */
static int take_command(struct etch_scene_reader *reader)
{
    static const char *const commands[] = {"move", "line", "quadratic", "cubic"};

    for (int i = 0; i < 4; i++) {
        if (etch_scene_take(reader, commands[i])) {
            return i;
        }
    }
    return -1;
}

/* move X Y | line X Y | quadratic X Y X Y | cubic X Y X Y X Y, until something else comes */
static bool read_path(struct etch_scene_reader *reader, struct path *path)
{
    int command = take_command(reader);

    if (command != 0) {
        return etch_text_fail(&reader->text, "a path begins with move");
    }
    for (; command >= 0; command = take_command(reader)) {
        struct etch_point_q8 p[4];

        if (!read_points(reader, p + 1, command == 0 ? 1 : command)) {
            return false;
        }
        p[0] = path->at;
        if (command == 0) {
            add_edge(path, path->start); /* the contour before is closed */
            path->start = path->at = p[1];
        } else if (command == 1) {
            add_edge(path, p[1]);
        } else {
            (command == 2 ? etch_quadratic_flatten : etch_cubic_flatten)(p, ETCH_CURVE_FLATNESS_Q8,
                                                                         add_edge, path);
        }
    }
    add_edge(path, path->start);
    return true;
}

static bool read_fillpath(struct etch_scene_reader *reader,
                          const struct etch_scene_statement *statement)
{
    struct etch_scene_step *step = etch_scene_read_rule(reader);
    struct etch_scene_polygon *p = step != NULL ? etch_scene_data(reader, sizeof *p) : NULL;
    struct path count = {0}, path = {0};
    const struct etch_text begin = reader->text;

    (void)statement;
    if (p == NULL || !read_path(reader, &count) || !etch_scene_open_edges(reader, p, count.edges)) {
        return false;
    }
    reader->text = begin;
    path.polygon = p->of;
    step->of.data = p;
    return read_path(reader, &path) && etch_scene_read_rgb(reader, p->rgb);
}

const struct etch_scene_statement etch_scene_path_statements[] = {
    {"fillpath", read_fillpath, NULL, NULL, NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
