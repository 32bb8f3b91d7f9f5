/* ports/host/report.c: prints --stats and --needs. etch-sim calls it. */
#include "report.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "scene_steps.h"

/* What was sent, and how long that takes. */
static void report_bus(const struct etch_simulation *s)
{
    const struct etch_screen *screen = &s->screen;
    const struct etch_panel_port *port = screen->panel;

    (void)printf("flushed    %" PRIu64 " bytes in %" PRIu64 " %s\n", screen->bytes, screen->flushes,
                 port != NULL ? "transactions" : "transfers");
    if (port == NULL) {
        (void)printf("bus        none: this port has no bus to time\n");
        return;
    }
    const uint64_t other = port->panel.commands + port->panel.parameters;
    const uint64_t us = (port->panel.now_ns - screen->opened_ns) / 1000;

    (void)printf("commands   %" PRIu64 " bytes beside %" PRIu64 " of pixels\n", other,
                 screen->bytes - other);
    (void)printf("bus        %" PRIu64 ".%03" PRIu64 " ms at %" PRIu32 " Hz, %d bit%s wide\n",
                 us / 1000, us % 1000, s->panel.clock, s->panel.lanes,
                 s->panel.lanes == 1 ? "" : "s");
}

void etch_report_stats(const struct etch_simulation *s)
{
    const struct etch_screen *screen = &s->screen;

    (void)printf("size       %d x %d\n", s->scene->width, s->scene->height);
    (void)printf("port       %s, ", s->port);
    if (screen->panel != NULL) {
        (void)printf("turn %d, ", screen->panel->turn & 3);
    }
    (void)printf("%s\n", screen->buffers == 0   ? "drawn into directly"
                         : screen->buffers == 1 ? "strips from one buffer"
                                                : "strips from two buffers");
    (void)printf("triangles  %" PRIu64 "\n", s->stats.triangles);
    (void)printf("runs       %" PRIu64 "\n", s->stats.runs);
    (void)printf("pixels     %" PRIu64 "\n", s->stats.pixels);
    report_bus(s);
    (void)printf("ram        %" PRIu64 " bytes: colour %" PRIu64 ", depth %" PRIu64,
                 s->color_bytes + s->depth_bytes + s->stencil_bytes + s->scene->vertex_bytes,
                 s->color_bytes, s->depth_bytes);
    if (s->stencil_bytes != 0) {
        (void)printf(", stencil %" PRIu64, s->stencil_bytes);
    }
    (void)printf(", vertices %zu\n", s->scene->vertex_bytes);
}

/* The names that a step needs, with blanks between, or NULL: functions (0, 1) or kernels (2). */
static const char *needs_of(const struct etch_scene *scene, const struct etch_scene_step *step,
                            int what)
{
    return what == 0                ? step->statement->needs
           : what == 1              ? step->needs
           : step->pipeline == NULL ? NULL
                                    : step->pipeline->name[scene->format];
}

struct names {
    struct etch_word seen[256];
    size_t count;
};

/* Prints the words that were not printed before. */
static void print_new(struct names *names, const char *text)
{
    while (*text != '\0') {
        const struct etch_word word = {text, strcspn(text, " ")};
        size_t k = 0;

        while (k < names->count && (names->seen[k].size != word.size ||
                                    memcmp(names->seen[k].text, word.text, word.size) != 0)) {
            k++;
        }
        if (k == names->count && k < sizeof names->seen / sizeof names->seen[0]) {
            names->seen[names->count++] = word;
            (void)printf(" %.*s", (int)word.size, word.text);
        }
        text += word.size + strspn(text + word.size, " ");
    }
}

static void print_names(const struct etch_scene *scene, const char *title, int first, int last)
{
    struct names names = {.count = 0};

    (void)printf("%s", title);
    for (size_t i = 0; i < scene->count; i++) {
        for (int what = first; what <= last; what++) {
            const char *name = needs_of(scene, &scene->step[i], what);

            if (name != NULL) {
                print_new(&names, name);
            }
        }
    }
    (void)printf("%s\n", names.count == 0 ? " none" : "");
}

void etch_report_needs(const struct etch_simulation *s)
{
    const struct etch_scene *scene = s->scene;
    const bool depth = scene->uses_depth || s->keeps_depth;
    const bool stencil = scene->uses_stencil || s->keeps_stencil;
    const uint64_t plane = (uint64_t)s->rows * (uint64_t)scene->width * sizeof(uint16_t);

    print_names(scene, "functions ", 0, 1);
    print_names(scene, "kernels   ", 2, 2);
    (void)printf("planes     colour%s%s\n", depth ? ", depth" : "", stencil ? ", stencil" : "");
    (void)printf("ram        %" PRIu64 " bytes a colour buffer of %d rows, one or two of them; "
                 "depth %" PRIu64,
                 plane, s->rows, depth ? plane : 0);
    if (stencil) {
        (void)printf("; stencil %" PRIu64, plane / 2);
    }
    (void)printf("; vertices %zu\n", scene->vertex_bytes);
    (void)printf("flash      not measured by this command\n");
}
