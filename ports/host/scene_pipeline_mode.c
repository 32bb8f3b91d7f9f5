/* ports/host/scene_pipeline_mode.c: painters and kernels of the exact mode, ordered dithering and
 * inverse depth. scene_staged.c asks before it looks at the table of the precise ones. */
#include "scene_pipeline.h"

#include "../../core/draw/dither.h"
#include "../../core/draw/exact.h"
#include "../../core/draw/inverse.h"

enum {
    OFF = 0,
    LESS = 2,
    LEQUAL = 4
};

#define FLAT(test, paints, paints_swapped, draws)                                                  \
    {                                                                                              \
        .shade = 1, .ztest = (test), .zwrite = (test) != OFF, .painter = {paints, paints_swapped}, \
        .kernel = {draws, draws}, .name = {#draws, #draws}, .painter_name = {                      \
            #paints,                                                                               \
            #paints_swapped                                                                        \
        }                                                                                          \
    }
#define BYTES(kind, test, paints, draws)                                                           \
    {                                                                                              \
        .shade = (kind), .ztest = (test), .zwrite = (test) != OFF, .painter = {paints, paints},    \
        .kernel = {draws, draws##_swapped}, .name = {#draws, #draws "_swapped"}, .painter_name = { \
            #paints,                                                                               \
            #paints                                                                                \
        }                                                                                          \
    }

/* Without depth a flat colour is exact in any mode. */
static const struct etch_scene_pipeline exact[] = {
    FLAT(OFF, etch_triangle_flat, etch_triangle_flat_swapped, etch_kernel_flat),
    FLAT(LESS, etch_triangle_flat_depth_exact, etch_triangle_flat_depth_exact_swapped,
         etch_kernel_flat_exact_less),
    FLAT(LEQUAL, etch_triangle_flat_depth_exact, etch_triangle_flat_depth_exact_swapped,
         etch_kernel_flat_exact_lequal),
    BYTES(0, OFF, etch_triangle_gouraud_exact, etch_kernel_gouraud_exact),
    BYTES(0, LESS, etch_triangle_gouraud_depth_exact, etch_kernel_gouraud_exact_less),
    BYTES(0, LEQUAL, etch_triangle_gouraud_depth_exact, etch_kernel_gouraud_exact_lequal),
    {.name = {NULL, NULL}},
};

static const struct etch_scene_pipeline dither[] = {
    BYTES(1, OFF, etch_triangle_flat_dither, etch_kernel_gouraud_dither),
    BYTES(1, LESS, etch_triangle_flat_depth_dither, etch_kernel_gouraud_dither_less),
    BYTES(1, LEQUAL, etch_triangle_flat_depth_dither, etch_kernel_gouraud_dither_lequal),
    BYTES(0, OFF, etch_triangle_gouraud, etch_kernel_gouraud_dither),
    BYTES(0, LESS, etch_triangle_gouraud_depth, etch_kernel_gouraud_dither_less),
    BYTES(0, LEQUAL, etch_triangle_gouraud_depth, etch_kernel_gouraud_dither_lequal),
    {.name = {NULL, NULL}},
};

static const struct etch_scene_pipeline inverse[] = {
    FLAT(LESS, etch_triangle_flat_inverse, etch_triangle_flat_inverse_swapped,
         etch_kernel_flat_inverse_less),
    FLAT(LEQUAL, etch_triangle_flat_inverse, etch_triangle_flat_inverse_swapped,
         etch_kernel_flat_inverse_lequal),
    BYTES(0, LESS, etch_triangle_gouraud_inverse, etch_kernel_gouraud_inverse_less),
    BYTES(0, LEQUAL, etch_triangle_gouraud_inverse, etch_kernel_gouraud_inverse_lequal),
    {.name = {NULL, NULL}},
};

bool etch_scene_mode_is_special(const struct etch_scene_state *state)
{
    return state->mode == 2 || state->dither != 0 || (state->depth != 0 && state->ztest != OFF);
}

const struct etch_scene_pipeline *
etch_scene_pipeline_find_mode(const struct etch_scene_state *state)
{
    const uint8_t zwrite = state->ztest == OFF ? 0 : state->zwrite;
    const bool deep = state->depth != 0 && state->ztest != OFF;
    const struct etch_scene_pipeline *row = deep ? inverse : state->dither != 0 ? dither : exact;

    if (etch_scene_pipeline_needs_stages(state) || state->tex != 0 || state->shade > 1 ||
        (state->mode == 2) + (state->dither != 0) + deep > 1) {
        return NULL;
    }
    for (; row->name[0] != NULL; row++) {
        if (row->shade == state->shade && row->ztest == state->ztest && row->zwrite == zwrite) {
            return row;
        }
    }
    return NULL;
}
