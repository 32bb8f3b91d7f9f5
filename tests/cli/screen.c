/* tests/cli: a panel as a screen (ports/host/screen.h): what is illegal on its bus is an error, and
 * so is a strip that fails. */
#include <stdlib.h>
#include <string.h>

#include "ports/host/simulate.h"
#include "tests/harness/harness.h"

void suite_screen(void);

static const struct etch_screen_panel settings = {
    .turn = -1, .buffers = 2, .clock = 40000000, .lanes = 1};
static const struct etch_display frame = {
    .width = 240, .height = 320, .format = ETCH_FORMAT_HIGH_BYTE_FIRST};
static struct etch_screen screen;
static struct etch_error error;

static void what_is_illegal_is_an_error(void)
{
    error.text[0] = 0;
    if (!CHECK(etch_screen_open(&screen, "ili9341", &frame, &settings, "a.scene", &error)))
        return;
    CHECK(etch_screen_look(&screen, "a.scene", &error) && error.text[0] == 0);
    etch_panel_select(&screen.panel->panel, true);
    etch_panel_command(&screen.panel->panel, 0x36);
    etch_panel_select(&screen.panel->panel, false);
    CHECK(!etch_screen_look(&screen, "a.scene", &error));
    CHECK(strcmp(error.text, "a.scene:0: ili9341 refuses: command 36 has 1 parameters and got 0") ==
          0);
    etch_screen_close(&screen);
}

/* The names are those of the panels, and each opens in its own size; a name that is none is refused
 * by the list of them. */
static void every_name_opens(void)
{
    char *names = etch_screen_names();
    int panels = 0;

    if (!CHECK(names != NULL))
        return;
    for (const struct etch_panel_type *t = etch_panel_types; t->name != NULL; t++, panels++) {
        const struct etch_display d = {
            .width = t->height, .height = t->width, .format = ETCH_FORMAT_HIGH_BYTE_FIRST};

        CHECK(strstr(names, t->name) != NULL);
        CHECK_EQ(etch_screen_format(t->name), ETCH_FORMAT_HIGH_BYTE_FIRST);
        error.text[0] = 0;
        CHECK(etch_screen_open(&screen, t->name, &d, &settings, "a", &error));
        CHECK_EQ(screen.panel->turn, t->width == t->height ? 0 : 1);
        etch_screen_close(&screen);
    }
    CHECK(panels >= 15);
    CHECK_EQ(etch_screen_format("strips"), -1);
    CHECK(!etch_screen_open(&screen, "tv", &frame, &settings, "a", &error));
    CHECK(strstr(error.text, names) != NULL);
    etch_screen_close(&screen);
    free(names);
}

void suite_screen(void)
{
    RUN(what_is_illegal_is_an_error);
    RUN(every_name_opens);
}
