/* ports/host/scene_fragment_state.c: the states of fragments, with arguments: tests, blending, fog,
 * raster operations, masks. scene_state.c asks for them by name. */
#include "scene_steps.h"

static const char *const functions[] = {"never",    "less",   "equal",  "lequal", "greater",
                                        "notequal", "gequal", "always", NULL};
static const char *const operations[] = {"keep",   "zero",     "replace",  "incr", "decr",
                                         "invert", "incrwrap", "decrwrap", NULL};
static const char *const blends[] = {"off", "alpha", "add", "mul", "addalpha", "constant", NULL};
static const char *const fogs[] = {"off", "linear", "exp", NULL};
static const char *const logics[] = {
    "off", "clear", "and",    "andreverse", "copy",         "andinverted", "noop", "xor", "or",
    "nor", "equiv", "invert", "orreverse",  "copyinverted", "orinverted",  "nand", "set", NULL};

static bool choose(struct etch_scene_reader *reader, const char *name, const char *const *words,
                   uint8_t *value)
{
    int index;

    if (!etch_text_choice(&reader->text, name, words, &index)) {
        return false;
    }
    *value = (uint8_t)index;
    return true;
}

/* off | REF */
static bool read_atest(struct etch_scene_reader *reader)
{
    reader->state.atest = !etch_scene_take(reader, "off");
    return reader->state.atest == 0 ||
           etch_scene_read_byte(reader, "atest", &reader->state.atest_reference);
}

/* off | FUNC REF MASK SFAIL ZFAIL ZPASS */
static bool read_stencil(struct etch_scene_reader *reader)
{
    static const char *const names[] = {"sfail", "zfail", "zpass"};
    struct etch_scene_state *state = &reader->state;
    uint8_t function;

    state->stencil = 0;
    if (etch_scene_take(reader, "off")) {
        return true;
    }
    if (!choose(reader, "stencil", functions, &function) ||
        !etch_scene_read_byte(reader, "reference", &state->stencil_reference) ||
        !etch_scene_read_byte(reader, "mask", &state->stencil_mask)) {
        return false;
    }
    state->stencil = (uint8_t)(function + 1);
    for (int i = 0; i < 3; i++) {
        if (!choose(reader, names[i], operations, &state->stencil_operation[i])) {
            return false;
        }
    }
    return true;
}

/* MASK */
static bool read_stencil_mask(struct etch_scene_reader *reader)
{
    return etch_scene_read_byte(reader, "mask", &reader->state.stencil_write);
}

/* off | alpha | add | mul | addalpha | constant A */
static bool read_blend(struct etch_scene_reader *reader)
{
    return choose(reader, "blend", blends, &reader->state.blend) &&
           (reader->state.blend != 5 ||
            etch_scene_read_byte(reader, "alpha", &reader->state.blend_alpha));
}

static bool read_depth(struct etch_scene_reader *reader, const char *name, int64_t least,
                       uint16_t *value)
{
    int64_t number;

    if (!etch_text_integer(&reader->text, name, least, 65535, &number)) {
        return false;
    }
    *value = (uint16_t)number;
    return true;
}

/* off | linear START END R G B | exp DENSITY R G B */
static bool read_fog(struct etch_scene_reader *reader)
{
    struct etch_scene_state *state = &reader->state;

    if (!choose(reader, "fog", fogs, &state->fog)) {
        return false;
    }
    if (state->fog == 1 && (!read_depth(reader, "start", 0, &state->fog_start) ||
                            !read_depth(reader, "end", state->fog_start + 1, &state->fog_end))) {
        return false;
    }
    if (state->fog == 2 && !etch_text_q16(&reader->text, "density", &state->fog_density)) {
        return false;
    }
    if (state->fog == 2 && state->fog_density < 0) {
        return etch_text_fail(&reader->text, "density must not be negative");
    }
    return state->fog == 0 || etch_scene_read_rgb(reader, state->fog_color);
}

/* off | an operation */
static bool read_logic(struct etch_scene_reader *reader)
{
    return choose(reader, "logic", logics, &reader->state.logic);
}

/* R G B, each 0 or 1 */
static bool read_color_mask(struct etch_scene_reader *reader)
{
    static const char *const names[] = {"r", "g", "b"};
    static const uint16_t bits[] = {0xF800, 0x07E0, 0x001F};
    uint16_t mask = 0;

    for (int i = 0; i < 3; i++) {
        int64_t on;

        if (!etch_text_integer(&reader->text, names[i], 0, 1, &on)) {
            return false;
        }
        mask = (uint16_t)(mask | (on != 0 ? bits[i] : 0));
    }
    reader->state.color_mask = mask;
    return true;
}

bool etch_scene_read_fragment_state(struct etch_scene_reader *reader, struct etch_word name,
                                    bool *known)
{
    static const struct {
        const char *name;
        bool (*read)(struct etch_scene_reader *reader);
    } states[] = {
        {"atest", read_atest},
        {"stencil", read_stencil},
        {"stencilmask", read_stencil_mask},
        {"blend", read_blend},
        {"fog", read_fog},
        {"logic", read_logic},
        {"colormask", read_color_mask},
    };

    for (size_t i = 0; i < sizeof states / sizeof states[0]; i++) {
        if (etch_word_is(name, states[i].name)) {
            *known = true;
            return states[i].read(reader);
        }
    }
    *known = false;
    return false;
}
