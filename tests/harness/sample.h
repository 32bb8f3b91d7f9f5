/* tests/harness/sample.h: seeded triangles with colours and depths, and exact error bounds. */
#ifndef TESTS_HARNESS_SAMPLE_H
#define TESTS_HARNESS_SAMPLE_H

#include "canvas.h"
#include "core/base/sink.h"
#include "shapes.h"
#include "tests/oracle/triangle.h"

/* A triangle to draw, its exact twin and the attributes of its vertices. */
struct test_sample {
    struct test_triangle shape;
    struct oracle_triangle exact;
    struct etch_vertex vertex[3];
};

/* Sample i: a triangle of a kind in every window in turn; opens the canvas on its window. */
void test_sample_make_kind(struct test_sample *s, struct test_canvas *canvas,
                           enum test_triangle_kind kind, int32_t i, uint32_t *seed);

/* The same with every kind in turn. */
void test_sample_make(struct test_sample *s, struct test_canvas *canvas, int32_t i, uint32_t *seed);

/* After a failed CHECK: the pixel and the vertices. */
void test_sample_note(const struct test_sample *s, int32_t x, int32_t y);

/* |got - value / (area unit)| <= bound / 2^17, where `value` is oracle_triangle_value. */
bool test_sample_within(uint32_t got, struct wide value, uint64_t area, uint32_t unit,
                        uint32_t bound);

/* 1/2 + 1/64 in 2^-17. */
#define TEST_NEAR_BOUND (UINT32_C(65536) + 2048)

#endif
