/* ports/host/needs_table.h: what the parts of core and hal weigh and link, measured; see needs.h.
 */
#ifndef ETCH_HOST_NEEDS_TABLE_H
#define ETCH_HOST_NEEDS_TABLE_H

#include <stddef.h>
#include <stdint.h>

/* A section of an object. It links etch_needs_link[first] .. up to the next part's first. */
struct etch_needs_part {
    uint16_t bytes;
    uint16_t first;
};

/* What a program can name, in the order of strcmp. */
struct etch_needs_name {
    const char *name;
    uint16_t part;
    uint16_t stack; /* of a function: worst case in bytes, without what the caller gives it */
    uint16_t under; /* what is on the stack under the deepest call of what the caller gives it */
};

extern const struct etch_needs_part etch_needs_part[];
extern const uint16_t etch_needs_link[];
extern const struct etch_needs_name etch_needs_name[];
extern const size_t etch_needs_part_count, etch_needs_name_count;

#endif
