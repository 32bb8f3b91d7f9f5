/* tests/harness/shapes.h: seeded triangles of every kind, shared by the suites. */
#ifndef TESTS_HARNESS_SHAPES_H
#define TESTS_HARNESS_SHAPES_H

#include "core/base/rect.h"

/* Vertices in 1/256 px, -2^23 .. 2^23. */
struct test_triangle {
    int32_t x[3], y[3];
};

enum test_triangle_kind {
    TEST_TRIANGLE_random,     /* round the window, 1/256 grid */
    TEST_TRIANGLE_thin,       /* a sliver: the third vertex within 1/16 px of an edge */
    TEST_TRIANGLE_tiny,       /* all three within 2 px */
    TEST_TRIANGLE_huge,       /* anywhere in the plane */
    TEST_TRIANGLE_extreme,    /* coordinates mostly at the least and greatest value */
    TEST_TRIANGLE_centres,    /* on pixel centres */
    TEST_TRIANGLE_corners,    /* on pixel corners, axis-parallel edges often */
    TEST_TRIANGLE_sixteenths, /* on the 1/16 px grid */
    TEST_TRIANGLE_degenerate, /* collinear or equal vertices, or one ulp beside */
    TEST_TRIANGLE_far,        /* one vertex near, the others far: long slivers over the window */
    TEST_TRIANGLE_screen,     /* as large as a screen */
    TEST_TRIANGLE_sliver,     /* as long as a screen, 1/256 .. 4 px thick, over a pixel centre */
    TEST_TRIANGLE_tall,       /* 2^22 .. 2^24 / 256 px tall, up to 2 / 256 px beside centres */
    TEST_TRIANGLE_KINDS
};

/* A triangle that has to do with the window. */
void test_triangle_make(struct test_triangle *t, enum test_triangle_kind kind,
                        struct etch_rect window, uint32_t *seed);

/* The six orders of three things. */
extern const uint8_t test_orders[6][3];

#endif
