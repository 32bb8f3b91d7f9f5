/* ports/host/report_modes.c: how far a scene's picture is in each mode from the exact one.
 * report_needs.c calls it for --needs. See report.h. */
#include "report.h"

#include <stdio.h>
#include <stdlib.h>

#include "scene_staged.h"

enum of {
    COLORS, /* of triangles without textures, that a fused kernel draws */
    DEPTHS,
    TEXTURES
};

/* With a name of tests/tradeoff and the tenths of an instruction a pixel that it has there
 * (tests/needs/run compares them). The first is exact in all: the others are compared with it. */
static const struct mode {
    const char *name;
    enum of of;
    int tenths;
    struct etch_scene_modes modes;
} modes[] = {
    {"exact", COLORS, 297, {true, false, false, true, 0}},
    {"precise", COLORS, 137, {false, false, false, true, 0}},
    {"precise dithered", COLORS, 266, {false, true, false, true, 0}},
    {"inverse", DEPTHS, 285, {false, false, true, true, 0}},
    {"divide every pixel", TEXTURES, 1891, {true, false, false, true, 0}},
    {"divide every 8", TEXTURES, 1420, {true, false, false, true, 3}},
    {"divide every 16", TEXTURES, 308, {true, false, false, true, 1}},
    {"affine", TEXTURES, 116, {true, false, false, false, 0}},
};

/* The scene in a mode, as a caller's frame of rgb565; NULL if it cannot be drawn. */
static uint16_t *draw(const struct etch_simulation *s, const char *path,
                      const struct etch_scene_modes *in)
{
    const size_t size = (size_t)s->scene->width * (size_t)s->scene->height;
    const struct etch_rect window = {0, 0, s->scene->width, s->scene->height};
    uint16_t *color = calloc(size, sizeof *color), *depth = calloc(size, sizeof *depth);
    uint8_t *stencil = calloc(size, 1);
    static struct etch_error error;
    struct etch_surface surface;
    struct etch_scene scene;
    bool ok = color != NULL && depth != NULL && stencil != NULL &&
              etch_surface_init(&surface, color, window, (uint16_t)s->scene->width) == ETCH_OK;

    if (ok && etch_scene_open_modes(&scene, path, in, &error)) {
        surface.depth = depth;
        surface.stencil = stencil;
        ok = etch_scene_draw(&scene, &surface, NULL);
        for (size_t i = 0; i < size && scene.format == ETCH_FORMAT_RGB565_SWAPPED; i++) {
            color[i] = etch_rgb565_swap(color[i]);
        }
        etch_scene_close(&scene);
    } else {
        ok = false;
    }
    free(depth);
    free(stencil);
    if (!ok) {
        free(color);
    }
    return ok ? color : NULL;
}

static int apart(int a, int b)
{
    return a < b ? b - a : a - b;
}

/* Over all channels of all pixels. */
static void print_difference(const struct mode *mode, const uint16_t *a, const uint16_t *b,
                             size_t size)
{
    uint64_t sum = 0, others = 0;
    int most = 0;

    for (size_t i = 0; i < size; i++) {
        const int channel[3] = {apart(a[i] >> 11, b[i] >> 11),
                                apart(a[i] >> 5 & 63, b[i] >> 5 & 63), apart(a[i] & 31, b[i] & 31)};

        others += a[i] != b[i];
        for (int k = 0; k < 3; k++) {
            sum += (uint64_t)channel[k];
            most = channel[k] > most ? channel[k] : most;
        }
    }
    (void)printf(
        "mode       %s: %llu pixels are not as exact ones, by %.4f steps of a channel in the "
        "mean of the frame and %d at most; %d.%d instructions a pixel on Cortex-M0+\n",
        mode->name, (unsigned long long)others, (double)sum / (3.0 * (double)size), most,
        mode->tenths / 10, mode->tenths % 10);
}

/* Whether the scene has anything that the mode is of. */
static bool has(const struct etch_scene *scene, enum of of)
{
    for (size_t i = 0; i < scene->count; i++) {
        const struct etch_scene_pipeline *p = scene->step[i].pipeline;
        const bool textured = p != NULL &&
                              (p->texture != NULL || (p->staged != NULL && p->staged->of != NULL));

        if (p != NULL &&
            (of == TEXTURES ? textured
                            : !textured && p->staged == NULL && (of == COLORS || p->ztest != 0))) {
            return true;
        }
    }
    return false;
}

bool etch_report_modes(const struct etch_simulation *s, const char *path)
{
    const size_t size = (size_t)s->scene->width * (size_t)s->scene->height;
    uint16_t *exact = NULL;
    bool ok = true;

    for (size_t i = 0; ok && i < sizeof modes / sizeof modes[0]; i++) {
        uint16_t *picture = NULL;

        if (has(s->scene, modes[i].of)) {
            exact = exact != NULL ? exact : draw(s, path, &modes[0].modes);
            picture = draw(s, path, &modes[i].modes);
            ok = exact != NULL && picture != NULL;
        }
        if (picture != NULL && ok) {
            print_difference(&modes[i], picture, exact, size);
        }
        free(picture);
    }
    free(exact);
    return ok;
}
