/* fragment/source_map.h: stages (stage.h) for images under a map; raster/map_runs.h has an example.
 */
#ifndef ETCH_FRAGMENT_SOURCE_MAP_H
#define ETCH_FRAGMENT_SOURCE_MAP_H

#include "../base/map.h"
#include "blend.h"

/* Sets u and v to the places of the pixels' centres, rounded down to 1/65536 texel, and a to full.
 * Data: const struct etch_map. Places are inside map->from, which is inside -32768 .. 32767. */
etch_stage_function etch_source_map;

/* a = a alpha / 255, rounded to nearest, ties upwards. Data: const struct etch_blend_constant. */
etch_stage_function etch_stage_opacity;

#endif
