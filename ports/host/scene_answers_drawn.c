/* ports/host/scene_answers_drawn.c: the forms of select and feedback that draw. scene_answers.c
 * reads the statements; scene_draw.c calls the steps. */
#include <stdlib.h>
#include <string.h>

#include "../../core/draw/point.h"
#include "../../core/draw/shapes.h"
#include "../../core/fragment/flat.h"
#include "../../core/raster/line.h"
#include "scene_answers.h"

/* ---- select: the edge of what has a name in a whole frame of names -----------------------------
 */

struct edge {
    int16_t width, height;
    uint8_t rgb[3];
    uint8_t at[]; /* a byte for each pixel: it is drawn */
};

static bool has_name(const struct etch_surface *s, int x, int y, uint16_t name)
{
    return x >= 0 && y >= 0 && x < s->window.x1 && y < s->window.y1 &&
           s->pixels[(size_t)y * s->stride + (size_t)x] == name;
}

/* Pixels of the object beside which another begins. */
static void find_edge(struct edge *edge, const struct etch_surface *s, uint16_t name)
{
    for (int y = 0; y < edge->height; y++) {
        for (int x = 0; x < edge->width; x++) {
            edge->at[y * edge->width + x] = has_name(s, x, y, name) &&
                                            !(has_name(s, x - 1, y, name) &&
                                              has_name(s, x + 1, y, name) &&
                                              has_name(s, x, y - 1, name) &&
                                              has_name(s, x, y + 1, name));
        }
    }
}

static void draw_edge(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct edge *edge = step->of.data;
    const struct etch_rect *clip = &run->surface.clip;
    const uint16_t color = etch_scene_color(run, edge->rgb);

    for (int16_t y = clip->y0; y < clip->y1 && y < edge->height; y++) {
        for (int16_t x = clip->x0; x < clip->x1 && x < edge->width; x++) {
            if (edge->at[y * edge->width + x] != 0) {
                etch_rect_fill(&run->surface, x, y, 1, 1, color);
            }
        }
    }
}

/* Draws the names into `planes`, two of them, and keeps the edge. */
static void select_edge(struct edge *edge, const struct etch_scene *scene, uint16_t *planes,
                        int16_t x, int16_t y)
{
    const struct etch_rect frame = {0, 0, scene->width, scene->height};
    const size_t size = (size_t)scene->width * (size_t)scene->height;
    struct etch_name_sink names;
    struct etch_surface surface;
    uint16_t name;

    memset(planes, 0, size * sizeof *planes);
    memset(planes + size, 0xFF, size * sizeof *planes);
    (void)etch_surface_init(&surface, planes, frame, (uint16_t)scene->width);
    surface.depth = planes + size;
    etch_name_sink_init(&names, &surface, etch_kernel_flat_less);
    (void)etch_scene_name_objects(scene, &names, NULL);
    name = planes[(size_t)y * surface.stride + (size_t)x];
    if (name != 0) {
        find_edge(edge, &surface, name);
    }
}

bool etch_scene_read_selected(struct etch_scene_reader *reader, int16_t x, int16_t y)
{
    static const struct etch_scene_statement statement = {
        "select", NULL, draw_edge, "etch_name_sink_init etch_kernel_flat_less", NULL};
    const struct etch_scene *scene = reader->scene;
    const size_t size = (size_t)scene->width * (size_t)scene->height;
    struct edge *edge = etch_scene_data(reader, sizeof *edge + size);
    struct etch_scene_step *step;
    uint16_t *planes;

    if (edge == NULL || !etch_scene_read_rgb(reader, edge->rgb)) {
        return false;
    }
    planes = malloc(2 * size * sizeof *planes);
    if (planes == NULL) {
        return etch_text_fail(&reader->text, "out of memory");
    }
    edge->width = scene->width;
    edge->height = scene->height;
    select_edge(edge, scene, planes, x, y);
    free(planes);
    step = etch_scene_append(reader, &statement);
    if (step != NULL) {
        step->of.data = edge;
    }
    return step != NULL;
}

/* ---- feedback: outlines, and a dot on every vertex ---------------------------------------------
 */

struct fed_back {
    uint32_t count;
    uint8_t line[3], dot[3];
    struct etch_feedback_primitive primitive[];
};

static int16_t pixel(int32_t q8)
{
    return (int16_t)(q8 >> 8 > INT16_MAX ? INT16_MAX : q8 >> 8);
}

static void draw_outline(struct etch_scene_run *run, const struct etch_feedback_primitive *p,
                         uint16_t color)
{
    for (int i = 0; i < p->size; i++) {
        const struct etch_vertex *a = &p->v[i], *b = &p->v[(i + 1) % p->size];

        etch_line_draw(&run->surface, pixel(a->x_q8), pixel(a->y_q8), pixel(b->x_q8),
                       pixel(b->y_q8), color);
    }
}

static void draw_fed_back(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct fed_back *f = step->of.data;
    const uint16_t line = etch_scene_color(run, f->line), dot = etch_scene_color(run, f->dot);

    for (uint32_t i = 0; i < f->count; i++) {
        draw_outline(run, &f->primitive[i], line);
    }
    for (uint32_t i = 0; i < f->count; i++) {
        for (int k = 0; k < f->primitive[i].size; k++) {
            const struct etch_vertex *v = &f->primitive[i].v[k];

            etch_point_fill(&run->surface, v->x_q8, v->y_q8, 3 * 256, dot, etch_point_runs_square);
        }
    }
}

bool etch_scene_read_fed_back(struct etch_scene_reader *reader, const struct etch_feedback *f)
{
    static const struct etch_scene_statement statement = {
        "feedback", NULL, draw_fed_back, "etch_feedback_init etch_line_draw etch_point_fill", NULL};
    const size_t bytes = f->count * sizeof f->primitive[0];
    struct fed_back *kept = etch_scene_data(reader, sizeof *kept + bytes);
    struct etch_scene_step *step;

    if (kept == NULL || !etch_scene_read_rgb(reader, kept->line) ||
        !etch_scene_read_rgb(reader, kept->dot)) {
        return false;
    }
    kept->count = f->count;
    memcpy(kept->primitive, f->primitive, bytes);
    step = etch_scene_append(reader, &statement);
    if (step != NULL) {
        step->of.data = kept;
    }
    return step != NULL;
}
