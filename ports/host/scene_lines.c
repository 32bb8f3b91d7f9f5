/* ports/host/scene_lines.c: lines with colour and depth, lines and points of a size. scene.c finds
 * the statements by name, scene_draw.c calls what they append. */
#include "scene_lines.h"

/* What a step keeps. */
struct line {
    uint16_t size_q8; /* wideline, cpoint */
    bool is_round;    /* cpoint */
    struct etch_vertex v[2];
};

bool etch_scene_read_line_vertex(struct etch_scene_reader *reader, struct etch_vertex *v)
{
    uint8_t rgb[3];
    int64_t z;

    if (!etch_scene_read_position(reader, "x", &v->x_q8) ||
        !etch_scene_read_position(reader, "y", &v->y_q8) ||
        !etch_text_integer(&reader->text, "z", 0, 65535, &z) || !etch_scene_read_rgb(reader, rgb)) {
        return false;
    }
    v->z_q16 = (uint32_t)z << 16;
    v->r = rgb[0], v->g = rgb[1], v->b = rgb[2], v->a = 255;
    return true;
}

/* A size in pixels, decimal, to 1/256 px. */
static bool read_size(struct etch_scene_reader *reader, uint16_t *size_q8)
{
    etch_q16 size;

    if (!etch_text_q16(&reader->text, "size", &size)) {
        return false;
    }
    if (size < 0 || etch_snap_q8(size) > UINT16_MAX) {
        return etch_text_fail(&reader->text, "size must be 0 to below 256");
    }
    *size_q8 = (uint16_t)etch_snap_q8(size);
    return true;
}

/* square|round */
static bool read_kind(struct etch_scene_reader *reader, bool *is_round)
{
    *is_round = etch_scene_take(reader, "round");
    return *is_round || etch_scene_take(reader, "square") ||
           etch_text_fail(&reader->text, "cpoint must be square or round");
}

bool etch_scene_read_alphas(struct etch_scene_reader *reader, uint8_t *const alpha[], int n)
{
    if (!etch_scene_take(reader, "alpha")) {
        return true;
    }
    for (int i = 0; i < n; i++) {
        if (!etch_scene_read_byte(reader, "alpha", alpha[i])) {
            return false;
        }
    }
    return true;
}

/* V [V] [alpha A [A]] */
static bool read_vertices(struct etch_scene_reader *reader, struct etch_vertex *v, int n)
{
    uint8_t *const alpha[2] = {&v[0].a, &v[1].a};

    for (int i = 0; i < n; i++) {
        if (!etch_scene_read_line_vertex(reader, &v[i])) {
            return false;
        }
    }
    if (!etch_scene_read_alphas(reader, alpha, n)) {
        return false;
    }
    if (reader->state.shade == 1 && n == 2) { /* flat: all in the colour of the first vertex */
        v[1].r = v[0].r, v[1].g = v[0].g, v[1].b = v[0].b, v[1].a = v[0].a;
    }
    return true;
}

/* [square|round] [SIZE] and the vertices: by the statement's name. */
static bool read_line(struct etch_scene_reader *reader,
                      const struct etch_scene_statement *statement)
{
    struct etch_scene_step *step = etch_scene_append(reader, statement);
    struct line *line = step != NULL ? etch_scene_data(reader, sizeof *line) : NULL;
    const enum etch_scene_line_kind kind = statement->name[1] == 'p'   ? ETCH_SCENE_POINT
                                           : statement->name[0] == 'w' ? ETCH_SCENE_WIDE
                                                                       : ETCH_SCENE_LINE;

    if (line == NULL || (kind == ETCH_SCENE_POINT && !read_kind(reader, &line->is_round)) ||
        (kind != ETCH_SCENE_LINE && !read_size(reader, &line->size_q8))) {
        return false;
    }
    step->of.data = line;
    return read_vertices(reader, line->v, kind == ETCH_SCENE_POINT ? 1 : 2) &&
           etch_scene_lines_pipeline(reader, step, kind);
}

static void draw_cline(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct line *line = step->of.data;

    etch_scene_paint_line(run, step, line->v);
}

static void draw_wideline(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct line *line = step->of.data;

    etch_scene_paint_wide(run, step, line->v, line->size_q8);
}

static void draw_cpoint(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct line *line = step->of.data;

    etch_scene_paint_point(run, step, &line->v[0], line->size_q8,
                           line->is_round ? etch_point_runs_round : etch_point_runs_square);
}

/* ---- the table ----------------------------------------------------------------------------- */

const struct etch_scene_statement etch_scene_line_statements[] = {
    {"cline", read_line, draw_cline, NULL, NULL},
    {"wideline", read_line, draw_wideline, NULL, NULL},
    {"cpoint", read_line, draw_cpoint, NULL, NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
