/* ports/host/scene_pipeline_texture.c: the table of texture kernels. scene_pipeline.c looks a
 * state with a texture up here. The depth tests that the core does not ship are made here, from
 * the core's shader in perspective and an affine one, written as any user would. */
#include "scene_pipeline.h"

#include "../../core/fragment/texture_exact.h"

enum {
    OFF,
    NEVER,
    LESS,
    EQUAL,
    LEQUAL,
    GREATER,
    NOTEQUAL,
    GEQUAL,
    ALWAYS
};
enum {
    PRECISE,
    FAST,
    FAST8 = 3
};

/* ---- an affine shader: coordinates as base/texture.h says ------------------------------------ */

static inline void start(struct etch_fragment *f, const struct etch_paint *paint)
{
    const struct etch_texture_paint *p = (const struct etch_texture_paint *)paint;

    f->v[0] = etch_plane_at(&p->u, f->x, f->y);
    f->v[1] = etch_plane_at(&p->v, f->x, f->y);
}

static inline void step(struct etch_fragment *f, const struct etch_paint *paint)
{
    const struct etch_texture_paint *p = (const struct etch_texture_paint *)paint;

    f->v[0] = etch_wrap_add(f->v[0], p->u.dx);
    f->v[1] = etch_wrap_add(f->v[1], p->v.dx);
}

static inline uint16_t color(const struct etch_fragment *f, const struct etch_paint *paint)
{
    const struct etch_texel_map *map = &((const struct etch_texture_paint *)paint)->map;

    return map->texels[((f->v[0] >> 19 & map->columns) + (f->v[1] >> 15 & map->rows)) / 2];
}

static const struct etch_shader affine_shader = {start, step, color};

/* affine_TEST_WRITE, perspective_TEST_WRITE, and texture_TEST_WRITE, which holds both. */
#define AFFINE(test, write)                                                                        \
    static ETCH_KERNEL(affine_##test##_##write, affine_shader, etch_depth_##test, write)
#define PERSPECTIVE(test, write)                                                                   \
    static ETCH_KERNEL(perspective_##test##_##write, etch_perspective_shader, etch_depth_##test,   \
                       write)
#define KERNELS(test, write)                                                                       \
    AFFINE(test, write)                                                                            \
    PERSPECTIVE(test, write)                                                                       \
    static const struct etch_perspective_kernels texture_##test##_##write = {                      \
        affine_##test##_##write, perspective_##test##_##write, perspective_##test##_##write};

KERNELS(never, 0)
KERNELS(never, 1)
KERNELS(less, 0)
KERNELS(equal, 0)
KERNELS(equal, 1)
KERNELS(lequal, 0)
KERNELS(greater, 0)
KERNELS(greater, 1)
KERNELS(notequal, 0)
KERNELS(notequal, 1)
KERNELS(gequal, 0)
KERNELS(gequal, 1)
KERNELS(always, 0)
KERNELS(always, 1)

/* ---- the table ------------------------------------------------------------------------------- */

struct row {
    uint8_t persp, mode;
    struct etch_scene_pipeline pipeline;
};

#define ROW(perspective_, mode_, test, write, kernels, kernel_name)                                \
    {                                                                                              \
        .persp = (perspective_), .mode = (mode_), .pipeline = {                                    \
            .ztest = (test),                                                                       \
            .zwrite = (write),                                                                     \
            .name = {kernel_name, kernel_name},                                                    \
            .texture = &(kernels),                                                                 \
            .perspective = (perspective_) != 0                                                     \
        }                                                                                          \
    }

/* The kernels of one depth test that is made here. */
#define ROWS(ztest, zwrite, test)                                                                  \
    ROW(0, PRECISE, ztest, zwrite, texture_##test##_##zwrite, "affine_" #test "_" #zwrite),        \
        ROW(1, PRECISE, ztest, zwrite, texture_##test##_##zwrite,                                  \
            "perspective_" #test "_" #zwrite)

static const struct row table[] = {
    ROW(0, PRECISE, OFF, 0, etch_perspective_exact, "etch_kernel_texture"),
    ROW(0, PRECISE, LESS, 1, etch_perspective_exact_less, "etch_kernel_texture_less"),
    ROW(0, PRECISE, LEQUAL, 1, etch_perspective_exact_lequal, "etch_kernel_texture_lequal"),
    ROW(1, PRECISE, OFF, 0, etch_perspective_exact, "etch_perspective_exact"),
    ROW(1, PRECISE, LESS, 1, etch_perspective_exact_less, "etch_perspective_exact_less"),
    ROW(1, PRECISE, LEQUAL, 1, etch_perspective_exact_lequal, "etch_perspective_exact_lequal"),
    ROW(1, FAST, OFF, 0, etch_perspective, "etch_perspective"),
    ROW(1, FAST, LESS, 1, etch_perspective_less, "etch_perspective_less"),
    ROW(1, FAST, LEQUAL, 1, etch_perspective_lequal, "etch_perspective_lequal"),
    ROWS(NEVER, 0, never),
    ROWS(NEVER, 1, never),
    ROWS(LESS, 0, less),
    ROWS(EQUAL, 0, equal),
    ROWS(EQUAL, 1, equal),
    ROWS(LEQUAL, 0, lequal),
    ROWS(GREATER, 0, greater),
    ROWS(GREATER, 1, greater),
    ROWS(NOTEQUAL, 0, notequal),
    ROWS(NOTEQUAL, 1, notequal),
    ROWS(GEQUAL, 0, gequal),
    ROWS(GEQUAL, 1, gequal),
    ROWS(ALWAYS, 0, always),
    ROWS(ALWAYS, 1, always),
};

/* Whether the state asks for what only stages do. */
static bool is_beyond(const struct etch_scene_state *state)
{
    return state->tex != 1 || state->filter != 0 || state->wrap != 0 || state->wrap_v > 1 ||
           state->mipmap != 0 || (state->mode == FAST8 && state->persp != 0);
}

static const struct etch_scene_pipeline *find(const struct etch_scene_state *state, uint8_t mode)
{
    const uint8_t zwrite = state->ztest == OFF ? 0 : state->zwrite; /* off does not write */

    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        const struct row *row = &table[i];

        if (row->persp == state->persp && row->mode == mode &&
            row->pipeline.ztest == state->ztest && row->pipeline.zwrite == zwrite) {
            return &row->pipeline;
        }
    }
    return NULL;
}

/* Where there is no faster kernel, the precise one draws: it has all depth tests. */
const struct etch_scene_pipeline *
etch_scene_pipeline_find_texture(const struct etch_scene_state *state)
{
    const struct etch_scene_pipeline *row = is_beyond(state) ? NULL : find(state, state->mode);

    return row != NULL || is_beyond(state) ? row : find(state, PRECISE);
}
