/* vertex/elements_read.h: reading element lists; no part of the API. */
#ifndef ETCH_VERTEX_ELEMENTS_READ_H
#define ETCH_VERTEX_ELEMENTS_READ_H

#include "elements.h"

/* Element i, or false if it names no vertex. */
ETCH_INLINE bool elements_read(const struct etch_elements *e, uint32_t i, uint16_t *index)
{
    const uint32_t value = e->indices != NULL ? e->indices[i] : i;

    *index = (uint16_t)(value & 0xFFFF);
    return value < e->limit;
}

/* A list of primitives of `size` vertices. */
ETCH_INLINE void elements_list(const struct etch_elements *e, struct etch_element_sink *sink,
                               uint8_t size)
{
    for (uint32_t i = 0; i < e->count && e->count - i >= size; i += size) {
        uint16_t index[3];
        bool ok = true;

        for (uint8_t k = 0; k < size; k++)
            ok = elements_read(e, i + k, &index[k]) && ok;
        if (ok)
            sink->take(sink, index);
    }
}

#endif
