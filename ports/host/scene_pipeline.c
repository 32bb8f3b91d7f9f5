/* ports/host/scene_pipeline.c: the table of painters and kernels. The scene reader looks a
 * state up when a triangle or mesh is read. The depth tests that the core does not ship are
 * made here, with the one line that any user would write. */
#include "scene_pipeline.h"

#include "../../core/draw/blend.h"
#include "../../core/fragment/blend_fused.h"
#include "../../core/fragment/flat_shader.h"
#include "../../core/fragment/gouraud_shader.h"

enum {
    SMOOTH,
    FLAT
};
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

/* flat_TEST_WRITE, gouraud_TEST_WRITE and gouraud_TEST_WRITE_swapped. */
#define KERNELS(test, write)                                                                       \
    static ETCH_KERNEL(                                                                            \
        flat_##test##_##write, etch_flat_shader, etch_depth_##test,                                \
        write) static ETCH_KERNEL(gouraud_##test##_##write, etch_gouraud_shader,                   \
                                  etch_depth_##test,                                               \
                                  write) static ETCH_KERNEL(gouraud_##test##_##write##_swapped,    \
                                                            etch_gouraud_swapped_shader,           \
                                                            etch_depth_##test, write)

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

#define ROW(kind, test, write, paints, paints_swapped, draws, draws_swapped)                       \
    {                                                                                              \
        .shade = (kind), .ztest = (test), .zwrite = (write), .painter = {paints, paints_swapped},  \
        .kernel = {draws, draws_swapped}, .name = {#draws, #draws_swapped}, .painter_name = {      \
            #paints,                                                                               \
            #paints_swapped                                                                        \
        }                                                                                          \
    }
#define FLAT_ROW(ztest, zwrite, kernel)                                                            \
    ROW(FLAT, ztest, zwrite, etch_triangle_flat_depth, etch_triangle_flat_depth_swapped, kernel,   \
        kernel)
#define SMOOTH_ROW(ztest, zwrite, kernel)                                                          \
    ROW(SMOOTH, ztest, zwrite, etch_triangle_gouraud_depth, etch_triangle_gouraud_depth, kernel,   \
        kernel##_swapped)

#define BLEND_ROW(kind, paints, draws)                                                             \
    {                                                                                              \
        .shade = (kind), .painter = {paints, paints}, .kernel = {draws, draws##_swapped},          \
        .name = {#draws, #draws "_swapped"}, .painter_name = {                                     \
            #paints,                                                                               \
            #paints                                                                                \
        }                                                                                          \
    }

#define ROWS(ztest, zwrite, test)                                                                  \
    FLAT_ROW(ztest, zwrite, flat_##test##_##zwrite),                                               \
        SMOOTH_ROW(ztest, zwrite, gouraud_##test##_##zwrite)

static const struct etch_scene_pipeline table[] = {
    ROW(FLAT, OFF, 0, etch_triangle_flat, etch_triangle_flat_swapped, etch_kernel_flat,
        etch_kernel_flat),
    ROW(SMOOTH, OFF, 0, etch_triangle_gouraud, etch_triangle_gouraud, etch_kernel_gouraud,
        etch_kernel_gouraud_swapped),
    FLAT_ROW(LESS, 1, etch_kernel_flat_less),
    SMOOTH_ROW(LESS, 1, etch_kernel_gouraud_less),
    FLAT_ROW(LEQUAL, 1, etch_kernel_flat_lequal),
    SMOOTH_ROW(LEQUAL, 1, etch_kernel_gouraud_lequal),
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

bool etch_scene_pipeline_needs_stages(const struct etch_scene_state *state)
{
    return state->blend != 0 || state->stencil != 0 || state->atest != 0 || state->fog != 0 ||
           state->logic != 0 || state->color_mask != UINT16_MAX;
}

const struct etch_scene_pipeline *etch_scene_pipeline_find(const struct etch_scene_state *state)
{
    const uint8_t zwrite = state->ztest == OFF ? 0 : state->zwrite; /* off does not write */

    if (etch_scene_pipeline_needs_stages(state)) {
        return NULL;
    }
    if (state->tex != 0) {
        return etch_scene_pipeline_find_texture(state);
    }
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        if (table[i].shade == state->shade && table[i].ztest == state->ztest &&
            table[i].zwrite == zwrite) {
            return &table[i];
        }
    }
    return NULL;
}

const struct etch_scene_pipeline *
etch_scene_pipeline_find_blend(const struct etch_scene_state *state)
{
    static const struct etch_scene_pipeline blends[] = {
        BLEND_ROW(SMOOTH, etch_triangle_gouraud_blend, etch_kernel_gouraud_blend),
        BLEND_ROW(FLAT, etch_triangle_flat_blend, etch_kernel_flat_blend),
    };
    struct etch_scene_state opaque = *state;

    opaque.blend = 0;
    return state->blend == 1 && state->ztest == OFF && state->tex == 0 &&
                   !etch_scene_pipeline_needs_stages(&opaque)
               ? &blends[state->shade]
               : NULL;
}
