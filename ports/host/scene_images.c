/* ports/host/scene_images.c: the statements that draw images: blit, stretch, nine, spin, cursor,
 * xorrect, copyrect, scroll. scene.c finds them by name, scene_draw.c calls what they append. */
#include <string.h>

#include "scene_image.h"
#include "scene_steps.h"

/* Draws over black and over white on the scratch plane: a pixel that stays is not drawn. */
static void count(struct etch_scene_run *run, const struct etch_scene_showing *w, int order)
{
    struct etch_surface scratch = run->surface;
    const struct etch_rect clip = scratch.clip;

    scratch.pixels = run->scratch;
    for (int16_t y = clip.y0; y < clip.y1; y++) {
        const struct etch_rect row = {clip.x0, y, clip.x1, (int16_t)(y + 1)};
        uint16_t *const p = scratch.pixels + etch_surface_index(&scratch, clip.x0, y);
        const size_t n = (size_t)(clip.x1 - clip.x0);
        static uint16_t black[INT16_MAX];

        scratch.clip = row;
        w->show(&scratch, w, order);
        memcpy(black, p, n * sizeof *p);
        memset(p, 0xFF, n * sizeof *p);
        w->show(&scratch, w, order);
        for (size_t x = 0; x < n; x++) {
            run->stats->pixels += black[x] != 0 || p[x] != UINT16_MAX;
            p[x] = 0;
        }
    }
}

static void draw_image(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct etch_scene_showing *const w = step->of.data;
    const int order = run->scene->format == ETCH_FORMAT_RGB565_SWAPPED;

    w->show(&run->surface, w, order);
    if (run->stats != NULL && run->surface.clip.x0 < run->surface.clip.x1) {
        count(run, w, order);
    }
}

/* ---- reading ------------------------------------------------------------------------------ */

enum option {
    OPACITY = 1,
    TURN = 2,
    PART = 4,
    LINEAR = 8
};

static const struct kind {
    const char *name;
    etch_scene_show *show;
    bool image, place, color;
    unsigned options;
    const char *numbers[9];
} kinds[] = {
    {"blit", etch_scene_show_blit, true, false, false, OPACITY | TURN | PART, {"x", "y", NULL}},
    {"stretch",
     etch_scene_show_stretch,
     true,
     false,
     false,
     OPACITY | PART | LINEAR,
     {"x", "y", "w", "h", NULL}},
    {"nine",
     etch_scene_show_nine,
     true,
     false,
     false,
     OPACITY,
     {"x", "y", "w", "h", "left", "top", "right", "bottom", NULL}},
    {"spin", etch_scene_show_spin, true, true, false, OPACITY | PART | LINEAR, {NULL}},
    {"cursor", etch_scene_show_cursor, true, false, true, 0, {"x", "y", NULL}},
    {"xorrect", etch_scene_show_xor, false, false, true, 0, {"x", "y", "w", "h", NULL}},
    {"copyrect", etch_scene_show_copy, false, false, false, 0, {"x", "y", "w", "h", "x2", NULL}},
    {"scroll", etch_scene_show_scroll, false, false, true, 0, {"x", "y", "w", "h", "dx", NULL}},
};

/* U V X Y ANGLE SCALE_U SCALE_V */
static bool read_place(struct etch_scene_reader *reader, struct etch_map_place *place)
{
    int64_t angle;

    if (!etch_text_q16(&reader->text, "u", &place->u) ||
        !etch_text_q16(&reader->text, "v", &place->v) ||
        !etch_text_q16(&reader->text, "x", &place->x) ||
        !etch_text_q16(&reader->text, "y", &place->y) ||
        !etch_text_integer(&reader->text, "angle", 0, UINT16_MAX, &angle) ||
        !etch_text_q16(&reader->text, "scale", &place->scale_u) ||
        !etch_text_q16(&reader->text, "scale", &place->scale_v)) {
        return false;
    }
    place->angle = (uint16_t)angle;
    return true;
}

static bool read_part(struct etch_scene_reader *reader, struct etch_rect *part)
{
    static const char *const names[] = {"x", "y", "w", "h"};
    int16_t v[4];
    int64_t value;

    for (int i = 0; i < 4; i++) {
        if (!etch_text_integer(&reader->text, names[i], INT16_MIN, INT16_MAX, &value)) {
            return false;
        }
        v[i] = (int16_t)value;
    }
    *part = etch_rect_from_size(v[0], v[1], v[2], v[3]);
    return true;
}

static bool read_options(struct etch_scene_reader *reader, struct etch_scene_showing *w,
                         unsigned options)
{
    int64_t turn;

    while (etch_text_more(&reader->text)) {
        if ((options & OPACITY) != 0 && etch_scene_take(reader, "opacity")) {
            if (!etch_scene_read_byte(reader, "opacity", &w->opacity)) {
                return false;
            }
        } else if ((options & TURN) != 0 && etch_scene_take(reader, "turn")) {
            if (!etch_text_integer(&reader->text, "turn", 0, 7, &turn)) {
                return false;
            }
            w->turn = (uint8_t)turn;
        } else if ((options & PART) != 0 && etch_scene_take(reader, "part")) {
            if (!read_part(reader, &w->part)) {
                return false;
            }
        } else if ((options & LINEAR) != 0 && etch_scene_take(reader, "linear")) {
            w->linear = true;
        } else {
            return true; /* a word too many is the line's error */
        }
    }
    return true;
}

/* What the image is of has to go with how it is drawn. */
static bool check(struct etch_scene_reader *reader, const struct etch_scene_showing *w)
{
    const struct etch_scene_format *const f = w->image->format;
    const struct etch_rect all = etch_image_whole(&w->image->image[0]);
    const bool partly = memcmp(&all, &w->part, sizeof all) != 0;

    if (w->show == etch_scene_show_cursor && strncmp(f->name, "index1", 6) != 0) {
        return etch_text_fail(&reader->text, "a cursor is an image of index1 or index1_key");
    }
    if (w->image->compressed && (w->show != etch_scene_show_blit || w->turn != 0 || partly)) {
        return etch_text_fail(&reader->text, "a compressed image is drawn by a plain blit only");
    }
    if (w->turn != 0 && partly) {
        return etch_text_fail(&reader->text, "only one of turn and part");
    }
    if (w->linear && f->colors == NULL) {
        return etch_text_fail(&reader->text, "%s is not sampled linearly", f->name);
    }
    if (!w->linear && w->opacity != UINT8_MAX && f->fade[0].row == NULL) {
        return etch_text_fail(&reader->text, "%s is drawn in full opacity only", f->name);
    }
    return true;
}

static bool read_showing(struct etch_scene_reader *reader, struct etch_scene_showing *w,
                         const struct kind *k)
{
    int64_t value;

    for (int i = 0; k->numbers[i] != NULL; i++) {
        if (!etch_text_integer(&reader->text, k->numbers[i], i < 4 || !k->image ? INT16_MIN : 0,
                               INT16_MAX, &value)) {
            return false;
        }
        w->at[i] = (int16_t)value;
    }
    return (!k->place || read_place(reader, &w->place)) &&
           (!k->color || etch_scene_read_rgb(reader, w->rgb)) &&
           read_options(reader, w, k->options);
}

static const char *row_name(const struct etch_scene_showing *w)
{
    const struct etch_scene_format *const f = w->image->format;

    return w->show == etch_scene_show_cursor
               ? NULL
               : (w->opacity == UINT8_MAX ? f->full : f->fade)[0].name;
}

static bool read_statement(struct etch_scene_reader *reader,
                           const struct etch_scene_statement *statement)
{
    const struct kind *k = kinds;
    struct etch_scene_step *const step = etch_scene_append(reader, statement);
    struct etch_scene_showing *const w = step != NULL ? etch_scene_data(reader, sizeof *w) : NULL;

    if (w == NULL) {
        return false;
    }
    while (strcmp(k->name, statement->name) != 0) {
        k++;
    }
    step->of.data = w;
    w->show = k->show;
    w->image = reader->image;
    w->opacity = UINT8_MAX;
    if (!k->image) {
        return read_showing(reader, w, k);
    }
    if (w->image == NULL) {
        return etch_text_fail(&reader->text, "there is no image to draw");
    }
    w->part = etch_image_whole(&w->image->image[0]);
    if (!read_showing(reader, w, k) || !check(reader, w)) {
        return false;
    }
    step->needs = w->linear              ? "etch_map_runs etch_source_map etch_filter_linear"
                  : w->image->compressed ? "etch_rle_draw"
                                         : row_name(w);
    return true;
}

#define ROWS(name, needs)                                                                          \
    {                                                                                              \
        name, read_statement, draw_image, needs, NULL                                              \
    }
const struct etch_scene_statement etch_scene_images_statements[] = {
    ROWS("blit", "etch_image_draw"),
    ROWS("stretch", "etch_map_scale"),
    ROWS("nine", "etch_image_draw_nine"),
    ROWS("spin", "etch_map_rotate"),
    ROWS("cursor", "etch_image_draw etch_row_index1_xor"),
    ROWS("xorrect", "etch_rect_xor"),
    ROWS("copyrect", "etch_surface_copy_rect"),
    ROWS("scroll", "etch_surface_scroll"),
    {NULL, NULL, NULL, NULL, NULL},
};
