/* ports/host/needs.c: sums what functions link. Called by report_needs.c. See needs.h. */
#include "needs.h"

#include <stdlib.h>
#include <string.h>

#include "needs_table.h"

bool etch_needs_open(struct etch_needs *needs)
{
    *needs = (struct etch_needs){.linked = calloc(etch_needs_part_count, 1)};
    return needs->linked != NULL;
}

void etch_needs_close(struct etch_needs *needs)
{
    free(needs->linked);
}

static const struct etch_needs_name *find(const char *name, size_t size)
{
    size_t low = 0, high = etch_needs_name_count;

    while (low < high) {
        const size_t middle = (low + high) / 2;
        const struct etch_needs_name *n = &etch_needs_name[middle];
        const int order = strncmp(n->name, name, size);

        if (order == 0 && n->name[size] == '\0') {
            return n;
        }
        if (order < 0) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return NULL;
}

/* A part and all that it links; the depth is that of calls. */
static void link_part(struct etch_needs *needs, uint16_t part)
{
    if (needs->linked[part] != 0) {
        return;
    }
    needs->linked[part] = 1;
    needs->flash += etch_needs_part[part].bytes;
    for (uint16_t i = etch_needs_part[part].first; i < etch_needs_part[part + 1].first; i++) {
        link_part(needs, etch_needs_link[i]);
    }
}

bool etch_needs_add(struct etch_needs *needs, const char *name, size_t size)
{
    const struct etch_needs_name *n = find(name, size);

    if (n == NULL) {
        return false;
    }
    link_part(needs, n->part);
    needs->stack = n->stack > needs->stack ? n->stack : needs->stack;
    return true;
}
