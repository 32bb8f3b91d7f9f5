/* ports/host/scene_lines.c: lines with colour and depth, lines and points of a size. scene.c finds
 * the statements by name, scene_draw.c calls what they append. */
#include "scene_lines.h"

#include "../../core/draw/point.h"
#include "../../core/fragment/flat.h"

/* What a step keeps. */
struct line {
    uint16_t size_q8; /* wideline, cpoint */
    bool is_round;    /* cpoint */
    struct etch_vertex v[2];
};

bool etch_scene_lines_pipeline(struct etch_scene_reader *reader, struct etch_scene_step *step)
{
    struct etch_scene_state wanted = reader->state;

    wanted.shade = 0; /* flat lines have equal ends */
    wanted.tex = 0;
    wanted.mode = 0;
    step->pipeline = etch_scene_pipeline_find(&wanted);
    if (step->pipeline == NULL) {
        return etch_text_fail(&reader->text, "lines and points are drawn with the depth test "
                                             "alone: no blending, stencil, masks or fog");
    }
    if (step->pipeline->ztest != 0) {
        reader->scene->uses_depth = true;
    }
    return true;
}

void etch_scene_lines_paint(struct etch_scene_run *run, const struct etch_scene_step *step,
                            const struct etch_vertex v[2])
{
    const struct etch_vertex *const ends[2] = {&v[0], &v[1]};

    (step->pipeline->ztest != 0 ? etch_line_gouraud_depth : etch_line_gouraud)(
        &run->surface, ends, etch_scene_kernel(run, step->pipeline));
}

static void take_line(struct etch_sink *sink, const struct etch_vertex *const v[2])
{
    const struct etch_scene_line_sink *lines = (const void *)sink;
    const struct etch_vertex ends[2] = {*v[0], *v[1]};

    etch_scene_lines_paint(lines->run, lines->step, ends);
}

void etch_scene_line_sink_init(struct etch_scene_line_sink *lines, struct etch_scene_run *run,
                               const struct etch_scene_step *step)
{
    lines->sink = (struct etch_sink){.line = take_line};
    lines->run = run;
    lines->step = step;
}

etch_kernel *etch_scene_flat(struct etch_scene_run *run)
{
    run->kernel = etch_kernel_flat;
    return run->stats != NULL ? etch_scene_count : etch_kernel_flat;
}

/* ---- lines and points with state ----------------------------------------------------------- */

/* x y z r g b */
static bool read_vertex(struct etch_scene_reader *reader, struct etch_vertex *v)
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

/* [square|round] [SIZE] V [V]: by the statement's name. */
static bool read_line(struct etch_scene_reader *reader,
                      const struct etch_scene_statement *statement)
{
    struct etch_scene_step *step = etch_scene_append(reader, statement);
    struct line *line = step != NULL ? etch_scene_data(reader, sizeof *line) : NULL;
    const bool is_point = statement->name[1] == 'p', is_wide = statement->name[0] == 'w';

    if (line == NULL || (is_point && !read_kind(reader, &line->is_round)) ||
        ((is_point || is_wide) && !read_size(reader, &line->size_q8))) {
        return false;
    }
    step->of.data = line;
    if (!read_vertex(reader, &line->v[0]) || (!is_point && !read_vertex(reader, &line->v[1]))) {
        return false;
    }
    if (reader->state.shade != 0 && !is_point) { /* flat: all in the colour of the first vertex */
        line->v[1].r = line->v[0].r, line->v[1].g = line->v[0].g, line->v[1].b = line->v[0].b;
    }
    return etch_scene_lines_pipeline(reader, step);
}

static void draw_cline(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct line *line = step->of.data;

    etch_scene_lines_paint(run, step, line->v);
}

static void draw_wideline(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct line *line = step->of.data;
    const struct etch_vertex *const ends[2] = {&line->v[0], &line->v[1]};

    if (run->stats != NULL) {
        run->stats->triangles += 2;
    }
    etch_line_wide(&run->surface, ends, line->size_q8, etch_scene_painter(run, step->pipeline),
                   etch_scene_kernel(run, step->pipeline));
}

static void draw_cpoint(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct line *line = step->of.data;

    etch_point_paint(&run->surface, &line->v[0], line->size_q8,
                     line->is_round ? etch_point_runs_round : etch_point_runs_square,
                     etch_scene_kernel(run, step->pipeline));
}

/* ---- the table ----------------------------------------------------------------------------- */

const struct etch_scene_statement etch_scene_line_statements[] = {
    {"cline", read_line, draw_cline, "etch_line_gouraud", NULL},
    {"wideline", read_line, draw_wideline, "etch_line_wide", NULL},
    {"cpoint", read_line, draw_cpoint, "etch_point_paint", NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
