/* tests/needs: prints what `etch-sim --needs` takes functions to weigh together. Called by run. */
#include <stdio.h>
#include <string.h>

#include "ports/host/needs.h"

int main(int count, char **names)
{
    struct etch_needs needs;

    if (!etch_needs_open(&needs)) {
        return 1;
    }
    for (int i = 1; i < count; i++) {
        if (!etch_needs_add(&needs, names[i], strlen(names[i]))) {
            (void)fprintf(stderr, "%s: not in the table\n", names[i]);
            return 1;
        }
    }
    (void)printf("%u\n", (unsigned)needs.flash);
    etch_needs_close(&needs);
    return 0;
}
