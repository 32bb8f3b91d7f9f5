/* ports/host/etch_sim.c: the simulator's command line. Reads a scene, draws it through the frame
 * loop on a simulated screen, and writes what the screen shows. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "file.h"
#include "output.h"
#include "report.h"
#include "simulate.h"

static const char usage[] =
    "usage: etch-sim SCENE [-o OUT.png|.ppm] [--raw OUT.565] [--depth OUT.z16]\n"
    "                [--port NAME] [--strip N] [--stats] [--needs]\n";

struct options {
    const char *scene, *picture, *raw, *depth, *port, *strip;
    bool stats, needs, help;
};

/* An error of the command line: exit status 2. */
static int wrong(const char *what, const char *word)
{
    (void)fprintf(stderr, "etch-sim: %s%s\n%s", what, word, usage);
    return 2;
}

/* An error of a file: exit status 2. */
static int failed(const struct etch_error *error)
{
    (void)fprintf(stderr, "%s\n", error->text);
    return 2;
}

/* Where the value of an option goes, NULL if `word` is not an option with a value. */
static const char **value_of(struct options *o, const char *word)
{
    return strcmp(word, "-o") == 0        ? &o->picture
           : strcmp(word, "--raw") == 0   ? &o->raw
           : strcmp(word, "--depth") == 0 ? &o->depth
           : strcmp(word, "--port") == 0  ? &o->port
           : strcmp(word, "--strip") == 0 ? &o->strip
                                          : NULL;
}

static bool *flag_of(struct options *o, const char *word)
{
    return strcmp(word, "--stats") == 0   ? &o->stats
           : strcmp(word, "--needs") == 0 ? &o->needs
           : strcmp(word, "--help") == 0  ? &o->help
                                          : NULL;
}

/* 0, or the exit status. */
static int read_options(struct options *o, int count, char **words)
{
    for (int i = 1; i < count; i++) {
        const char **value = value_of(o, words[i]);
        bool *flag = flag_of(o, words[i]);

        if (value != NULL && i + 1 == count) {
            return wrong("a value is missing after ", words[i]);
        }
        if (value != NULL && *value != NULL) {
            return wrong("given twice: ", words[i]);
        }
        if (value != NULL) {
            *value = words[++i];
        } else if (flag != NULL) {
            *flag = true;
        } else if (strcmp(words[i], "--stencil") == 0) {
            return wrong("not supported yet: ", words[i]);
        } else if (words[i][0] == '-') {
            return wrong("unknown option ", words[i]);
        } else if (o->scene != NULL) {
            return wrong("more than one scene: ", words[i]);
        } else {
            o->scene = words[i];
        }
    }
    return o->scene != NULL || o->help ? 0 : wrong("no scene", "");
}

/* The strip height asked for, 0 if none; -1 if it is wrong. */
static int32_t strip_rows(const struct options *o, const struct etch_scene *scene)
{
    int64_t rows = scene->strip;
    const struct etch_word word = {o->strip, o->strip != NULL ? strlen(o->strip) : 0};

    if (o->strip != NULL && (!etch_integer_read(word, &rows) || rows < 1 || rows > 32767)) {
        return -1;
    }
    return (int32_t)rows;
}

static bool write_outputs(const struct options *o, const struct etch_simulation *s,
                          struct etch_error *error)
{
    const struct etch_plane16 color = {s->screen.shown.pixels, s->scene->width, s->scene->height,
                                       s->screen.shown.stride,
                                       s->scene->format == ETCH_FORMAT_RGB565_SWAPPED};
    const struct etch_plane16 depth = {s->depth, s->scene->width, s->scene->height, s->scene->width,
                                       false};
    struct etch_output output[] = {
        {.path = o->picture,
         .plane = &color,
         .dump = o->picture != NULL ? etch_output_picture(o->picture) : NULL},
        {.path = o->raw, .plane = &color, .dump = etch_dump_raw},
        {.path = o->depth, .plane = &depth, .dump = etch_dump_raw},
    };

    return etch_outputs_write(output, sizeof output / sizeof output[0], error);
}

static int run(const struct options *o, const struct etch_scene *scene, struct etch_error *error)
{
    const int32_t rows = strip_rows(o, scene);
    struct etch_simulation s = {.scene = scene,
                                .port = o->port != NULL ? o->port
                                        : rows > 0      ? "strips"
                                                        : "memory",
                                .keeps_depth = o->depth != NULL,
                                .counts = o->stats};
    bool ok;

    if (rows < 0) {
        return wrong("--strip takes rows, 1 .. 32767, not ", o->strip);
    }
    s.rows = rows == 0 || rows > scene->height ? scene->height : (int16_t)rows;
    if (o->needs) {
        etch_report_needs(scene, s.rows, s.keeps_depth);
        return 0;
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
static const char *clash(const struct options *o, const struct etch_scene *scene)
{
    const char *const outputs[] = {o->picture, o->raw, o->depth};

    for (int i = 0; i < 3; i++) {
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
    struct options options = {0};
    struct etch_scene scene;
    const char *twice;
    int status = read_options(&options, count, words);

    if (status != 0) {
        return status;
    }
    if (options.help) {
        (void)fputs(usage, stdout);
        return 0;
    }
    if (options.picture != NULL && etch_output_picture(options.picture) == NULL) {
        return wrong("a picture's name ends in .png or .ppm, not ", options.picture);
    }
    if (!etch_scene_open(&scene, options.scene, &error)) {
        return failed(&error);
    }
    twice = clash(&options, &scene);
    status = twice != NULL ? wrong("one file in two places: ", twice)
                           : run(&options, &scene, &error);
    etch_scene_close(&scene);
    return status;
}
