/* ports/host/array.h: arrays that grow. */
#ifndef ETCH_HOST_ARRAY_H
#define ETCH_HOST_ARRAY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdlib.h>

/* Makes room for element `count` (so for count + 1 of them) in *data, an array from malloc or
 * NULL, of *capacity elements of `size` bytes. False if there is no memory; the array is then
 * as it was. Usage: if (!etch_array_grow((void **)&p, &capacity, n, sizeof *p)) .. */
bool etch_array_grow(void **data, size_t *capacity, size_t count, size_t size);

#endif
