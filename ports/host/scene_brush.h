/* ports/host/scene_brush.h: what fill, draw, smooth and solid paint with; no part of the API. */
#ifndef ETCH_HOST_SCENE_BRUSH_H
#define ETCH_HOST_SCENE_BRUSH_H

#include "../../core/fragment/blend_fused.h"
#include "../../core/fragment/cover.h"
#include "../../core/fragment/flat.h"
#include "../../core/fragment/gradient.h"
#include "../../core/fragment/pattern.h"
#include "../../core/raster/triangle.h"
#include "scene_steps.h"

/* The statements brush, opacity and stipple as they stand. */
struct etch_scene_brush {
    enum etch_scene_brush_kind {
        ETCH_SCENE_NO_BRUSH,
        ETCH_SCENE_LINEAR,
        ETCH_SCENE_RADIAL,
        ETCH_SCENE_PATTERN,
        ETCH_SCENE_TILE
    } kind;
    bool stippled;
    uint8_t opacity;
    uint8_t count, bits;
    int16_t at[4];
    struct etch_stop stop[16];
    uint8_t row[8], stipple[8];
    uint8_t rgb[2][3];
    const struct etch_scene_texture *tile;
};

/* What is behind a paint while a shape is drawn. */
struct etch_scene_brushed {
    uint16_t color[256];
    struct etch_ramp ramp;
    union {
        struct etch_gradient_linear linear;
        struct etch_gradient_radial radial;
        struct etch_pattern pattern;
        struct etch_tile tile;
    } of;
    struct etch_flat_paint flat;
    struct etch_flat_blend_paint glass;
    struct etch_brush_paint brush;
    struct etch_stipple_paint stipple;
    struct etch_cover_flat_paint cover;
    struct etch_cover_brush_paint cover_brush;
    struct etch_cover_stipple_paint cover_stipple;
};

/* The paint of a shape in the colour rgb, by the brush unless it is NULL. Sets run->kernel; the
 * paint counts if there are stats. */
const struct etch_paint *etch_scene_brush_paint(struct etch_scene_run *run,
                                                const struct etch_scene_brush *brush,
                                                const uint8_t rgb[3],
                                                struct etch_scene_brushed *to);

/* The same for covers, which it does not count, with an opacity in place of the brush's. */
const struct etch_cover_paint *etch_scene_brush_cover(const struct etch_scene_run *run,
                                                      const struct etch_scene_brush *brush,
                                                      const uint8_t rgb[3], uint8_t opacity,
                                                      struct etch_scene_brushed *to);

/* Counts covers on their way to a paint. */
struct etch_scene_cover_counter {
    struct etch_cover_paint paint;
    struct etch_scene_run *run;
    const struct etch_cover_paint *through;
};
struct etch_scene_cover_counter etch_scene_count_covers(struct etch_scene_run *run,
                                                        const struct etch_cover_paint *through);

/* The names of what such paints are made of, for --needs; NULL, with an error set, without memory.
 */
const char *etch_scene_brush_needs(struct etch_scene_reader *reader, bool covers);

/* X Y X Y .. until the colour, in 2^-frac px, at most `most`; their number, 0 with an error set if
 * there are fewer than `least`. */
uint16_t etch_scene_read_points(struct etch_scene_reader *reader, struct etch_point_q8 *v,
                                uint16_t most, uint16_t least);

/* A word of `digits` hexadecimal digits, at most 16. */
bool etch_scene_read_hex(struct etch_scene_reader *reader, const char *name, int digits,
                         uint64_t *value);

#endif
