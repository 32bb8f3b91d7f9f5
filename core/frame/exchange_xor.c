/* frame/exchange_xor.c: one image on another, bit by bit. Called by applications. See
 * exchange.h. */
#include "exchange_rows.h"

/* NOLINTNEXTLINE(readability-non-const-parameter): the type of an exchange_pixel */
static void combine(uint16_t *to, uint16_t *from)
{
    *to = (uint16_t)(*to ^ *from);
}

void etch_surface_xor(const struct etch_surface *to, const struct etch_surface *from)
{
    exchange_walk(to, from, combine);
}
