/* tests/fuzz/calls.h: public drawing functions called with arguments out of bytes.
 *
 * An input is a surface and up to 16 calls of 64 bytes each. A call is a row of a table, found by
 * the first two bytes; its function takes the rest as arguments, within what the header promises
 * and no further. What lies outside the clip must not change, see calls.c. A row of a family calls
 * several functions. */
#ifndef TESTS_FUZZ_CALLS_H
#define TESTS_FUZZ_CALLS_H

#include "core/etch.h"
#include "fuzz.h"

struct fuzz_calls {
    const uint8_t *at, *end; /* the call's bytes; zeros follow */
    struct etch_surface s;   /* with depth and stencil */
};

/* A function of the library, cast; the call knows its type. */
typedef void fuzz_function(void);
typedef void fuzz_call(struct fuzz_calls *c, fuzz_function *function);

struct fuzz_row {
    const char *name;
    fuzz_call *call;
    fuzz_function *function; /* NULL where the call names it */
};

/* The tables, NULL-terminated by name. */
extern const struct fuzz_row fuzz_shape_rows[], fuzz_run_rows[], fuzz_triangle_rows[],
    fuzz_texture_rows[], fuzz_image_rows[], fuzz_stage_rows[], fuzz_frame_rows[],
    fuzz_smooth_rows[], fuzz_mesh_rows[];

/* ---- arguments ------------------------------------------------------------------------------ */

uint8_t fuzz_byte(struct fuzz_calls *c);
uint16_t fuzz_word(struct fuzz_calls *c);
uint32_t fuzz_long(struct fuzz_calls *c);

/* 0 .. n - 1 */
uint16_t fuzz_below(struct fuzz_calls *c, uint16_t n);

/* Every int16_t: mostly on or near the window, or at the ends of the range. */
int16_t fuzz_x(struct fuzz_calls *c);
int16_t fuzz_y(struct fuzz_calls *c);

/* A length or radius: mostly small, or at the ends. */
int16_t fuzz_size(struct fuzz_calls *c);

/* Every position -2^23 .. 2^23, likewise. */
int32_t fuzz_x_q8(struct fuzz_calls *c);
int32_t fuzz_y_q8(struct fuzz_calls *c);

/* Every int32_t, mostly small or at the ends. */
int32_t fuzz_s32(struct fuzz_calls *c);

/* Any rectangle, inverted ones too. */
struct etch_rect fuzz_rect(struct fuzz_calls *c);

struct etch_vertex fuzz_vertex(struct fuzz_calls *c);

/* A paint that checks the contract of base/paint.h and writes a colour. */
const struct etch_paint *fuzz_paint(struct fuzz_calls *c);

/* The same for covers. */
const struct etch_cover_paint *fuzz_cover_paint(struct fuzz_calls *c);

/* Memory for one call, aligned for anything, of so many bytes exactly; given back after the call.
 * */
void *fuzz_memory(size_t bytes);

#endif
