/* ports/host/needs.h: what functions of etch weigh together: the sum over all that they call and
 * read, each part once, as a linker that drops what nobody names leaves it (--gc-sections). The
 * figures are of Cortex-M0+ at -Os, from a table that is written by `make needs-table` and held
 * against the linker by `make needs`. */
#ifndef ETCH_HOST_NEEDS_H
#define ETCH_HOST_NEEDS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The functions that were named, and all that they link. */
struct etch_needs {
    uint8_t *linked; /* a byte a part */
    uint32_t
        flash; /* bytes of code and constants; a part that begins at a multiple of 4 may add 2 */
    uint32_t stack; /* worst case of what was named, each by itself */
};

/* False without memory. */
bool etch_needs_open(struct etch_needs *needs);
void etch_needs_close(struct etch_needs *needs);

/* Adds the function or table of that name. False, and nothing is added, if etch has none. */
bool etch_needs_add(struct etch_needs *needs, const char *name, size_t size);

#endif
