/* fragment/gouraud_span.h: spans of the Gouraud kernels with depth; no part of the API. */
#ifndef ETCH_FRAGMENT_GOURAUD_SPAN_H
#define ETCH_FRAGMENT_GOURAUD_SPAN_H

#include "depth_rows.h"

/* Interpolated colour, and with the bytes swapped; the paint is a struct etch_gouraud_paint. */
etch_span etch_gouraud_span, etch_gouraud_span_swapped;

#endif
