/* raster/map_runs.h: the pixels that a map shows an image on, as runs for any paint.
 *
 * With stages (fragment/stage.h) this draws images filtered, blended, tested, in any format a
 * sampler has:
 *
 *      const struct etch_stage stages[] = {
 *          {etch_source_map, &map}, {etch_stage_texture_replace, &sampler},
 *          {etch_stage_opacity, &opacity},
 *          {etch_stage_read, NULL}, {etch_stage_blend_alpha, NULL}, {etch_stage_write, NULL},
 *          {NULL, NULL}};
 *      const struct etch_staged_paint paint = {{etch_kernel_staged}, stages};
 *
 *      etch_map_runs(surface, &map, &paint.paint);
 *
 * An opaque image at full opacity needs only source, texture and write. For bilinear images clamped
 * at their edges the sampler names etch_filter_linear and etch_texels_clamp, or for opaque RGB565
 * etch_filter_linear_clamp. Nearest ones draw faster by etch_image_draw_mapped (draw/image.h).
 */
#ifndef ETCH_RASTER_MAP_RUNS_H
#define ETCH_RASTER_MAP_RUNS_H

#include "../base/map.h"
#include "../base/paint.h"

/* Runs of the pixels inside the clip that the map draws. Where map->from reaches beyond the image,
 * the sampler's wraps say what is there; it stays inside -32768 .. 32767. Cost: 60 to 600
 * instructions a row of map->bounds. */
void etch_map_runs(const struct etch_surface *s, const struct etch_map *map,
                   const struct etch_paint *paint);

#endif
