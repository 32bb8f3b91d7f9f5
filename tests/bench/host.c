/* bench/host.c: what start.c gives, on the developer's machine. */
#include "bench.h"

#include <stdio.h>
#include <stdlib.h>

void bench_write(const char *name, const void *data, uint32_t bytes)
{
    FILE *f = fopen(name, "wb");

    if (f == NULL || fwrite(data, 1, bytes, f) != bytes || fclose(f) != 0) {
        perror(name);
        exit(1);
    }
}
