/* ports/host/scene_frame.c: the statements about the frame. scene.c finds them by name. */
#include "../../core/draw/shapes.h"
#include "scene_steps.h"

static bool read_scene(struct etch_scene_reader *reader,
                       const struct etch_scene_statement *statement)
{
    int64_t width, height;

    (void)statement;
    if (reader->scene->width != 0) {
        return etch_text_fail(&reader->text, "a second \"scene\"");
    }
    if (!etch_text_integer(&reader->text, "width", 1, 32767, &width) ||
        !etch_text_integer(&reader->text, "height", 1, 32767, &height)) {
        return false;
    }
    reader->scene->width = (int16_t)width;
    reader->scene->height = (int16_t)height;
    return true;
}

static bool read_strip(struct etch_scene_reader *reader,
                       const struct etch_scene_statement *statement)
{
    int64_t rows;

    (void)statement;
    if (!etch_text_integer(&reader->text, "rows", 1, 32767, &rows)) {
        return false;
    }
    reader->scene->strip = (int16_t)rows;
    return true;
}

static bool read_format(struct etch_scene_reader *reader,
                        const struct etch_scene_statement *statement)
{
    static const char *const names[] = {"rgb565", "rgb565_swapped", NULL};
    int index;

    (void)statement;
    if (!etch_text_choice(&reader->text, "format", names, &index)) {
        return false;
    }
    reader->scene->format = index == 0 ? ETCH_FORMAT_RGB565 : ETCH_FORMAT_RGB565_SWAPPED;
    return true;
}

static bool read_frac(struct etch_scene_reader *reader,
                      const struct etch_scene_statement *statement)
{
    int64_t bits;

    (void)statement;
    if (!etch_text_integer(&reader->text, "frac", 0, 16, &bits)) {
        return false;
    }
    reader->frac = (int)bits;
    return true;
}

static void draw_clear(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    etch_surface_clear(&run->surface, etch_scene_color(run, step->of.rgb));
}

static bool read_clear(struct etch_scene_reader *reader,
                       const struct etch_scene_statement *statement)
{
    struct etch_scene_step *step = etch_scene_append(reader, statement);
    uint8_t alpha; /* there is no alpha plane */

    return step != NULL && etch_scene_read_rgb(reader, step->of.rgb) &&
           (!etch_text_more(&reader->text) || etch_scene_read_byte(reader, "a", &alpha));
}

static void draw_clear_depth(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    if (run->surface.depth != NULL) {
        etch_depth_clear(&run->surface, step->of.depth);
    }
}

static bool read_clear_depth(struct etch_scene_reader *reader,
                             const struct etch_scene_statement *statement)
{
    struct etch_scene_step *step = etch_scene_append(reader, statement);
    int64_t depth;

    if (step == NULL || !etch_text_integer(&reader->text, "depth", 0, 65535, &depth)) {
        return false;
    }
    step->of.depth = (uint16_t)depth;
    return true;
}

static void draw_clear_stencil(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    if (run->surface.stencil != NULL) {
        etch_stencil_clear(&run->surface, step->of.stencil);
    }
}

static bool read_clear_stencil(struct etch_scene_reader *reader,
                               const struct etch_scene_statement *statement)
{
    struct etch_scene_step *step = etch_scene_append(reader, statement);

    return step != NULL && etch_scene_read_byte(reader, "stencil", &step->of.stencil);
}

const struct etch_scene_statement etch_scene_frame_statements[] = {
    {"scene", read_scene, NULL, NULL, NULL},
    {"strip", read_strip, NULL, NULL, NULL},
    {"format", read_format, NULL, NULL, NULL},
    {"frac", read_frac, NULL, NULL, NULL},
    {"clear", read_clear, draw_clear, "etch_surface_clear", NULL},
    {"cleardepth", read_clear_depth, draw_clear_depth, "etch_depth_clear", NULL},
    {"clearstencil", read_clear_stencil, draw_clear_stencil, "etch_stencil_clear", NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
