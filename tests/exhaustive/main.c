/* tests/exhaustive: a part of all shapes. exhaustive PART PARTS; the last line is "N passed, N
 * failed". */
#include <stdio.h>
#include <stdlib.h>

#include "grid.h"

static int report(const char *name, struct grid_count count)
{
    printf("%-32s %10lld tried, %lld wrong\n", name, (long long)count.tried,
           (long long)count.wrong);
    return count.wrong != 0 || count.tried == 0;
}

int main(int argc, char **argv)
{
    const int64_t first = argc == 3 ? atoi(argv[1]) : 0, step = argc == 3 ? atoi(argv[2]) : 1;
    int failed = report("triangles on quarters", grid_triangles(first, step));

    failed += report("triangles off the quarters", grid_triangles_moved(first, step));
    failed += report("lines under every clip", grid_lines(first, step));
    failed += report("circles, discs under every clip", grid_circles(first, step));
    printf("%d passed, %d failed\n", 4 - failed, failed);
    return failed != 0;
}
