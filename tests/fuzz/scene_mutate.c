/* tests/fuzz: changes a scene as its author would: whole lines and words, out of the simulator's
 * own tables of statements, and numbers at the ends of their ranges. libFuzzer calls it in place of
 * changing bytes, which it does one time in eight. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"
#include "ports/host/scene_steps.h"

size_t LLVMFuzzerMutate(uint8_t *data, size_t size, size_t most);
size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t most, unsigned int seed);
size_t LLVMFuzzerCustomCrossOver(const uint8_t *data1, size_t size1, const uint8_t *data2,
                                 size_t size2, uint8_t *out, size_t most, unsigned int seed);

static uint64_t state; /* of a linear congruence modulo 2^31 */

/* 0 .. n - 1 */
static size_t below(size_t n)
{
    state = (state * 1103515245 + 12345) & 0x7FFFFFFF;
    return n == 0 ? 0 : (size_t)(state >> 8) % n;
}

/* A part of the text. */
struct piece {
    size_t at, size;
};

/* Puts `text` in the place of a piece; unchanged where there is no room. */
static size_t replace(uint8_t *data, size_t size, size_t most, struct piece p, const char *text,
                      size_t length)
{
    if (size - p.size + length > most) {
        return size;
    }
    memmove(data + p.at + length, data + p.at + p.size, size - p.at - p.size);
    memcpy(data + p.at, text, length);
    return size - p.size + length;
}

/* The line round byte `at`, its LF included. */
static struct piece line_at(const uint8_t *data, size_t size, size_t at)
{
    size_t from = at, to = at;

    while (from > 0 && data[from - 1] != '\n') {
        from--;
    }
    while (to < size && data[to] != '\n') {
        to++;
    }
    return (struct piece){from, (to < size ? to + 1 : to) - from};
}

static bool blank(uint8_t c)
{
    return c == ' ' || c == '\n' || c == '\t';
}

static struct piece word_at(const uint8_t *data, size_t size, size_t at)
{
    size_t from = at, to = at;

    while (from > 0 && !blank(data[from - 1])) {
        from--;
    }
    while (to < size && !blank(data[to])) {
        to++;
    }
    return (struct piece){from, to - from};
}

/* ---- words ---------------------------------------------------------------------------------- */

static const struct etch_scene_statement *any_statement(void)
{
    static const struct etch_scene_statement *const tables[] = {
        etch_scene_frame_statements,    etch_scene_shape_statements,
        etch_scene_state_statements,    etch_scene_triangle_statements,
        etch_scene_view_statements,     etch_scene_mesh_statements,
        etch_scene_line_statements,     etch_scene_pass_statements,
        etch_scene_line_2d_statements,  etch_scene_polygon_statements,
        etch_scene_path_statements,     etch_scene_line_clip_statements,
        etch_scene_implicit_statements, etch_scene_sorted_statements,
        etch_scene_light_statements,    etch_scene_elements_statements,
        etch_scene_text_statements,     etch_scene_answer_statements,
        etch_scene_image_statements,    etch_scene_images_statements,
        etch_scene_toolkit_statements,  etch_scene_fill_statements,
        etch_scene_brush_statements,    etch_scene_shader_statements,
        etch_scene_soft_statements,
    };
    const struct etch_scene_statement *table = tables[below(sizeof tables / sizeof tables[0])];
    size_t n = 0;

    while (table[n].name != NULL) {
        n++;
    }
    return &table[below(n)];
}

/* Writes one to `text`, and its length. */
static int number(char *text, size_t room)
{
    static const int32_t hostile[] = {0,    1,     -1,     2,      7,     15,    16,    31,
                                      255,  256,   -32768, -32767, 32767, 65535, 65536, 4095,
                                      8192, -8192, 32,     24,     12,    100,   1000,  32766};
    static const char *const fraction[] = {"", ".5", ".99999", ".00390625"};

    if (below(2) == 0) {
        return snprintf(text, room, "%d", (int)below(40) - 4);
    }
    return snprintf(text, room, "%d%s", (int)hostile[below(sizeof hostile / sizeof hostile[0])],
                    fraction[below(8) < 6 ? 0 : below(4)]);
}

static size_t change_word(uint8_t *data, size_t size, size_t most)
{
    const struct piece p = word_at(data, size, below(size));
    const bool digit = p.size > 0 &&
                       (data[p.at] == '-' || (data[p.at] >= '0' && data[p.at] <= '9'));
    char text[32];
    int length = 0;

    if (digit) {
        length = number(text, sizeof text);
    } else if (below(4) != 0) { /* another word of the scene */
        const struct piece other = word_at(data, size, below(size));
        const size_t n = other.size < sizeof text ? other.size : sizeof text - 1;

        memcpy(text, data + other.at, n);
        length = (int)n;
    } else {
        length = snprintf(text, sizeof text, "%s", any_statement()->name);
    }
    return replace(data, size, most, p, text, (size_t)length);
}

/* A statement with as many numbers as it asks for, a colour behind them. */
static size_t add_statement(uint8_t *data, size_t size, size_t most)
{
    const struct etch_scene_statement *s = any_statement();
    const struct piece p = line_at(data, size, below(size));
    char text[160], word[32];
    int used = snprintf(text, sizeof text, "%s", s->name);

    for (size_t i = 0; s->arguments != NULL && s->arguments[i] != NULL && used < 100; i++) {
        (void)number(word, sizeof word);
        used += snprintf(text + used, sizeof text - (size_t)used, " %s", word);
    }
    for (int i = 0; i < 3; i++) {
        used += snprintf(text + used, sizeof text - (size_t)used, " %d", (int)below(256));
    }
    text[used++] = '\n';
    return replace(data, size, most, (struct piece){p.at + p.size, 0}, text, (size_t)used);
}

/* ---- lines ---------------------------------------------------------------------------------- */

static size_t copy_line(uint8_t *data, size_t size, size_t most, const uint8_t *from,
                        size_t from_size)
{
    const struct piece line = line_at(from, from_size, below(from_size));
    const struct piece to = line_at(data, size, below(size));
    char text[512];

    if (line.size == 0 || line.size > sizeof text) {
        return size;
    }
    memcpy(text, from + line.at, line.size);
    return replace(data, size, most, (struct piece){to.at + to.size, 0}, text, line.size);
}

/* Frames stay small enough to be drawn. */
static size_t keep_small(uint8_t *data, size_t size, size_t most)
{
    const struct piece first = line_at(data, size, 0);

    if (below(32) == 0 || first.size > 16) {
        return below(8) == 0 ? size : replace(data, size, most, first, "scene 40 24\n", 12);
    }
    return first.size >= 7 && memcmp(data, "scene ", 6) == 0
               ? size
               : replace(data, size, most, (struct piece){0, 0}, "scene 40 24\n", 12);
}

size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t most, unsigned int seed)
{
    state = seed;
    if (size == 0) {
        return replace(data, size, most, (struct piece){0, 0}, "scene 40 24\n", 12);
    }
    for (size_t n = 1 + below(4); n > 0; n--) {
        switch (below(8)) {
        case 0: size = LLVMFuzzerMutate(data, size, most); break;
        case 1: size = add_statement(data, size, most); break;
        case 2: size = copy_line(data, size, most, data, size); break;
        case 3: size = replace(data, size, most, line_at(data, size, below(size)), "", 0); break;
        default: size = change_word(data, size, most);
        }
        size = size == 0 ? replace(data, size, most, (struct piece){0, 0}, "scene 40 24\n", 12)
                         : size;
    }
    return keep_small(data, size, most);
}

/* Lines of the second scene into the first. */
size_t LLVMFuzzerCustomCrossOver(const uint8_t *data1, size_t size1, const uint8_t *data2,
                                 size_t size2, uint8_t *out, size_t most, unsigned int seed)
{
    size_t size = size1 < most ? size1 : most;

    state = seed;
    memcpy(out, data1, size);
    for (size_t n = 1 + below(6); n > 0 && size > 0 && size2 > 0; n--) {
        size = copy_line(out, size, most, data2, size2);
    }
    return size;
}
