/* fragment/test.h: stages that test fragments (stage.h): alpha and depth. Stencil: stencil.h.
 * In the order of the pipeline: alpha, stencil, depth. */
#ifndef ETCH_FRAGMENT_TEST_H
#define ETCH_FRAGMENT_TEST_H

#include "stage.h"

/* Keeps a pixel whose alpha is at least the reference: a >= reference, compared with all fraction
 * bits of a (8.8), not with a rounded a. Data: const struct etch_alpha_test. */
struct etch_alpha_test {
    uint8_t reference; /* 0 keeps all */
};
etch_stage_function etch_stage_alpha_gequal;

/* Keeps a pixel whose depth (z of the chunk) stands so to the stored one; no data. The surface must
 * have a depth plane. None writes depth. */
etch_stage_function etch_stage_depth_never;
etch_stage_function etch_stage_depth_less;
etch_stage_function etch_stage_depth_equal;
etch_stage_function etch_stage_depth_lequal;
etch_stage_function etch_stage_depth_greater;
etch_stage_function etch_stage_depth_notequal;
etch_stage_function etch_stage_depth_gequal;

/* Stores the depth of the pixels that are alive; no data. After a test it makes one with writing,
 * alone the test "always". */
etch_stage_function etch_stage_depth_write;

#endif
