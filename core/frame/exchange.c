/* frame/exchange.c: two images change places. Called by applications. See exchange.h. */
#include "exchange_rows.h"

/* A pixel exchanged with itself would become 0. */
static void exchange(uint16_t *a, uint16_t *b)
{
    if (a != b) {
        *a = (uint16_t)(*a ^ *b);
        *b = (uint16_t)(*b ^ *a);
        *a = (uint16_t)(*a ^ *b);
    }
}

void etch_surface_exchange(const struct etch_surface *a, const struct etch_surface *b)
{
    exchange_walk(a, b, exchange);
}
