/* ports/host/options.c: etch-sim's command line. See options.h. */
#include "options.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char usage[] =
    "usage: etch-sim SCENE [-o OUT.png|.ppm] [--raw OUT.565] [--depth OUT.z16] [--stencil OUT.s8]\n"
    "                [--port NAME] [--strip N] [--stats] [--needs]\n"
    "       panels:  [--turn 0..3] [--mirror x|y|xy] [--buffers 1|2] [--clock HZ] [--lanes 1..8]\n";

int etch_options_wrong(const char *what, const char *word)
{
    (void)fprintf(stderr, "etch-sim: %s%s\n%s", what, word, usage);
    return 2;
}

void etch_options_print(void)
{
    char *names = etch_screen_names();

    (void)printf("%s       ports:   %s\n", usage, names != NULL ? names : "");
    free(names);
}

/* Where the value of an option goes, NULL if `word` is not an option with a value. */
static const char **value_of(struct etch_options *o, const char *word)
{
    const struct {
        const char *name, **value;
    } values[] = {
        {"-o", &o->picture},        {"--raw", &o->raw},       {"--depth", &o->depth},
        {"--stencil", &o->stencil}, {"--port", &o->port},     {"--strip", &o->strip},
        {"--turn", &o->turn},       {"--mirror", &o->mirror}, {"--buffers", &o->buffers},
        {"--clock", &o->clock},     {"--lanes", &o->lanes},
    };

    for (size_t i = 0; i < sizeof values / sizeof values[0]; i++) {
        if (strcmp(word, values[i].name) == 0) {
            return values[i].value;
        }
    }
    return NULL;
}

static bool *flag_of(struct etch_options *o, const char *word)
{
    return strcmp(word, "--stats") == 0   ? &o->stats
           : strcmp(word, "--needs") == 0 ? &o->needs
           : strcmp(word, "--help") == 0  ? &o->help
                                          : NULL;
}

/* 0, or the exit status. */
static int read_words(struct etch_options *o, int count, char **words)
{
    for (int i = 1; i < count; i++) {
        const char **value = value_of(o, words[i]);
        bool *flag = flag_of(o, words[i]);

        if (value != NULL && i + 1 == count) {
            return etch_options_wrong("a value is missing after ", words[i]);
        }
        if (value != NULL && *value != NULL) {
            return etch_options_wrong("given twice: ", words[i]);
        }
        if (value != NULL) {
            *value = words[++i];
        } else if (flag != NULL) {
            *flag = true;
        } else if (words[i][0] == '-') {
            return etch_options_wrong("unknown option ", words[i]);
        } else if (o->scene != NULL) {
            return etch_options_wrong("more than one scene: ", words[i]);
        } else {
            o->scene = words[i];
        }
    }
    return o->scene != NULL || o->help ? 0 : etch_options_wrong("no scene", "");
}

/* An integer least .. greatest, or `otherwise` if it was not given; -1 if it is wrong. */
static int32_t number(const char *given, int32_t least, int32_t greatest, int32_t otherwise)
{
    const struct etch_word word = {given, given != NULL ? strlen(given) : 0};
    int64_t value = otherwise;

    if (given != NULL && (!etch_integer_read(word, &value) || value < least || value > greatest)) {
        return -1;
    }
    return (int32_t)value;
}

/* What the letters say; 0xFF if they are wrong. */
static uint8_t mirror_of(const char *letters)
{
    return letters == NULL              ? 0
           : strcmp(letters, "x") == 0  ? ETCH_LCD_MIRROR_X
           : strcmp(letters, "y") == 0  ? ETCH_LCD_MIRROR_Y
           : strcmp(letters, "xy") == 0 ? ETCH_LCD_MIRROR_X | ETCH_LCD_MIRROR_Y
                                        : 0xFF;
}

/* 0, or the exit status. */
static int read_panel(struct etch_options *o)
{
    const bool settings = o->turn != NULL || o->mirror != NULL || o->buffers != NULL ||
                          o->clock != NULL || o->lanes != NULL;
    const int32_t turn = number(o->turn, 0, 3, 0), buffers = number(o->buffers, 1, 2, 2);
    const int32_t clock = number(o->clock, 1, 1000000000, 40000000);
    const int32_t lanes = number(o->lanes, 1, 8, 1);

    if (settings && (o->port == NULL || etch_screen_format(o->port) < 0)) {
        return etch_options_wrong("only panels take --turn, --mirror, --buffers, --clock, --lanes",
                                  "");
    }
    if (turn < 0) {
        return etch_options_wrong("--turn takes quarters, 0 .. 3, not ", o->turn);
    }
    if (mirror_of(o->mirror) == 0xFF) {
        return etch_options_wrong("--mirror takes x, y or xy, not ", o->mirror);
    }
    if (buffers < 0) {
        return etch_options_wrong("--buffers takes 1 or 2, not ", o->buffers);
    }
    if (clock < 0) {
        return etch_options_wrong("--clock takes Hz, 1 .. 1000000000, not ", o->clock);
    }
    if (lanes < 0) {
        return etch_options_wrong("--lanes takes bits in a clock, 1 .. 8, not ", o->lanes);
    }
    o->panel = (struct etch_screen_panel){.turn = o->turn != NULL ? (int8_t)turn : -1,
                                          .mirror = mirror_of(o->mirror),
                                          .buffers = (uint8_t)buffers,
                                          .clock = (uint32_t)clock,
                                          .lanes = (uint8_t)lanes};
    return 0;
}

int etch_options_read(struct etch_options *options, int count, char **words)
{
    const int status = read_words(options, count, words);

    if (status != 0 || options->help) {
        return status;
    }
    options->rows = number(options->strip, 1, 32767, 0);
    if (options->rows < 0) {
        return etch_options_wrong("--strip takes rows, 1 .. 32767, not ", options->strip);
    }
    return read_panel(options);
}
