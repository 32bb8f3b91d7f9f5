/* tests/product: the symbols of the menu, about 20 pixels high round pixel corner (x, y), from
 * smooth shapes. */
#ifndef TESTS_PRODUCT_SYMBOLS_H
#define TESTS_PRODUCT_SYMBOLS_H

#include "parts.h"

typedef void symbol_painter(const struct etch_surface *s, int16_t x, int16_t y, struct ink ink);

symbol_painter symbol_lamp, symbol_thermometer, symbol_blinds, symbol_note, symbol_gear;

#endif
