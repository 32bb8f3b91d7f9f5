/* ports/host/etch_sim.c: the simulator's command line. Reads a scene, draws it through the frame
 * loop on a simulated screen, and writes what the screen shows. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "file.h"
#include "options.h"
#include "output.h"
#include "report.h"
#include "simulate.h"

/* An error of a file: exit status 2. */
static int failed(const struct etch_error *error)
{
    (void)fprintf(stderr, "%s\n", error->text);
    return 2;
}

/* Rows of a strip; 0: the whole frame at once. */
static int32_t strip_rows(const struct etch_options *o, const struct etch_scene *scene)
{
    const bool panel = o->port != NULL && etch_screen_format(o->port) >= 0;

    return o->rows > 0 ? o->rows : scene->strip > 0 ? scene->strip : panel ? 16 : 0;
}

static bool write_outputs(const struct etch_options *o, const struct etch_simulation *s,
                          struct etch_error *error)
{
    const struct etch_plane16 color = {s->screen.shown.pixels, s->scene->width, s->scene->height,
                                       s->screen.shown.stride, s->screen.swapped};
    const struct etch_plane16 depth = {s->depth, s->scene->width, s->scene->height, s->scene->width,
                                       false};
    const struct etch_plane16 stencil = {s->stencil, s->scene->width, s->scene->height,
                                         s->scene->width, false};
    struct etch_output output[] = {
        {.path = o->picture,
         .plane = &color,
         .dump = o->picture != NULL ? etch_output_picture(o->picture) : NULL},
        {.path = o->raw, .plane = &color, .dump = etch_dump_raw},
        {.path = o->depth, .plane = &depth, .dump = etch_dump_raw},
        {.path = o->stencil, .plane = &stencil, .dump = etch_dump_bytes},
    };

    return etch_outputs_write(output, sizeof output / sizeof output[0], error);
}

static int run(const struct etch_options *o, const struct etch_scene *scene,
               struct etch_error *error)
{
    const int32_t rows = strip_rows(o, scene);
    struct etch_simulation s = {.scene = scene,
                                .port = o->port != NULL ? o->port
                                        : rows > 0      ? "strips"
                                                        : "memory",
                                .panel = o->panel,
                                .keeps_depth = o->depth != NULL,
                                .keeps_stencil = o->stencil != NULL,
                                .counts = o->stats};
    bool ok;

    s.rows = rows == 0 || rows > scene->height ? scene->height : (int16_t)rows;
    if (o->needs) {
        return etch_report_needs(&s) && etch_report_modes(&s, o->scene)
                   ? 0
                   : failed((etch_error_set(error, o->scene, 0, "out of memory"), error));
    }
    ok = etch_simulate(&s, o->scene, error) && write_outputs(o, &s, error);
    if (ok && o->stats) {
        etch_report_stats(&s);
    }
    etch_simulation_close(&s);
    return ok ? 0 : failed(error);
}

/* An output that is another one too, or a file that the scene is read from: one of them would be
 * lost. NULL if there is none. Devices may be read and written. */
static const char *clash(const struct etch_options *o, const struct etch_scene *scene)
{
    const char *const outputs[] = {o->picture, o->raw, o->depth, o->stencil};

    for (int i = 0; i < 4; i++) {
        const char *name = outputs[i];

        for (int k = 0; name != NULL && k < i; k++) {
            if (outputs[k] != NULL && etch_file_same(name, outputs[k])) {
                return name;
            }
        }
        if (name == NULL || !etch_file_regular(name)) {
            continue;
        }
        for (size_t k = 0; k < scene->file_count; k++) {
            if (etch_file_same(name, scene->file[k])) {
                return name;
            }
        }
        if (etch_file_same(name, o->scene)) {
            return name;
        }
    }
    return NULL;
}

int main(int count, char **words)
{
    static struct etch_error error;
    struct etch_options options = {0};
    struct etch_scene scene;
    const char *twice;
    int status = etch_options_read(&options, count, words);

    if (status != 0) {
        return status;
    }
    if (options.help) {
        etch_options_print();
        return 0;
    }
    if (options.picture != NULL && etch_output_picture(options.picture) == NULL) {
        return etch_options_wrong("a picture's name ends in .png or .ppm, not ", options.picture);
    }
    if (!etch_scene_open_in(&scene, options.scene,
                            options.port != NULL ? etch_screen_format(options.port) : -1, &error)) {
        return failed(&error);
    }
    twice = clash(&options, &scene);
    status = twice != NULL ? etch_options_wrong("one file in two places: ", twice)
                           : run(&options, &scene, &error);
    etch_scene_close(&scene);
    return status;
}
