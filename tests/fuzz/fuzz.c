/* tests/fuzz: reports and planes. The targets call it. */
#include "fuzz.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void fuzz_fail(const char *why)
{
    (void)fprintf(stderr, "fuzz: %s\n", why);
    abort();
}

struct fuzz_planes fuzz_planes_open(size_t elements)
{
    const struct fuzz_planes planes = {malloc(elements * 2), malloc(elements * 2),
                                       malloc(elements)};

    if (planes.pixels == NULL || planes.depth == NULL || planes.stencil == NULL) {
        fuzz_fail("out of memory");
    }
    memset(planes.pixels, 0x5A, elements * 2);
    memset(planes.depth, 0x5A, elements * 2);
    memset(planes.stencil, 0x5A, elements);
    return planes;
}

void fuzz_planes_close(struct fuzz_planes *planes)
{
    free(planes->pixels);
    free(planes->depth);
    free(planes->stencil);
}
