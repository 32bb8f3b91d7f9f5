/* ports/host/scene_lines_2d.c: DDA lines, half-space triangles and gradients. scene.c finds the
 * statements by name, scene_draw.c calls what they append. */
#include "../../core/fragment/flat.h"
#include "../../core/raster/evaluate.h"
#include "../../core/raster/halfspace.h"
#include "../../core/raster/line_dda.h"
#include "../../core/raster/line_runs.h"
#include "../../core/raster/plane.h"
#include "scene_lines.h"

struct gradient {
    struct etch_rect rect;
    struct etch_plane plane[3]; /* 5.27, 6.26, 5.27, each + 1/2 */
};

/* Drawn once more on the scratch plane to be counted, as outlines are. */
static void draw_ddaline(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const int16_t *at = step->of.shape.at;
    const struct etch_rect clip = run->surface.clip;
    struct etch_surface scratch = run->surface;

    etch_line_draw_dda(&run->surface, at[0], at[1], at[2], at[3],
                       etch_scene_color(run, step->of.shape.rgb));
    if (run->stats == NULL) {
        return;
    }
    scratch.pixels = run->scratch;
    etch_line_draw_dda(&scratch, at[0], at[1], at[2], at[3], 1);
    for (int16_t y = clip.y0; y < clip.y1; y++) {
        for (int16_t x = clip.x0; x < clip.x1; x++) {
            uint16_t *pixel = &scratch.pixels[etch_surface_index(&scratch, x, y)];

            run->stats->pixels += *pixel;
            *pixel = 0;
        }
    }
}

static void draw_halfspace(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const int16_t *at = step->of.shape.at;
    const struct etch_flat_paint paint = {{etch_scene_flat(run)},
                                          etch_scene_color(run, step->of.shape.rgb)};
    struct etch_point_q8 v[3];
    struct etch_triangle t;

    for (int i = 0; i < 3; i++) { /* vertices are pixel centres */
        v[i].x = at[2 * i] * INT32_C(256) + 128;
        v[i].y = at[2 * i + 1] * INT32_C(256) + 128;
    }
    if (run->stats != NULL) {
        run->stats->triangles++;
    }
    if (etch_triangle_setup(&t, v)) {
        etch_triangle_runs_halfspace(&run->surface, &t, &paint.paint);
    }
}

/* ---- gradient ------------------------------------------------------------------------------ */

/* The plane of channel k from its values at the top left, top right and bottom left pixel. */
static void set_plane(struct gradient *g, int k, const uint8_t rgb[3][3])
{
    const struct etch_rect r = g->rect;
    const int16_t right = (int16_t)(r.x1 - 1), below = (int16_t)(r.y1 - 1);
    struct etch_plane across, down;
    uint32_t v[3];

    for (int i = 0; i < 3; i++) {
        v[i] = k == 1 ? etch_channel_q26(rgb[i][k]) : etch_channel_q27(rgb[i][k]);
    }
    etch_line_plane(&across, r.x0, r.y0, right, r.y0, v[0], v[1]);
    etch_line_plane(&down, r.x0, r.y0, r.x0, below, v[0], v[2]);
    g->plane[k].dx = across.dx;
    g->plane[k].dy = down.dy;
    g->plane[k].origin = etch_wrap_sub(
        etch_wrap_sub(v[0], etch_wrap_mul(across.dx, (uint32_t)(int32_t)r.x0)),
        etch_wrap_mul(down.dy, (uint32_t)(int32_t)r.y0));
}

/* X Y W H and the colours of three corners */
static bool read_gradient(struct etch_scene_reader *reader,
                          const struct etch_scene_statement *statement)
{
    static const char *const names[4] = {"x", "y", "width", "height"};
    struct etch_scene_step *step = etch_scene_append(reader, statement);
    struct gradient *g = step != NULL ? etch_scene_data(reader, sizeof *g) : NULL;
    uint8_t rgb[3][3];
    int64_t at[4];

    if (g == NULL) {
        return false;
    }
    step->of.data = g;
    for (int i = 0; i < 4; i++) {
        if (!etch_text_integer(&reader->text, names[i], i < 2 ? INT16_MIN : 1, INT16_MAX, &at[i])) {
            return false;
        }
    }
    for (int i = 0; i < 3; i++) {
        if (!etch_scene_read_rgb(reader, rgb[i])) {
            return false;
        }
    }
    g->rect = etch_rect_from_size((int16_t)at[0], (int16_t)at[1], (int16_t)at[2], (int16_t)at[3]);
    for (int k = 0; k < 3; k++) {
        const int fourth = rgb[1][k] + rgb[2][k] - rgb[0][k];

        if (fourth < 0 || fourth > 255) {
            return etch_text_fail(&reader->text, "the gradient leaves 0 to 255 at its last corner");
        }
        set_plane(g, k, (const uint8_t(*)[3])rgb);
    }
    return true;
}

static void put_pixel(void *context, int16_t x, int16_t y, const uint32_t *value)
{
    const struct etch_scene_run *run = context;
    const uint16_t color = (uint16_t)((value[0] >> 27 << 6 | value[1] >> 26) << 5 | value[2] >> 27);

    run->surface.pixels[etch_surface_index(&run->surface, x, y)] =
        run->scene->format == ETCH_FORMAT_RGB565_SWAPPED ? etch_rgb565_swap(color) : color;
    if (run->stats != NULL) {
        run->stats->pixels++;
    }
}

static void draw_gradient(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct gradient *g = step->of.data;
    uint32_t work[6];

    etch_evaluate_rect(g->plane, 3, etch_rect_intersect(g->rect, run->surface.clip), work,
                       put_pixel, run);
}

/* ---- the table ----------------------------------------------------------------------------- */

static const char *const xyxy[] = {"x0", "y0", "x1", "y1", NULL};
static const char *const xyxyxy[] = {"x0", "y0", "x1", "y1", "x2", "y2", NULL};

const struct etch_scene_statement etch_scene_line_2d_statements[] = {
    {"ddaline", etch_scene_read_shape, draw_ddaline, "etch_line_draw_dda", xyxy},
    {"halfspace", etch_scene_read_shape, draw_halfspace, "etch_triangle_runs_halfspace", xyxyxy},
    {"gradient", read_gradient, draw_gradient, "etch_evaluate_rect", NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
