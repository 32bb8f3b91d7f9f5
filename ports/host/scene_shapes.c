/* ports/host/scene_shapes.c: the 2D statements. scene.c finds them by name, scene_draw.c calls
 * what they append. */
#include "../../core/draw/shapes.h"
#include "../../core/raster/circle.h"
#include "../../core/raster/line.h"
#include "../../core/raster/rect.h"
#include "../../core/raster/triangle.h"
#include "scene_steps.h"

bool etch_scene_read_shape(struct etch_scene_reader *reader,
                           const struct etch_scene_statement *statement)
{
    struct etch_scene_step *step = etch_scene_append(reader, statement);
    int64_t value;

    for (int i = 0; step != NULL && statement->arguments[i] != NULL; i++) {
        if (!etch_text_integer(&reader->text, statement->arguments[i], INT16_MIN, INT16_MAX,
                               &value)) {
            return false;
        }
        step->of.shape.at[i] = (int16_t)value;
    }
    return step != NULL && etch_scene_read_rgb(reader, step->of.shape.rgb);
}

/* ---- outlines, drawn once more on the scratch plane to be counted ------------------------- */

typedef void outline(const struct etch_surface *s, const int16_t at[6], uint16_t color);

static void count_outline(struct etch_scene_run *run, outline *draw, const int16_t at[6])
{
    struct etch_surface scratch = run->surface;
    const struct etch_rect clip = scratch.clip;

    scratch.pixels = run->scratch;
    draw(&scratch, at, 1);
    for (int16_t y = clip.y0; y < clip.y1; y++) {
        for (int16_t x = clip.x0; x < clip.x1; x++) {
            uint16_t *pixel = &scratch.pixels[etch_surface_index(&scratch, x, y)];

            run->stats->pixels += *pixel;
            *pixel = 0;
        }
    }
}

static void draw_outline(struct etch_scene_run *run, const struct etch_scene_step *step,
                         outline *draw)
{
    draw(&run->surface, step->of.shape.at, etch_scene_color(run, step->of.shape.rgb));
    if (run->stats != NULL) {
        count_outline(run, draw, step->of.shape.at);
    }
}

static void point(const struct etch_surface *s, const int16_t at[6], uint16_t color)
{
    etch_point_draw(s, at[0], at[1], color);
}

static void line(const struct etch_surface *s, const int16_t at[6], uint16_t color)
{
    etch_line_draw(s, at[0], at[1], at[2], at[3], color);
}

static void rect(const struct etch_surface *s, const int16_t at[6], uint16_t color)
{
    etch_rect_draw(s, at[0], at[1], at[2], at[3], color);
}

static void circle(const struct etch_surface *s, const int16_t at[6], uint16_t color)
{
    etch_circle_draw(s, at[0], at[1], at[2], color);
}

static void triangle(const struct etch_surface *s, const int16_t at[6], uint16_t color)
{
    etch_triangle_draw(s, at[0], at[1], at[2], at[3], at[4], at[5], color);
}

static void draw_point(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    draw_outline(run, step, point);
}

static void draw_line(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    draw_outline(run, step, line);
}

static void draw_rect(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    draw_outline(run, step, rect);
}

static void draw_circle(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    draw_outline(run, step, circle);
}

static void draw_triangle(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    draw_outline(run, step, triangle);
}

/* ---- fills: their runs once more through a kernel that only counts ------------------------- */

static const struct etch_paint count_only = {etch_scene_count};

static void draw_fillrect(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const int16_t *at = step->of.shape.at;

    etch_rect_fill(&run->surface, at[0], at[1], at[2], at[3],
                   etch_scene_color(run, step->of.shape.rgb));
    if (run->stats != NULL) {
        run->kernel = NULL;
        etch_rect_runs(&run->surface, etch_rect_from_size(at[0], at[1], at[2], at[3]), &count_only);
    }
}

static void draw_disc(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const int16_t *at = step->of.shape.at;

    etch_circle_fill(&run->surface, at[0], at[1], at[2], etch_scene_color(run, step->of.shape.rgb));
    if (run->stats != NULL) {
        run->kernel = NULL;
        etch_circle_runs(&run->surface, at[0], at[1], at[2], &count_only);
    }
}

/* Integer vertices are pixel centres. */
static struct etch_point_q8 centre(const int16_t at[2])
{
    const struct etch_point_q8 p = {at[0] * INT32_C(256) + 128, at[1] * INT32_C(256) + 128};
    return p;
}

static void draw_filltriangle(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const int16_t *at = step->of.shape.at;
    struct etch_triangle t;

    etch_triangle_fill(&run->surface, at[0], at[1], at[2], at[3], at[4], at[5],
                       etch_scene_color(run, step->of.shape.rgb));
    if (run->stats != NULL) {
        const struct etch_point_q8 p[3] = {centre(at), centre(at + 2), centre(at + 4)};

        run->stats->triangles++;
        run->kernel = NULL;
        if (etch_triangle_setup(&t, p)) {
            etch_triangle_runs(&run->surface, &t, &count_only);
        }
    }
}

/* ---- the table ----------------------------------------------------------------------------- */

static const char *const xy[] = {"x", "y", NULL};
static const char *const xyxy[] = {"x0", "y0", "x1", "y1", NULL};
static const char *const xyxyxy[] = {"x0", "y0", "x1", "y1", "x2", "y2", NULL};
static const char *const xywh[] = {"x", "y", "width", "height", NULL};
static const char *const xyr[] = {"x", "y", "radius", NULL};

const struct etch_scene_statement etch_scene_shape_statements[] = {
    {"point", etch_scene_read_shape, draw_point, "etch_point_draw", xy},
    {"line", etch_scene_read_shape, draw_line, "etch_line_draw", xyxy},
    {"rect", etch_scene_read_shape, draw_rect, "etch_rect_draw", xywh},
    {"fillrect", etch_scene_read_shape, draw_fillrect, "etch_rect_fill", xywh},
    {"circle", etch_scene_read_shape, draw_circle, "etch_circle_draw", xyr},
    {"disc", etch_scene_read_shape, draw_disc, "etch_circle_fill", xyr},
    {"triangle", etch_scene_read_shape, draw_triangle, "etch_triangle_draw", xyxyxy},
    {"filltriangle", etch_scene_read_shape, draw_filltriangle, "etch_triangle_fill", xyxyxy},
    {NULL, NULL, NULL, NULL, NULL},
};
