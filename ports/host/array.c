/* ports/host/array.c: arrays that grow. The scene and OBJ readers call it. */
#include "array.h"

bool etch_array_grow(void **data, size_t *capacity, size_t count, size_t size)
{
    const size_t larger = *capacity < 64 ? 64 : *capacity * 2;
    void *grown;

    if (count < *capacity) {
        return true;
    }
    if (larger > (size_t)-1 / 2 / size) {
        return false;
    }
    grown = realloc(*data, larger * size);
    if (grown == NULL) {
        return false;
    }
    *data = grown;
    *capacity = larger;
    return true;
}
