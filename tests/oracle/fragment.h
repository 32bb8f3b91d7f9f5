/* tests/oracle/fragment.h: what becomes of one pixel under one triangle, step by step as OpenGL
 * defines it, from exact rationals. Slow and plain; nothing here is shared with core.
 *
 * Colours and alpha are fractions of full in 2^-30 (ORACLE_ONE), rounded down by a few units. */
#ifndef TESTS_ORACLE_FRAGMENT_H
#define TESTS_ORACLE_FRAGMENT_H

#include "triangle.h"

#define ORACLE_ONE (INT64_C(1) << 30)

/* Members count words in the order of the scene format's, 0 first; z functions begin with never. */
struct oracle_state {
    bool flat, persp;
    int ztest, zwrite;               /* off, never, .. */
    int stencil, reference, mask;    /* off, never, .. */
    int write_mask, operation[3];    /* keep zero replace incr decr invert incrwrap decrwrap */
    int blend, constant;             /* off alpha add mul addalpha constant */
    int atest;                       /* the reference, -1: off */
    int fog, start, end, fog_rgb[3]; /* off linear exp; density in 2^-16 */
    int64_t density;
    int logic;                  /* truth table: bit 3 .. 0 for S D = 11, 10, 01, 00; -1: off */
    int color_mask;             /* bits that may change */
    int tex, wrap;              /* off replace modulate decal; repeat clamp mirror */
    int width, height;          /* of the texture */
    const uint16_t *texels;     /* RGB565 .. */
    const uint8_t *texel_alpha; /* .. and alpha */
};

struct oracle_vertex {
    int32_t z;  /* 0 .. 65535 */
    uint32_t w; /* 1 .. 65535 */
    uint8_t rgba[4];
    int32_t u, v; /* 16.16 */
};

struct oracle_pixel {
    uint16_t color, depth;
    uint8_t stencil;
};

/* What pixel (x, y), covered by `t`, may become. */
struct oracle_fragment {
    bool doubtful;      /* a test or a texel is decided by less than what values may err by */
    bool drawn;         /* the fragment passed all tests */
    bool exact;         /* color below is to be met bit for bit */
    int64_t channel[3]; /* else each channel within bounds of this; see oracle_fragment_color_ok */
    struct oracle_pixel pixel; /* depth and stencil exactly; color if not drawn, or exact */
};
void oracle_fragment(struct oracle_fragment *out, const struct oracle_state *s,
                     const struct oracle_triangle *t, const struct oracle_vertex v[3], int32_t x,
                     int32_t y, struct oracle_pixel before);

/* The same for the pixel k = 0 .. length pixels along the major axis from v[0] to v[1], or for the
 * only one of a line without length, which has the mean. The state's texture is not read. */
void oracle_line_fragment(struct oracle_fragment *out, const struct oracle_state *s,
                          const struct oracle_vertex v[2], int64_t k, int64_t length,
                          struct oracle_pixel before);

/* Whether a drawn pixel may have this color: each channel that may change within 1/2 + bound / 2^30
 * of an output step. */
bool oracle_fragment_color_ok(const struct oracle_fragment *f, const struct oracle_state *s,
                              struct oracle_pixel before, uint16_t color, int64_t bound);

#endif
