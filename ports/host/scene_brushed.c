/* ports/host/scene_brushed.c: paints for brush, opacity and stipple. Called by scene_fill.c and
 * scene_toolkit.c. */
#include "scene_brush.h"

#include <stdio.h>

static bool is_swapped(const struct etch_scene_run *run)
{
    return run->scene->format == ETCH_FORMAT_RGB565_SWAPPED;
}

static uint16_t pixel(const uint8_t rgb[3], bool swapped)
{
    const uint16_t color = etch_rgb565(rgb[0], rgb[1], rgb[2]);

    return swapped ? etch_rgb565_swap(color) : color;
}

/* The brush in the surface's byte order, or as etch_rgb565 where it is blended. */
static const struct etch_brush *make(const struct etch_scene_brush *b,
                                     struct etch_scene_brushed *to, bool swapped)
{
    const struct etch_image *image = b->tile != NULL ? &b->tile->image : NULL;

    switch (b->kind) {
    case ETCH_SCENE_LINEAR:
    case ETCH_SCENE_RADIAL:
        (void)(swapped ? etch_ramp_init_swapped : etch_ramp_init)(&to->ramp, to->color, b->bits,
                                                                  b->stop, b->count);
        if (b->kind == ETCH_SCENE_LINEAR) {
            (void)etch_gradient_linear_init(&to->of.linear, &to->ramp, b->at[0], b->at[1], b->at[2],
                                            b->at[3]);
            return &to->of.linear.brush;
        }
        (void)etch_gradient_radial_init(&to->of.radial, &to->ramp, b->at[0], b->at[1], b->at[2]);
        return &to->of.radial.brush;
    case ETCH_SCENE_PATTERN:
        etch_pattern_init(&to->of.pattern, b->row, pixel(b->rgb[0], swapped),
                          pixel(b->rgb[1], swapped));
        return &to->of.pattern.brush;
    default:
        (void)etch_tile_init(&to->of.tile, swapped ? b->tile->texel : b->tile->color, image->width,
                             image->height, image->stride, b->at[0], b->at[1]);
        return &to->of.tile.brush;
    }
}

/* One colour, or a brush, replaced or blended. */
static const struct etch_paint *plain(const struct etch_scene_run *run,
                                      const struct etch_scene_brush *b, const uint8_t rgb[3],
                                      struct etch_scene_brushed *to)
{
    const bool swapped = is_swapped(run), blended = b != NULL && b->opacity != 255;

    if (b != NULL && b->kind != ETCH_SCENE_NO_BRUSH) {
        to->brush.paint.kernel = !blended  ? etch_kernel_brush
                                 : swapped ? etch_kernel_brush_blend_swapped
                                           : etch_kernel_brush_blend;
        to->brush.brush = make(b, to, swapped && !blended);
        to->brush.opacity = b->opacity;
        return &to->brush.paint;
    }
    if (blended) {
        etch_flat_blend_init(&to->glass,
                             swapped ? etch_kernel_flat_blend_swapped : etch_kernel_flat_blend,
                             pixel(rgb, false), b->opacity);
        return &to->glass.paint;
    }
    to->flat.paint.kernel = etch_kernel_flat;
    to->flat.color = pixel(rgb, swapped);
    return &to->flat.paint;
}

const char *etch_scene_brush_needs(struct etch_scene_reader *reader, bool covers)
{
    static const char *const brushes[] = {"", "etch_gradient_linear_init etch_ramp_init ",
                                          "etch_gradient_radial_init etch_ramp_init ",
                                          "etch_pattern_init ", "etch_tile_init "};
    enum {
        ROOM = 160
    };
    const struct etch_scene_brush *b = reader->brush;
    const bool is_brush = b != NULL && b->kind != ETCH_SCENE_NO_BRUSH;
    const bool stippled = b != NULL && b->stippled, blended = b != NULL && b->opacity != 255;
    char *names = etch_scene_data(reader, ROOM);

    if (names != NULL) {
        (void)snprintf(names, ROOM, "%s%s%s", is_brush ? brushes[b->kind] : "",
                       !stippled ? ""
                       : covers  ? "etch_cover_stipple "
                                 : "etch_kernel_stipple ",
                       covers     ? is_brush ? "etch_cover_brush" : "etch_cover_flat"
                       : is_brush ? blended ? "etch_kernel_brush_blend" : "etch_kernel_brush"
                       : blended  ? "etch_flat_blend_init etch_kernel_flat_blend"
                                  : "etch_kernel_flat");
    }
    return names;
}

const struct etch_paint *etch_scene_brush_paint(struct etch_scene_run *run,
                                                const struct etch_scene_brush *brush,
                                                const uint8_t rgb[3], struct etch_scene_brushed *to)
{
    const struct etch_paint *paint = plain(run, brush, rgb, to);

    if (brush != NULL && brush->stippled) {
        to->stipple = (struct etch_stipple_paint){{etch_kernel_stipple}, brush->stipple, paint};
        paint = &to->stipple.paint;
    }
    run->kernel = paint->kernel;
    if (run->stats != NULL) {
        ((struct etch_paint *)(uintptr_t)paint)->kernel = etch_scene_count; /* all are in *to */
    }
    return paint;
}

const struct etch_cover_paint *etch_scene_brush_cover(const struct etch_scene_run *run,
                                                      const struct etch_scene_brush *brush,
                                                      const uint8_t rgb[3], uint8_t opacity,
                                                      struct etch_scene_brushed *to)
{
    const bool swapped = is_swapped(run);
    const struct etch_cover_paint *paint = &to->cover.paint;

    to->cover = (struct etch_cover_flat_paint){
        {swapped ? etch_cover_flat_swapped : etch_cover_flat}, pixel(rgb, false), opacity};
    if (brush != NULL && brush->kind != ETCH_SCENE_NO_BRUSH) {
        to->cover_brush = (struct etch_cover_brush_paint){
            {swapped ? etch_cover_brush_swapped : etch_cover_brush},
            make(brush, to, false),
            opacity};
        paint = &to->cover_brush.paint;
    }
    if (brush != NULL && brush->stippled) {
        to->cover_stipple = (struct etch_cover_stipple_paint){
            {etch_cover_stipple}, brush->stipple, paint};
        paint = &to->cover_stipple.paint;
    }
    return paint;
}

static void count_cover(const struct etch_surface *surface, int16_t x, int16_t y, uint16_t n,
                        const int16_t *cover, const struct etch_cover_paint *paint)
{
    const struct etch_scene_cover_counter *c = (const struct etch_scene_cover_counter *)paint;

    c->run->stats->pixels += n;
    c->through->kernel(surface, x, y, n, cover, c->through);
}

struct etch_scene_cover_counter etch_scene_count_covers(struct etch_scene_run *run,
                                                        const struct etch_cover_paint *through)
{
    const struct etch_scene_cover_counter c = {{count_cover}, run, through};

    return c;
}
