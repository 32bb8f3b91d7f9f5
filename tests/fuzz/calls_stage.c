/* tests/fuzz: triangles, lines and points through stages: any sensible list of sources, tests,
 * textures, fog, blending and logic. */
#include "calls.h"

#define MOST_STAGES 24

/* A list under construction, and all that its stages may read. */
struct list {
    struct etch_stage stage[MOST_STAGES];
    int n;
    struct etch_stencil stencil;
    struct etch_alpha_test alpha;
    struct etch_blend_constant constant;
    struct etch_color_mask mask;
    struct etch_fog_linear fog;
    struct etch_fog_exponential haze;
    struct etch_sampler sampler;
};

static void add(struct list *l, etch_stage_function *run, const void *data)
{
    l->stage[l->n++] = (struct etch_stage){run, data};
    l->stage[l->n] = (struct etch_stage){NULL, NULL};
}

static void add_stencil(struct fuzz_calls *c, struct list *l)
{
    static etch_stage_function *const tests[] = {
        etch_stage_stencil_never,  etch_stage_stencil_less,    etch_stage_stencil_equal,
        etch_stage_stencil_lequal, etch_stage_stencil_greater, etch_stage_stencil_notequal,
        etch_stage_stencil_gequal, etch_stage_stencil_always};
    static etch_stencil_operation *const operations[] = {NULL,
                                                         etch_stencil_zero,
                                                         etch_stencil_replace,
                                                         etch_stencil_incr,
                                                         etch_stencil_decr,
                                                         etch_stencil_invert,
                                                         etch_stencil_incr_wrap,
                                                         etch_stencil_decr_wrap};

    l->stencil = (struct etch_stencil){.reference = fuzz_byte(c), .mask = fuzz_byte(c)};
    l->stencil.write_mask = fuzz_byte(c);
    l->stencil.fail = operations[fuzz_byte(c) % 8];
    l->stencil.depth_fail = operations[fuzz_byte(c) % 8];
    l->stencil.pass = operations[fuzz_byte(c) % 8];
    add(l, tests[fuzz_byte(c) % 8], &l->stencil);
}

static void add_texture(struct fuzz_calls *c, struct list *l)
{
    static etch_texel_wrap *const wraps[] = {etch_texels_repeat, etch_texels_clamp,
                                             etch_texels_mirror, etch_texels_repeat_power,
                                             etch_texels_mirror_power};
    static etch_texel_filter *const filters[] = {etch_filter_nearest, etch_filter_linear,
                                                 etch_filter_nearest_power,
                                                 etch_filter_linear_power};
    static etch_stage_function *const mixes[] = {
        etch_stage_texture_replace, etch_stage_texture_modulate, etch_stage_texture_decal};
    static const struct {
        etch_texel_colors *colors;
        etch_texel_alphas *alphas;
        uint16_t alpha_bytes; /* 0: one a texel */
    } formats[] = {
        {etch_texels_rgb565, NULL, 0},
        {etch_texels_rgb565, etch_texels_mask, 0},
        {etch_texels_rgb565, etch_texels_unlike, 0},
        {etch_texels_index8, etch_texels_alpha8, 256},
        {etch_texels_index4, etch_texels_alpha4, 16},
        {etch_texels_index2, NULL, 0},
        {etch_texels_index1, NULL, 0},
        {etch_texels_ink, etch_texels_mask, 0},
        {etch_texels_ink, etch_texels_mask4, 0},
    };
    const uint8_t kind = fuzz_byte(c), form = (uint8_t)(fuzz_byte(c) % 9);
    const bool power = kind % 5 >= 3;
    const uint16_t width = (uint16_t)(power ? 8 : 1 + kind % 7);
    const uint16_t height = (uint16_t)(power ? 4 : 1 + kind / 32);
    const size_t size = (size_t)width * height;
    const struct etch_image image = {
        formats[form].colors,
        formats[form].alphas,
        fuzz_memory(size * 2),
        fuzz_memory(512),
        fuzz_memory(formats[form].alpha_bytes == 0 ? size : formats[form].alpha_bytes),
        width,
        height,
        width};
    const bool fused = power && form == 0; /* what fused filters take */

    if (etch_sampler_init(&l->sampler, &image, filters[fused ? kind % 4 : kind % 2],
                          wraps[kind % 5]) != ETCH_OK) {
        fuzz_fail("a sampler is refused");
    }
    add(l, mixes[kind / 64 % 3], &l->sampler);
}

static void add_depth(struct fuzz_calls *c, struct list *l)
{
    static etch_stage_function *const tests[] = {
        etch_stage_depth_never,  etch_stage_depth_less,    etch_stage_depth_equal,
        etch_stage_depth_lequal, etch_stage_depth_greater, etch_stage_depth_notequal,
        etch_stage_depth_gequal};
    const uint8_t kind = fuzz_byte(c);

    add(l, etch_source_depth, NULL);
    if (kind % 8 < 7) {
        add(l, tests[kind % 8], NULL);
    }
    if (kind < 128) {
        add(l, etch_stage_depth_write, NULL);
    }
}

static void add_fog(struct fuzz_calls *c, struct list *l)
{
    const uint16_t start = fuzz_word(c), end = fuzz_word(c);

    if (etch_fog_linear_init(&l->fog, start, end, 9, 99, 199) == ETCH_OK) {
        add(l, etch_stage_fog_linear, &l->fog);
    } else if (etch_fog_exponential_init(&l->haze, fuzz_s32(c), 99, 9, 250) == ETCH_OK) {
        add(l, etch_stage_fog_exponential, &l->haze);
    }
}

/* What follows the colour: blending or logic, a mask, the write. */
static void add_output(struct fuzz_calls *c, struct list *l)
{
    static etch_stage_function *const mixes[] = {
        etch_stage_blend_alpha,        etch_stage_blend_add,         etch_stage_blend_add_alpha,
        etch_stage_blend_multiply,     etch_stage_blend_constant,    etch_stage_logic_clear,
        etch_stage_logic_and,          etch_stage_logic_and_reverse, etch_stage_logic_copy,
        etch_stage_logic_and_inverted, etch_stage_logic_noop,        etch_stage_logic_xor,
        etch_stage_logic_or,           etch_stage_logic_nor,         etch_stage_logic_equiv,
        etch_stage_logic_invert,       etch_stage_logic_or_reverse,  etch_stage_logic_copy_inverted,
        etch_stage_logic_or_inverted,  etch_stage_logic_nand,        etch_stage_logic_set};
    const uint8_t kind = fuzz_byte(c), mask = fuzz_byte(c);
    const bool swapped = mask % 2 == 0;

    add(l, swapped ? etch_stage_read_swapped : etch_stage_read, NULL);
    l->constant.alpha = mask;
    if (kind < 240) {
        add(l, mixes[kind % 21], &l->constant);
    }
    if (mask >= 128) {
        l->mask.bits = fuzz_word(c);
        add(l, etch_stage_color_mask, &l->mask);
    }
    add(l, swapped ? etch_stage_write_swapped : etch_stage_write, NULL);
}

/* `has` bits: 1 stencil, 2 alpha test, 4 depth, 8 fog, 16 texture. The sources of colour stand
 * there. */
static void fill(struct fuzz_calls *c, struct list *l, uint8_t has)
{
    if ((has & 16) != 0) {
        add_texture(c, l);
    }
    if ((has & 2) != 0) {
        l->alpha.reference = fuzz_byte(c);
        add(l, etch_stage_alpha_gequal, &l->alpha);
    }
    if ((has & 1) != 0) {
        add_stencil(c, l);
    }
    if ((has & 12) != 0) {
        add_depth(c, l);
    }
    if ((has & 1) != 0) {
        add(l, etch_stage_stencil_update, &l->stencil);
    }
    if ((has & 8) != 0) {
        add_fog(c, l);
    }
    add_output(c, l);
}

/* ---- primitives ------------------------------------------------------------------------------ */

static struct etch_texture_vertex vertex(struct fuzz_calls *c)
{
    struct etch_texture_vertex v = {.at = fuzz_vertex(c)};
    const uint8_t w = fuzz_byte(c);

    v.u = (etch_q16)(fuzz_byte(c) * INT32_C(40000)) - 3000000;
    v.v = w < 16 ? INT32_MIN : w < 32 ? INT32_MAX : w * INT32_C(9999);
    v.w = w < 128 ? 1U + w % 3 : w < 192 ? 65535 : UINT32_C(1) << w % 32;
    return v;
}

static void triangle(struct fuzz_calls *c, fuzz_function *f)
{
    static etch_varying *const flat[] = {etch_varying_flat, etch_varying_depth,
                                         etch_varying_texture, NULL};
    static etch_varying *const linear[] = {etch_varying_color, etch_varying_alpha,
                                           etch_varying_depth, etch_varying_texture, NULL};
    static etch_varying *const deep[] = {etch_varying_color_perspective, etch_varying_depth,
                                         etch_varying_texture_perspective, NULL};
    static etch_varying *const *const varyings[] = {flat, linear, deep};
    static etch_stage_function *const coordinates[] = {
        etch_source_texture_perspective, etch_source_texture_blocks16, etch_source_texture_blocks8};
    const uint8_t kind = fuzz_byte(c), has = fuzz_byte(c);
    struct etch_staged_planes *planes = fuzz_memory(sizeof *planes);
    struct list l = {.n = 0};
    const struct etch_pipeline pipeline = {varyings[kind % 3], l.stage, etch_kernel_staged};

    (void)f;
    add(&l,
        kind % 3 == 0   ? etch_source_flat
        : kind % 3 == 1 ? etch_source_color
                        : etch_source_color_perspective,
        NULL);
    if (kind % 3 == 1) {
        add(&l, etch_source_alpha, NULL);
    }
    add(&l, kind % 3 == 2 ? coordinates[kind / 3 % 3] : etch_source_texture, NULL);
    const struct etch_texture_vertex v[3] = {vertex(c), vertex(c), vertex(c)};
    const struct etch_vertex *const p[3] = {&v[0].at, &v[1].at, &v[2].at};

    fill(c, &l, has);
    etch_triangle_staged(&c->s, p, &pipeline, planes);
}

enum {
    LINE,
    POINT,
    WIDE
};

static void line_or_point(struct fuzz_calls *c, int what)
{
    static etch_line_varying *const flat[] = {etch_line_varying_flat, etch_line_varying_depth,
                                              NULL};
    static etch_line_varying *const linear[] = {etch_line_varying_color, etch_line_varying_alpha,
                                                etch_line_varying_depth, NULL};
    static etch_varying *const wide[] = {etch_varying_color, etch_varying_alpha, etch_varying_depth,
                                         NULL};
    const uint8_t kind = fuzz_byte(c), has = fuzz_byte(c);
    const uint16_t size = fuzz_word(c);
    const bool is_flat = kind % 2 == 0 && what != WIDE;
    struct etch_staged_planes *planes = fuzz_memory(sizeof *planes);
    struct list l = {.n = 0};
    const struct etch_line_pipeline line = {is_flat ? flat : linear, l.stage, etch_kernel_staged};
    const struct etch_pipeline triangles = {wide, l.stage, etch_kernel_staged};

    add(&l, is_flat ? etch_source_flat : etch_source_color, NULL);
    if (!is_flat) {
        add(&l, etch_source_alpha, NULL);
    }
    const struct etch_vertex v[2] = {fuzz_vertex(c), fuzz_vertex(c)};
    const struct etch_vertex *const p[2] = {&v[0], &v[1]};

    fill(c, &l, has & 15);
    if (what == LINE) {
        etch_line_staged(&c->s, p, &line, planes);
    } else if (what == WIDE) {
        etch_line_wide_staged(&c->s, p, size, &triangles, planes);
    } else {
        etch_point_staged(&c->s, &v[0], size,
                          kind < 128 ? etch_point_runs_square : etch_point_runs_round, &line,
                          planes);
    }
}

static void line(struct fuzz_calls *c, fuzz_function *f)
{
    (void)f;
    line_or_point(c, LINE);
}

static void point(struct fuzz_calls *c, fuzz_function *f)
{
    (void)f;
    line_or_point(c, POINT);
}

static void wide(struct fuzz_calls *c, fuzz_function *f)
{
    (void)f;
    line_or_point(c, WIDE);
}

const struct fuzz_row fuzz_stage_rows[] = {
    {"etch_triangle_staged", triangle, NULL},
    {"etch_line_staged", line, NULL},
    {"etch_point_staged", point, NULL},
    {"etch_line_wide_staged", wide, NULL},
    {NULL, NULL, NULL},
};
