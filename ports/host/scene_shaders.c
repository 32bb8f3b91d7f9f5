/* ports/host/scene_shaders.c: the statement shadertri: triangles by pixel work of the simulator's
 * own, written as an application would write it: a shader in a kernel, a stage, a function of the
 * weights. scene.c finds it by name, scene_draw.c calls what it appends. */
#include "../../core/draw/staged.h"
#include "../../core/draw/triangle.h"
#include "../../core/fragment/gouraud_shader.h"
#include "../../core/fragment/write.h"
#include "scene_lines.h"

static void count_triangle(const struct etch_scene_run *run)
{
    if (run->stats != NULL) {
        run->stats->triangles++;
    }
}

/* ---- kernel: interpolated colours, half as bright in every second square of 4 x 4 pixels
 * --------- */

/* v[3] counts x, which a fragment does not. */
static inline void weave_start(struct etch_fragment *f, const struct etch_paint *paint)
{
    etch_gouraud_start(f, paint);
    f->v[3] = (uint32_t)(int32_t)f->x;
}

static inline void weave_step(struct etch_fragment *f, const struct etch_paint *paint)
{
    etch_gouraud_step(f, paint);
    f->v[3] = etch_wrap_add(f->v[3], 1);
}

static inline uint16_t weave_color(const struct etch_fragment *f, const struct etch_paint *paint)
{
    const uint16_t color = etch_gouraud_color(f, paint);
    const bool dark = (((int32_t)f->v[3] ^ f->y) & 4) != 0;

    return dark ? color >> 1 & 0x7BEF : color;
}

static inline uint16_t weave_color_swapped(const struct etch_fragment *f,
                                           const struct etch_paint *paint)
{
    return etch_rgb565_swap(weave_color(f, paint));
}

static const struct etch_shader weave = {weave_start, weave_step, weave_color};
static const struct etch_shader weave_swapped = {weave_start, weave_step, weave_color_swapped};
static etch_kernel weave_kernel, weave_kernel_swapped;
ETCH_KERNEL(weave_kernel, weave, NULL, false)
ETCH_KERNEL(weave_kernel_swapped, weave_swapped, NULL, false)

static void draw_kernel(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct etch_vertex *vertex = step->of.data;
    const struct etch_vertex *const v[3] = {&vertex[0], &vertex[1], &vertex[2]};

    count_triangle(run);
    run->kernel = run->scene->format == ETCH_FORMAT_RGB565_SWAPPED ? weave_kernel_swapped
                                                                   : weave_kernel;
    etch_triangle_gouraud(&run->surface, v, run->stats != NULL ? etch_scene_count : run->kernel);
}

/* ---- stage: four levels of each channel
 * ---------------------------------------------------------- */

static void posterize(struct etch_chunk *c, const void *data)
{
    (void)data;
    for (uint16_t i = 0; i < c->n; i++) {
        c->r[i] = (uint16_t)((c->r[i] >> 14) * ETCH_CHUNK_RED_MAX / 3);
        c->g[i] = (uint16_t)((c->g[i] >> 14) * ETCH_CHUNK_GREEN_MAX / 3);
        c->b[i] = (uint16_t)((c->b[i] >> 14) * ETCH_CHUNK_RED_MAX / 3);
    }
}

static void draw_stage(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    static etch_varying *const varyings[] = {etch_varying_color, NULL};
    static const struct etch_stage stages[2][4] = {
        {{etch_source_color, NULL}, {posterize, NULL}, {etch_stage_write, NULL}, {NULL, NULL}},
        {{etch_source_color, NULL},
         {posterize, NULL},
         {etch_stage_write_swapped, NULL},
         {NULL, NULL}}};
    const struct etch_pipeline pipeline = {varyings, stages[run->scene->format],
                                           run->stats != NULL ? etch_scene_count
                                                              : etch_kernel_staged};
    const struct etch_vertex *vertex = step->of.data;
    const struct etch_vertex *const v[3] = {&vertex[0], &vertex[1], &vertex[2]};
    struct etch_staged_planes planes;

    count_triangle(run);
    run->kernel = etch_kernel_staged;
    etch_triangle_staged(&run->surface, v, &pipeline, &planes);
}

/* ---- weights: colours mixed, in bands by the distance from the nearest side
 * ---------------------- */

struct mixing {
    const struct etch_scene_run *run;
    const struct etch_vertex *v;
};

static uint16_t mix(void *context, int16_t x, int16_t y, const uint32_t b_q16[3])
{
    const struct mixing *m = context;
    const uint32_t one = b_q16[0] < b_q16[1] ? b_q16[0] : b_q16[1];
    const uint32_t least = one < b_q16[2] ? one : b_q16[2];
    uint32_t rgb[3] = {0, 0, 0};
    uint8_t out[3];

    (void)x, (void)y;
    for (int i = 0; i < 3; i++) {
        rgb[0] += m->v[i].r * b_q16[i];
        rgb[1] += m->v[i].g * b_q16[i];
        rgb[2] += m->v[i].b * b_q16[i];
    }
    for (int k = 0; k < 3; k++) {
        out[k] = (uint8_t)(rgb[k] >> ((least * 32 >> 16) % 2 != 0 ? 17 : 16));
    }
    if (m->run->stats != NULL) {
        m->run->stats->pixels++;
    }
    return etch_scene_color(m->run, out);
}

static void draw_weights(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct etch_vertex *vertex = step->of.data;
    const struct etch_vertex *const v[3] = {&vertex[0], &vertex[1], &vertex[2]};
    struct mixing mixing = {run, vertex};

    count_triangle(run);
    etch_triangle_barycentric(&run->surface, v, mix, &mixing);
}

/* ---- the statement
 * ------------------------------------------------------------------------------- */

/* kernel|stage|weights V V V */
static bool read_shadertri(struct etch_scene_reader *reader,
                           const struct etch_scene_statement *statement)
{
    static const char *const words[] = {"kernel", "stage", "weights", NULL};
    static const struct etch_scene_statement ways[] = {
        {"shadertri", NULL, draw_kernel, "etch_triangle_gouraud", NULL},
        {"shadertri", NULL, draw_stage, "etch_triangle_staged etch_kernel_staged", NULL},
        {"shadertri", NULL, draw_weights, "etch_triangle_barycentric", NULL},
    };
    struct etch_vertex *v = etch_scene_data(reader, 3 * sizeof *v);
    struct etch_scene_step *step;
    int way;

    (void)statement;
    if (v == NULL || !etch_text_choice(&reader->text, "shader", words, &way)) {
        return false;
    }
    step = etch_scene_append(reader, &ways[way]);
    if (step == NULL) {
        return false;
    }
    step->of.data = v;
    return etch_scene_read_line_vertex(reader, &v[0]) &&
           etch_scene_read_line_vertex(reader, &v[1]) && etch_scene_read_line_vertex(reader, &v[2]);
}

const struct etch_scene_statement etch_scene_shader_statements[] = {
    {"shadertri", read_shadertri, NULL, NULL, NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
