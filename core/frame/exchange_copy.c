/* frame/exchange_copy.c: one image to another. Called by applications. See exchange.h. */
#include "exchange_rows.h"

/* NOLINTNEXTLINE(readability-non-const-parameter): the type of an exchange_pixel */
static void copy(uint16_t *to, uint16_t *from)
{
    *to = *from;
}

void etch_surface_copy(const struct etch_surface *to, const struct etch_surface *from)
{
    exchange_walk(to, from, copy);
}
