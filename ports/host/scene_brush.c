/* ports/host/scene_brush.c: the statements brush, opacity and stipple. scene.c finds them by name;
 * what they read, scene_brushed.c makes into paints. */
#include "scene_brush.h"

#include <string.h>

bool etch_scene_read_hex(struct etch_scene_reader *reader, const char *name, int digits,
                         uint64_t *value)
{
    static const char digit[] = "0123456789abcdef";
    struct etch_word word;

    *value = 0;
    if (!etch_text_word(&reader->text, name, &word)) {
        return false;
    }
    for (size_t i = 0; i < word.size; i++) {
        const char *at = word.text[i] != '\0' ? strchr(digit, word.text[i] | 0x20) : NULL;

        if (at == NULL || word.size != (size_t)digits) {
            return etch_text_fail(&reader->text, "%s: \"%s\" is not %d hexadecimal digits", name,
                                  etch_word_show(word).text, digits);
        }
        *value = *value << 4 | (uint64_t)(at - digit);
    }
    return true;
}

static bool read_rows(struct etch_scene_reader *reader, uint8_t row[8])
{
    uint64_t rows;

    if (!etch_scene_read_hex(reader, "rows", 16, &rows)) {
        return false;
    }
    for (int i = 0; i < 8; i++) {
        row[i] = (uint8_t)(rows >> (56 - 8 * i));
    }
    return true;
}

static bool read_coordinates(struct etch_scene_reader *reader, struct etch_scene_brush *brush,
                             const char *const *names)
{
    for (int i = 0; names[i] != NULL; i++) {
        int64_t value;

        if (!etch_text_integer(&reader->text, names[i], INT16_MIN, INT16_MAX, &value)) {
            return false;
        }
        brush->at[i] = (int16_t)value;
    }
    return true;
}

/* AT R G B .., to the end of the line; the gradient itself is made once to see whether it can be.
 */
static bool read_stops(struct etch_scene_reader *reader, struct etch_scene_brush *brush)
{
    struct etch_scene_brushed made;
    const int16_t *at = brush->at;

    brush->bits = 8;
    do {
        struct etch_stop *stop = &brush->stop[brush->count];
        int64_t place;
        uint8_t rgb[3];

        if (brush->count == 16) {
            return etch_text_fail(&reader->text, "more than 16 stops");
        }
        if (!etch_text_integer(&reader->text, "stop", 0, 65535, &place) ||
            !etch_scene_read_rgb(reader, rgb)) {
            return false;
        }
        *stop = (struct etch_stop){(uint16_t)place, rgb[0], rgb[1], rgb[2]};
        brush->count++;
    } while (etch_text_more(&reader->text));
    if (etch_ramp_init(&made.ramp, made.color, brush->bits, brush->stop, brush->count) != ETCH_OK) {
        return etch_text_fail(&reader->text, "stops must not go back");
    }
    return (brush->kind == ETCH_SCENE_LINEAR
                ? etch_gradient_linear_init(&made.of.linear, &made.ramp, at[0], at[1], at[2], at[3])
                : etch_gradient_radial_init(&made.of.radial, &made.ramp, at[0], at[1], at[2])) ==
               ETCH_OK ||
           etch_text_fail(&reader->text, "etch has no gradient of that length");
}

static bool read_tile(struct etch_scene_reader *reader, struct etch_scene_brush *brush)
{
    static const char *const names[] = {"x", "y", NULL};

    brush->tile = reader->texture;
    if (brush->tile == NULL || brush->tile->color == NULL) {
        return etch_text_fail(&reader->text, "a tile needs a texture that is not a palette's");
    }
    return read_coordinates(reader, brush, names);
}

/* A brush that what follows is painted with: a copy of the one before, so that shapes keep theirs.
 */
static struct etch_scene_brush *next_brush(struct etch_scene_reader *reader)
{
    struct etch_scene_brush *brush = etch_scene_data(reader, sizeof *brush);

    if (brush != NULL) {
        if (reader->brush != NULL) {
            *brush = *reader->brush;
        } else {
            brush->opacity = 255;
        }
        reader->brush = brush;
    }
    return brush;
}

static bool read_brush(struct etch_scene_reader *reader,
                       const struct etch_scene_statement *statement)
{
    static const char *const kinds[] = {"off", "linear", "radial", "pattern", "tile", NULL};
    static const char *const linear[] = {"x0", "y0", "x1", "y1", NULL};
    static const char *const radial[] = {"x", "y", "radius", NULL};
    struct etch_scene_brush *brush = next_brush(reader);
    int kind;

    (void)statement;
    if (brush == NULL || !etch_text_choice(&reader->text, "brush", kinds, &kind)) {
        return false;
    }
    brush->kind = (enum etch_scene_brush_kind)kind;
    brush->count = 0;
    switch (kind) {
    case ETCH_SCENE_NO_BRUSH: return true;
    case ETCH_SCENE_TILE: return read_tile(reader, brush);
    case ETCH_SCENE_PATTERN:
        return read_rows(reader, brush->row) && etch_scene_read_rgb(reader, brush->rgb[0]) &&
               etch_scene_read_rgb(reader, brush->rgb[1]);
    default:
        return read_coordinates(reader, brush, kind == ETCH_SCENE_LINEAR ? linear : radial) &&
               read_stops(reader, brush);
    }
}

static bool read_opacity(struct etch_scene_reader *reader,
                         const struct etch_scene_statement *statement)
{
    struct etch_scene_brush *brush = next_brush(reader);

    (void)statement;
    return brush != NULL && etch_scene_read_byte(reader, "opacity", &brush->opacity);
}

static bool read_stipple(struct etch_scene_reader *reader,
                         const struct etch_scene_statement *statement)
{
    struct etch_scene_brush *brush = next_brush(reader);

    (void)statement;
    if (brush == NULL) {
        return false;
    }
    brush->stippled = !etch_scene_take(reader, "off");
    return !brush->stippled || read_rows(reader, brush->stipple);
}

const struct etch_scene_statement etch_scene_brush_statements[] = {
    {"brush", read_brush, NULL, NULL, NULL},
    {"opacity", read_opacity, NULL, NULL, NULL},
    {"stipple", read_stipple, NULL, NULL, NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
