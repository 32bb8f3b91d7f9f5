/* ports/host/scene_state.c: the state statements. scene.c finds them by name. Values are only
 * recorded here; what draws them is asked when something is drawn (scene_staged.c). */
#include <stddef.h>

#include "scene_steps.h"

/* A state that is one of a few words: its value is the word's place in the list. */
struct choice {
    const char *name;
    size_t offset; /* into struct etch_scene_state */
    const char *const *words;
};

static const char *const zero_one[] = {"0", "1", NULL};
static const char *const shades[] = {"smooth", "flat", "phong", NULL};
static const char *const tests[] = {"off",     "never",    "less",   "equal",  "lequal",
                                    "greater", "notequal", "gequal", "always", NULL};
static const char *const culls[] = {"off", "back", "front", NULL};
static const char *const windings[] = {"ccw", "cw", NULL};
static const char *const texs[] = {"off", "replace", "modulate", "decal", NULL};
static const char *const filters[] = {"nearest", "linear", NULL};
static const char *const wraps[] = {"repeat", "clamp", "mirror", NULL};
static const char *const wraps_v[] = {"same", "repeat", "clamp", "mirror", NULL};
static const char *const off_on[] = {"off", "on", NULL};
static const char *const dithers[] = {"off", "on", NULL};
static const char *const depths[] = {"linear", "inverse", NULL};
static const char *const modes[] = {"precise", "fast", "exact", "fast8", NULL};

static const struct choice choices[] = {
    {"shade", offsetof(struct etch_scene_state, shade), shades},
    {"persp", offsetof(struct etch_scene_state, persp), zero_one},
    {"ztest", offsetof(struct etch_scene_state, ztest), tests},
    {"zwrite", offsetof(struct etch_scene_state, zwrite), zero_one},
    {"cull", offsetof(struct etch_scene_state, cull), culls},
    {"front", offsetof(struct etch_scene_state, front), windings},
    {"tex", offsetof(struct etch_scene_state, tex), texs},
    {"filter", offsetof(struct etch_scene_state, filter), filters},
    {"wrap", offsetof(struct etch_scene_state, wrap), wraps},
    {"wrapv", offsetof(struct etch_scene_state, wrap_v), wraps_v},
    {"mipmap", offsetof(struct etch_scene_state, mipmap), off_on},
    {"mode", offsetof(struct etch_scene_state, mode), modes},
    {"dither", offsetof(struct etch_scene_state, dither), dithers},
    {"depth", offsetof(struct etch_scene_state, depth), depths},
};

static bool read_choice(struct etch_scene_reader *reader, const struct choice *choice)
{
    int index;

    if (!etch_text_choice(&reader->text, choice->name, choice->words, &index)) {
        return false;
    }
    ((uint8_t *)&reader->state)[choice->offset] = (uint8_t)index;
    return true;
}

static void draw_scissor(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    run->surface.clip = run->clip;
    etch_surface_clip(&run->surface, etch_rect_intersect(run->clip, step->of.clip));
}

/* off | X Y W H, a step, because everything drawn after it is clipped */
static const struct etch_scene_statement scissor = {"scissor", NULL, draw_scissor,
                                                    "etch_surface_clip", NULL};

static bool read_scissor(struct etch_scene_reader *reader)
{
    static const char *const names[] = {"x", "y", "width", "height"};
    struct etch_scene_step *step = etch_scene_append(reader, &scissor);
    int64_t v[4];

    if (step == NULL) {
        return false;
    }
    step->of.clip = (struct etch_rect){INT16_MIN, INT16_MIN, INT16_MAX, INT16_MAX};
    if (etch_scene_take(reader, "off")) {
        return true;
    }
    for (int i = 0; i < 4; i++) {
        if (!etch_text_integer(&reader->text, names[i], INT16_MIN, INT16_MAX, &v[i])) {
            return false;
        }
    }
    step->of.clip = etch_rect_from_size((int16_t)v[0], (int16_t)v[1], (int16_t)v[2], (int16_t)v[3]);
    return true;
}

static bool read_state(struct etch_scene_reader *reader,
                       const struct etch_scene_statement *statement)
{
    struct etch_word word;
    bool known, ok;

    (void)statement;
    if (!etch_text_word(&reader->text, "state", &word)) {
        return false;
    }
    if (etch_word_is(word, "scissor")) {
        return read_scissor(reader);
    }
    ok = etch_scene_read_fragment_state(reader, word, &known);
    if (known) {
        return ok;
    }
    for (size_t i = 0; i < sizeof choices / sizeof choices[0]; i++) {
        if (etch_word_is(word, choices[i].name)) {
            return read_choice(reader, &choices[i]);
        }
    }
    return etch_text_fail(&reader->text, "unknown state \"%s\"", etch_word_show(word).text);
}

enum etch_cull etch_scene_cull(const struct etch_scene_state *state)
{
    if (state->cull == 0) {
        return ETCH_CULL_NONE;
    }
    /* back faces are those not of the front winding; both exchange what is dropped */
    return (state->cull == 1) == (state->front == 0) ? ETCH_CULL_CLOCKWISE
                                                     : ETCH_CULL_COUNTER_CLOCKWISE;
}

const struct etch_scene_statement etch_scene_state_statements[] = {
    {"state", read_state, NULL, NULL, NULL},
    {"texture", etch_scene_read_texture, NULL, NULL, NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
