/* ports/host/scene_passes.c: the statements that ask for passes over the frame. scene.c finds them
 * by name; scene_exposure.c and scene_samples.c do what they ask. */
#include "scene_passes.h"

#include <stdlib.h>

#include "../../core/frame/exchange.h"

static void draw_nothing(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    (void)run, (void)step;
}

/* What each adds to --needs. */
static const struct etch_scene_statement needs_antialias[] = {
    [ETCH_SCENE_NO_ANTIALIAS] = {"antialias", NULL, draw_nothing, NULL, NULL},
    [ETCH_SCENE_SSAA] = {"antialias", NULL, draw_nothing, NULL, NULL},
    [ETCH_SCENE_MSAA] = {"antialias", NULL, draw_nothing,
                         "etch_multisample_flat etch_multisample_gouraud etch_multisample_resolve",
                         NULL},
    [ETCH_SCENE_SHARED] = {"antialias", NULL, draw_nothing,
                           "etch_shared_flat etch_shared_gouraud etch_shared_resolve", NULL},
    [ETCH_SCENE_ACCUMULATE] =
        {"antialias", NULL, draw_nothing,
         "etch_accumulation_load etch_accumulation_add etch_accumulation_return", NULL},
    [ETCH_SCENE_FXAA] = {"antialias", NULL, draw_nothing, "etch_smooth_draw", NULL},
};
static const struct etch_scene_statement needs_moments = {
    "motionblur", NULL, draw_nothing,
    "etch_accumulation_load etch_accumulation_add etch_accumulation_return", NULL};
static const struct etch_scene_statement needs_filter[] = {
    [ETCH_SCENE_NO_FILTER] = {"filter", NULL, draw_nothing, NULL, NULL},
    [ETCH_SCENE_AVERAGE] = {"filter", NULL, draw_nothing, "etch_filter_average", NULL},
    [ETCH_SCENE_SOBEL] = {"filter", NULL, draw_nothing, "etch_filter_sobel", NULL},
    [ETCH_SCENE_KERNEL] = {"filter", NULL, draw_nothing, "etch_filter_draw", NULL},
};

/* The passes of the scene; NULL, with an error set, without memory. */
static struct etch_scene_passes *passes_of(struct etch_scene_reader *reader)
{
    struct etch_scene *scene = reader->scene;

    if (scene->passes == NULL) {
        scene->passes = etch_scene_data(reader, sizeof *scene->passes);
        if (scene->passes != NULL) {
            scene->passes->moments = 1;
        }
    }
    return scene->passes;
}

static bool read_number(struct etch_scene_reader *reader, const char *name, int least, int greatest,
                        int *number)
{
    int64_t value;

    if (!etch_text_integer(&reader->text, name, least, greatest, &value)) {
        return false;
    }
    *number = (int)value;
    return true;
}

/* none | ssaa N | msaa | shared | accumulate N | fxaa */
/* What depends on the number of samples. */
static const char *needs_of(const struct etch_scene_passes *passes)
{
    static const char *const resolve[] = {
        "etch_supersample_resolve_2", "etch_supersample_resolve_3", "etch_supersample_resolve_4"};
    const int n = passes->samples;

    return passes->antialias == ETCH_SCENE_SSAA         ? resolve[n - 2]
           : passes->antialias != ETCH_SCENE_ACCUMULATE ? NULL
           : n == 2                                     ? "etch_jitter_2"
           : n == 4                                     ? "etch_jitter_4"
           : n == 8                                     ? "etch_jitter_8"
                                                        : "etch_jitter_16";
}

static bool read_antialias(struct etch_scene_reader *reader,
                           const struct etch_scene_statement *statement)
{
    static const char *const words[] = {"none",       "ssaa", "msaa", "shared",
                                        "accumulate", "fxaa", NULL};
    struct etch_scene_passes *passes = passes_of(reader);
    int kind;

    (void)statement;
    if (passes == NULL || !etch_text_choice(&reader->text, "antialias", words, &kind)) {
        return false;
    }
    passes->antialias = (enum etch_scene_antialias)kind;
    if (kind == ETCH_SCENE_SSAA) {
        if (!read_number(reader, "n", 2, 4, &passes->samples)) {
            return false;
        }
        if (reader->scene->width * passes->samples > INT16_MAX ||
            reader->scene->height * passes->samples > INT16_MAX) {
            return etch_text_fail(&reader->text, "the frame is too large for ssaa %d",
                                  passes->samples);
        }
    }
    if (kind == ETCH_SCENE_SHARED && reader->scene->width == INT16_MAX) {
        return etch_text_fail(&reader->text, "the frame is too wide for shared samples");
    }
    if (kind == ETCH_SCENE_ACCUMULATE) {
        if (!read_number(reader, "n", 2, 16, &passes->samples)) {
            return false;
        }
        if ((passes->samples & (passes->samples - 1)) != 0) {
            return etch_text_fail(&reader->text, "accumulate takes 2, 4, 8 or 16");
        }
    }
    struct etch_scene_step *step = etch_scene_append(reader, &needs_antialias[kind]);

    if (step != NULL) {
        step->needs = needs_of(passes);
    }
    return step != NULL;
}

static bool read_motion_blur(struct etch_scene_reader *reader,
                             const struct etch_scene_statement *statement)
{
    struct etch_scene_passes *passes = passes_of(reader);

    (void)statement;
    return passes != NULL && read_number(reader, "n", 1, 256, &passes->moments) &&
           etch_scene_append(reader, &needs_moments) != NULL;
}

/* ---- filter -------------------------------------------------------------------------------------
 */

/* W W W W W W W W W DIVISOR BIAS */
static bool read_kernel(struct etch_scene_reader *reader, struct etch_filter_weights *weights)
{
    int number;

    for (int i = 0; i < 9; i++) {
        if (!read_number(reader, "weight", INT8_MIN, INT8_MAX, &number)) {
            return false;
        }
        weights->weight[i] = (int8_t)number;
    }
    if (!read_number(reader, "divisor", 1, 255, &number)) {
        return false;
    }
    weights->divisor = (uint8_t)number;
    if (!read_number(reader, "bias", -255, 255, &number)) {
        return false;
    }
    weights->bias = (int16_t)number;
    return true;
}

static bool read_filter(struct etch_scene_reader *reader,
                        const struct etch_scene_statement *statement)
{
    static const char *const words[] = {"none",    "average", "sobel",  "blur", "sharpen",
                                        "laplace", "emboss",  "kernel", NULL};
    static const struct etch_filter_weights *const named[] = {
        &etch_filter_weights_blur, &etch_filter_weights_sharpen, &etch_filter_weights_laplace,
        &etch_filter_weights_emboss};
    struct etch_scene_passes *passes = passes_of(reader);
    int kind;

    (void)statement;
    if (passes == NULL || !etch_text_choice(&reader->text, "filter", words, &kind)) {
        return false;
    }
    passes->filter = kind < ETCH_SCENE_KERNEL ? (enum etch_scene_filter)kind : ETCH_SCENE_KERNEL;
    if (kind == 7) {
        if (!read_kernel(reader, &passes->weights)) {
            return false;
        }
    } else if (kind >= ETCH_SCENE_KERNEL) {
        passes->weights = *named[kind - ETCH_SCENE_KERNEL];
    }
    return etch_scene_append(reader, &needs_filter[passes->filter]) != NULL;
}

/* ---- motion -------------------------------------------------------------------------------------
 */

struct motion {
    etch_q16 x, y;
};

static void draw_motion(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct motion *motion = step->of.data;

    run->motion_x_q8 = etch_snap_q8(motion->x);
    run->motion_y_q8 = etch_snap_q8(motion->y);
}

static const struct etch_scene_statement moves = {"motion", NULL, draw_motion, NULL, NULL};

/* X Y: how far the triangles that follow move while the frame is exposed */
static bool read_motion(struct etch_scene_reader *reader,
                        const struct etch_scene_statement *statement)
{
    struct etch_scene_step *step = etch_scene_append(reader, &moves);
    struct motion *motion = step != NULL ? etch_scene_data(reader, sizeof *motion) : NULL;

    (void)statement;
    if (motion == NULL) {
        return false;
    }
    step->of.data = motion;
    return etch_text_q16(&reader->text, "x", &motion->x) &&
           etch_text_q16(&reader->text, "y", &motion->y);
}

/* ---- exchange -----------------------------------------------------------------------------------
 */

struct exchange {
    int16_t x, y, width, height, other;
};

/* The two columns of pixels as surfaces of one window. */
static void draw_exchange(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct exchange *e = step->of.data;
    const struct etch_surface *s = &run->surface;
    const struct etch_rect first = {e->x, s->window.y0, (int16_t)(e->x + e->width), s->window.y1};
    const struct etch_rect rows = {0, e->y, INT16_MAX, (int16_t)(e->y + e->height)};
    const struct etch_rect window = etch_rect_intersect(first, rows);
    struct etch_surface a, b;

    if (!etch_rect_is_empty(window) && s->window.x0 == 0 &&
        etch_surface_init(&a, s->pixels + etch_surface_index(s, e->x, window.y0), window,
                          s->stride) == ETCH_OK &&
        etch_surface_init(&b, s->pixels + etch_surface_index(s, e->other, window.y0), window,
                          s->stride) == ETCH_OK) {
        etch_surface_exchange(&a, &b);
    }
}

static const struct etch_scene_statement exchanges = {"exchange", NULL, draw_exchange,
                                                      "etch_surface_exchange", NULL};

/* X Y W H X2: two images of W x H, in the same rows, change places */
static bool read_exchange(struct etch_scene_reader *reader,
                          const struct etch_scene_statement *statement)
{
    const struct etch_scene *scene = reader->scene;
    struct etch_scene_step *step = etch_scene_append(reader, &exchanges);
    struct exchange *e = step != NULL ? etch_scene_data(reader, sizeof *e) : NULL;
    int x, y, width, height, other;

    (void)statement;
    if (e == NULL || !read_number(reader, "x", 0, scene->width - 1, &x) ||
        !read_number(reader, "y", 0, scene->height - 1, &y) ||
        !read_number(reader, "width", 1, scene->width - x, &width) ||
        !read_number(reader, "height", 1, scene->height - y, &height) ||
        !read_number(reader, "x2", 0, scene->width - width, &other)) {
        return false;
    }
    if (abs(x - other) < width) {
        return etch_text_fail(&reader->text, "the two images overlap");
    }
    *e = (struct exchange){(int16_t)x, (int16_t)y, (int16_t)width, (int16_t)height, (int16_t)other};
    step->of.data = e;
    return true;
}

const struct etch_scene_statement etch_scene_pass_statements[] = {
    {"antialias", read_antialias, NULL, NULL, NULL},
    {"motionblur", read_motion_blur, NULL, NULL, NULL},
    {"filter", read_filter, NULL, NULL, NULL},
    {"motion", read_motion, NULL, NULL, NULL},
    {"exchange", read_exchange, NULL, NULL, NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
