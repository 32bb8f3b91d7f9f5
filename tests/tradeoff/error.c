/* tradeoff/error.c: what every mode errs by over every scene, on the host, against exact rationals
 * of the snapped vertices. Every triangle is drawn alone, so that each of its pixels is seen.
 * Writes the rows mode,kernel,scene,unit,mean,p999,max,program,bytes,triangle,pixels,triangles in
 * the order in which main.c draws. */
#include "error.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const units[] = {"step",  "step",  "unit", "code",
                                    "texel", "pixel", "px",   "wrong"};

static uint16_t color[TRADEOFF_W * TRADEOFF_H], depth[TRADEOFF_W * TRADEOFF_H];
static double *errors;
static size_t count, room;

void error_add(double error)
{
    if (count == room) {
        room = room * 2 + 4096;
        errors = realloc(errors, room * sizeof *errors);
        if (errors == NULL)
            exit(1);
    }
    errors[count++] = error;
}

wide128 error_value(const struct error_triangle *t, int x, int y, const uint32_t value[3])
{
    wide128 sum = 0;

    for (int i = 0; i < 3; i++)
        sum += (wide128)oracle_triangle_edge(&t->exact, i, x, y) * value[t->exact.from[i]];
    return sum;
}

static int32_t held(int32_t v, int32_t most)
{
    return v < 0 ? 0 : v > most ? most : v;
}

void error_find(struct error_triangle *t)
{
    const int32_t *x = t->exact.x, *y = t->exact.y;
    int32_t least_x = x[0], most_x = x[0], least_y = y[0], most_y = y[0];

    for (int k = 1; k < 3; k++) {
        least_x = x[k] < least_x ? x[k] : least_x, most_x = x[k] > most_x ? x[k] : most_x;
        least_y = y[k] < least_y ? y[k] : least_y, most_y = y[k] > most_y ? y[k] : most_y;
    }
    t->x0 = held((least_x >> 8) - 2, TRADEOFF_W), t->x1 = held((most_x >> 8) + 3, TRADEOFF_W);
    t->y0 = held((least_y >> 8) - 2, TRADEOFF_H), t->y1 = held((most_y >> 8) + 3, TRADEOFF_H);
}

static int up(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

static void clean(void)
{
    memset(color, 0, sizeof color);
    memset(depth, 0xFF, sizeof depth);
}

/* The vertex that draw_whole_pixel takes in place of v, and the one of everything else. */
static double vertex_error(const struct tradeoff_mode *mode, const struct etch_vertex *v)
{
    const int x = (v->x_q8 & 255) - 128, y = (v->y_q8 & 255) - 128;
    const int far = abs(x) > abs(y) ? abs(x) : abs(y);

    return mode->draw == draw_whole_pixel ? far / 256.0 : 0;
}

static void triangle_errors(const struct tradeoff_mode *mode, const struct error_triangle *t)
{
    switch (mode->unit) {
    case TRADEOFF_COLOR: error_color(t); break;
    case TRADEOFF_MEAN: error_blocks(t); break;
    case TRADEOFF_DEPTH: error_depth(t); break;
    case TRADEOFF_CODE: error_code(t); break;
    case TRADEOFF_TEXEL: error_texel(t); break;
    case TRADEOFF_COVERAGE: error_coverage(t); break;
    default:
        for (int k = 0; k < 3; k++)
            error_add(vertex_error(mode, &t->v[k].at));
    }
}

/* Draws triangle i alone, white where the share of pixels is asked for; returns its pixels. */
static long one(const struct tradeoff_mode *mode, const struct tradeoff_scene *scene, int i,
                const struct etch_surface *s)
{
    struct etch_texture_vertex v[3];
    const struct tradeoff_scene alone = {scene->name, v, 1};
    struct error_triangle t = {.v = v, .drawn = s};
    int32_t x[3], y[3];
    long pixels = 0;

    for (int k = 0; k < 3; k++) {
        v[k] = scene->v[3 * i + k];
        if (mode->unit == TRADEOFF_COVERAGE)
            v[k].at.r = v[k].at.g = v[k].at.b = 255;
        x[k] = v[k].at.x_q8, y[k] = v[k].at.y_q8;
    }
    oracle_triangle_make(&t.exact, x, y);
    error_find(&t);
    for (int py = t.y0; py < t.y1; py++)
        for (int px = t.x0; px < t.x1; px++)
            pixels += oracle_triangle_covers(&t.exact, px, py);
    if (mode->unit != TRADEOFF_VISIBLE) {
        clean();
        mode->draw(s, &alone);
        triangle_errors(mode, &t);
    }
    return pixels;
}

static void row(const struct tradeoff_mode *mode, const struct tradeoff_scene *scene,
                const struct etch_surface *s)
{
    double sum = 0;
    long pixels = 0;

    count = 0;
    for (int i = 0; i < scene->count; i++)
        pixels += one(mode, scene, i, s);
    if (mode->unit == TRADEOFF_VISIBLE) {
        clean();
        error_visible(mode, scene, s);
    }
    if (count == 0)
        exit(1);
    qsort(errors, count, sizeof *errors, up);
    for (size_t i = 0; i < count; i++)
        sum += errors[i];
    printf("%s,%s,%s,%s,%.6g,%.6g,%.6g,%s,%d,%d,%ld,%d\n", mode->name, mode->kernel, scene->name,
           units[mode->unit], sum / (double)count, errors[(count - 1) * 999 / 1000],
           errors[count - 1], mode->program, mode->bytes, mode->triangle, pixels, scene->count);
}

int main(void)
{
    const struct etch_rect window = {0, 0, TRADEOFF_W, TRADEOFF_H};
    struct etch_surface s;

    if (etch_surface_init(&s, color, window, TRADEOFF_W) != ETCH_OK)
        return 1;
    s.depth = depth;
    tradeoff_prepare();
    for (int m = 0; m < tradeoff_mode_count; m++)
        for (int k = 0; k < TRADEOFF_SCENES; k++)
            if ((tradeoff_modes[m].scenes >> k & 1) != 0)
                row(&tradeoff_modes[m], &tradeoff_scenes[k], &s);
    return 0;
}
