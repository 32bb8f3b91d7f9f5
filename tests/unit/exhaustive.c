/* tests/unit: a sample of `make exhaustive`, each shape of a stride that is prime to the grid's
 * sides. */
#include "tests/exhaustive/grid.h"
#include "tests/harness/harness.h"

void suite_exhaustive(void);

static void check(struct grid_count count, const char *what)
{
    CHECK(count.tried != 0);
    CHECK_EQ(count.wrong, 0);
    test_print_count("  ", count.tried, what);
}

static void triangles_are_their_edge_functions(void)
{
    check(grid_triangles(5, INT64_C(193) * TEST_DIVISOR), " triangles of a grid, no wrong pixel");
}

static void triangles_off_the_grid_are_their_edge_functions(void)
{
    check(grid_triangles_moved(5, INT64_C(97) * TEST_DIVISOR),
          " triangles off the grid, no wrong pixel");
}

static void clipped_lines_are_masked_lines(void)
{
    check(grid_lines(5, INT64_C(1999) * TEST_DIVISOR), " clipped lines of a grid, no wrong pixel");
}

static void clipped_circles_are_masked_circles(void)
{
    check(grid_circles(5, INT64_C(199) * TEST_DIVISOR),
          " clipped circles of a grid, no wrong pixel");
}

void suite_exhaustive(void)
{
    RUN(triangles_are_their_edge_functions);
    RUN(triangles_off_the_grid_are_their_edge_functions);
    RUN(clipped_lines_are_masked_lines);
    RUN(clipped_circles_are_masked_circles);
}
