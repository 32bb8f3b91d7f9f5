/* ports/host/report_needs.c: prints --needs: what a program for one scene links and holds, and what
 * that scene could do without. etch-sim calls it. See report.h. */
#include "report.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "needs.h"
#include "scene_facts.h"

enum {
    STATEMENTS, /* what a step names, in this order */
    STEPS,
    PAINTERS,
    KERNELS
};

/* What paints the triangles of a pipeline. */
static const char *painter_of(const struct etch_scene_pipeline *p, uint8_t format)
{
    const bool depth = p->ztest != 0;

    if (p->staged != NULL) {
        return "etch_triangle_staged";
    }
    if (p->texture != NULL && p->perspective) {
        return depth ? "etch_triangle_perspective_depth" : "etch_triangle_perspective";
    }
    if (p->texture != NULL) {
        return depth ? "etch_triangle_texture_depth" : "etch_triangle_texture";
    }
    return p->painter_name[format];
}

/* The names that a step needs, with blanks between, or NULL. */
static const char *needs_of(const struct etch_scene *scene, const struct etch_scene_step *step,
                            int what)
{
    const struct etch_scene_pipeline *p = step->pipeline;

    return what == STATEMENTS ? step->statement->needs
           : what == STEPS    ? step->needs
           : p == NULL        ? NULL
           : what == PAINTERS ? painter_of(p, scene->format)
                              : p->name[scene->format];
}

struct names {
    struct etch_word seen[256];
    size_t count;
};

static bool take_new(struct names *names, struct etch_word word)
{
    for (size_t k = 0; k < names->count; k++) {
        if (names->seen[k].size == word.size &&
            memcmp(names->seen[k].text, word.text, word.size) == 0) {
            return false;
        }
    }
    if (names->count == sizeof names->seen / sizeof names->seen[0]) {
        return false;
    }
    names->seen[names->count++] = word;
    return true;
}

/* Takes and prints the words that were not printed before, and adds up what they weigh. */
static void print_new(struct names *names, const char *text, struct etch_needs *needs,
                      struct names *unknown)
{
    while (*text != '\0') {
        const struct etch_word word = {text, strcspn(text, " ")};

        if (take_new(names, word)) {
            (void)printf(" %.*s", (int)word.size, word.text);
            if (!etch_needs_add(needs, word.text, word.size)) {
                (void)take_new(unknown, word);
            }
        }
        text += word.size + strspn(text + word.size, " ");
    }
}

static void print_names(const struct etch_scene *scene, const char *title, int first, int last,
                        struct etch_needs *needs, struct names *unknown)
{
    struct names names = {.count = 0};

    (void)printf("%s", title);
    for (size_t i = 0; i < scene->count; i++) {
        for (int what = first; what <= last; what++) {
            const char *name = needs_of(scene, &scene->step[i], what);

            if (name != NULL) {
                print_new(&names, name, needs, unknown);
            }
        }
    }
    (void)printf("%s\n", names.count == 0 ? " none" : "");
}

static void print_planes(const struct etch_simulation *s)
{
    const struct etch_scene *scene = s->scene;
    const bool depth = scene->uses_depth || s->keeps_depth;
    const bool stencil = scene->uses_stencil || s->keeps_stencil;
    const uint64_t plane = (uint64_t)s->rows * (uint64_t)scene->width * sizeof(uint16_t);

    (void)printf("planes     colour%s%s\n", depth ? ", depth" : "", stencil ? ", stencil" : "");
    (void)printf("ram        %" PRIu64 " bytes a colour buffer of %d rows, one or two of them; "
                 "depth %" PRIu64,
                 plane, s->rows, depth ? plane : 0);
    if (stencil) {
        (void)printf("; stencil %" PRIu64, plane / 2);
    }
    (void)printf("; vertices %zu\n", scene->vertex_bytes);
}

static void print_flash(const struct etch_needs *needs, const struct names *unknown)
{
    (void)printf("flash      %" PRIu32 " bytes of etch on Cortex-M0+, -Os%s", needs->flash,
                 unknown->count != 0 ? "; made here and not weighed:" : "");
    for (size_t i = 0; i < unknown->count; i++) {
        (void)printf(" %.*s", (int)unknown->seen[i].size, unknown->seen[i].text);
    }
    (void)printf("\nstack      %" PRIu32 " bytes at most in any of these, at -O2\n", needs->stack);
}

/* Which of some triangles have what makes something simpler. */
static void print_share(const char *title, uint64_t some, uint64_t all, const char *then)
{
    if (all != 0) {
        (void)printf("%s %" PRIu64 " of %" PRIu64 "%s%s\n", title, some, all,
                     some == all ? ": " : "", some == all ? then : "");
    }
}

static void print_range(const struct etch_scene *scene, const uint16_t *depth, size_t size)
{
    const double near = scene->near / 65536.0, far = scene->far / 65536.0;
    uint16_t least = UINT16_MAX, most = 0;

    for (size_t i = 0; i < size; i++) {
        if (depth[i] != UINT16_MAX) {
            least = depth[i] < least ? depth[i] : least;
            most = depth[i] > most ? depth[i] : most;
        }
    }
    if (least > most) {
        return;
    }
    (void)printf("range      depths %d to %d of 65535 are seen", least, most);
    if (scene->near > 0 && scene->far > scene->near) { /* half a unit on either side */
        const double a = least > 0 ? (least - 0.5) / 65535 : 0, b = (most + 0.5) / 65535;

        (void)printf(": near %.4g and far %.4g would do instead of %.4g and %.4g",
                     near * far / (far - a * (far - near)), near * far / (far - b * (far - near)),
                     near, far);
    }
    (void)printf("\n");
}

static void print_facts(const struct etch_simulation *s, const struct etch_scene_facts *facts,
                        const uint16_t *depth)
{
    const size_t size = (size_t)s->scene->width * (size_t)s->scene->height;
    uint64_t tested = 0, again = 0;

    print_share("one colour", facts->of_one_color, facts->triangles, "flat kernels draw the same");
    print_share("at centres", facts->at_centres, facts->triangles,
                "whole pixels, etch_triangle_fill, draw the same");
    print_share("equal w   ", facts->of_equal_w, facts->textured, "no perspective is needed");
    for (size_t i = 0; i < size; i++) {
        tested += facts->times[i] > 0;
        again += facts->times[i] > 1;
    }
    if (facts->tested != 0) {
        (void)printf("overlap    %" PRIu64 " of %" PRIu64 " pixels with depth are drawn again%s\n",
                     again, tested, again == 0 ? ": no depth is needed" : "");
        print_range(s->scene, depth, size);
    }
}

/* Draws the frame once, without the passes over it, to see what is in it. */
static bool report_facts(const struct etch_simulation *s)
{
    const size_t size = (size_t)s->scene->width * (size_t)s->scene->height;
    const struct etch_rect window = {0, 0, s->scene->width, s->scene->height};
    struct etch_scene_facts facts = {.width = s->scene->width, .times = calloc(size, 1)};
    struct etch_scene_stats stats = {.facts = &facts};
    struct etch_scene scene = *s->scene;
    uint16_t *color = calloc(size, sizeof *color), *depth = calloc(size, sizeof *depth);
    uint8_t *stencil = calloc(size, 1);
    struct etch_surface surface;
    bool ok = facts.times != NULL && color != NULL && depth != NULL && stencil != NULL &&
              etch_surface_init(&surface, color, window, (uint16_t)s->scene->width) == ETCH_OK;

    if (ok) {
        surface.depth = depth;
        surface.stencil = stencil;
        scene.passes = NULL;
        ok = etch_scene_draw(&scene, &surface, &stats);
    }
    if (ok) {
        print_facts(s, &facts, depth);
    }
    free(facts.times);
    free(color);
    free(depth);
    free(stencil);
    return ok;
}

bool etch_report_needs(const struct etch_simulation *s)
{
    struct etch_needs needs;
    struct names unknown = {.count = 0};

    if (!etch_needs_open(&needs)) {
        return false;
    }
    (void)etch_needs_add(&needs, "etch_surface_init", strlen("etch_surface_init"));
    print_names(s->scene, "functions ", STATEMENTS, PAINTERS, &needs, &unknown);
    print_names(s->scene, "kernels   ", KERNELS, KERNELS, &needs, &unknown);
    print_planes(s);
    print_flash(&needs, &unknown);
    etch_needs_close(&needs);
    return report_facts(s);
}
