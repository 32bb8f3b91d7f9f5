/* ports/host/screen.c: simulated displays. The frame loop calls their ports, simulate.c opens
 * them. See screen.h. */
#include "screen.h"

#include <stdlib.h>
#include <string.h>

static const char *const plain[] = {"memory", "strips", "strips1"};

enum {
    PLAIN = sizeof plain / sizeof plain[0]
};

static int start_transfer(const struct etch_display *display, struct etch_rect area,
                          const uint16_t *pixels, uint16_t stride)
{
    struct etch_screen *screen = display->context;

    if (screen->pixels != NULL) {
        return ETCH_EIO; /* one transfer at a time */
    }
    screen->pixels = pixels;
    screen->area = area;
    screen->stride = stride;
    return ETCH_OK;
}

static int finish_transfer(const struct etch_display *display)
{
    struct etch_screen *screen = display->context;
    const struct etch_rect area = screen->area;
    const size_t size = (size_t)(area.x1 - area.x0) * sizeof *screen->pixels;

    for (int16_t y = area.y0; screen->pixels != NULL && y < area.y1; y++) {
        uint16_t *to = screen->shown.pixels + (size_t)y * screen->shown.stride + area.x0;

        memcpy(to, screen->pixels + (size_t)(y - area.y0) * screen->stride, size);
        screen->bytes += size;
    }
    screen->flushes += screen->pixels != NULL;
    screen->pixels = NULL;
    return ETCH_OK;
}

static void open_plain(struct etch_screen *screen, int index, const struct etch_display *frame)
{
    const bool direct = index == 0;

    screen->buffers = direct ? 0 : index == 1 ? 2 : 1;
    screen->swapped = frame->format == ETCH_FORMAT_RGB565_SWAPPED;
    screen->display = (struct etch_display){
        .context = direct ? (void *)&screen->shown : (void *)screen,
        .width = frame->width,
        .height = frame->height,
        .format = frame->format,
        .flush = direct ? etch_framebuffer_flush : start_transfer,
        .wait = direct ? etch_framebuffer_wait : finish_transfer,
        .memory = direct ? etch_framebuffer_memory : NULL,
    };
}

static bool fail_unknown(const char *name, const char *path, struct etch_error *error)
{
    char *names = etch_screen_names();

    (void)etch_error_set(error, path, 0, "no port \"%s\"; there are: %s", name,
                         names != NULL ? names : "");
    free(names);
    return false;
}

bool etch_screen_open(struct etch_screen *screen, const char *name,
                      const struct etch_display *frame, const struct etch_screen_panel *panel,
                      const char *path, struct etch_error *error)
{
    const struct etch_panel_type *type = etch_panel_find(name);
    const size_t pixels = (size_t)frame->width * (size_t)frame->height;
    int index = 0;

    *screen = (struct etch_screen){0};
    while (index < PLAIN && strcmp(name, plain[index]) != 0) {
        index++;
    }
    if (index == PLAIN && type == NULL) {
        return fail_unknown(name, path, error);
    }
    screen->shown.stride = (uint16_t)frame->width;
    screen->shown.pixels = calloc(pixels, sizeof *screen->shown.pixels);
    if (screen->shown.pixels == NULL) {
        return etch_error_set(error, path, 0, "no memory for a frame of %d x %d", frame->width,
                              frame->height);
    }
    if (index == PLAIN) {
        return etch_screen_open_panel(screen, type, frame, panel, path, error);
    }
    open_plain(screen, index, frame);
    return true;
}

void etch_screen_close(struct etch_screen *screen)
{
    free(screen->shown.pixels);
    screen->shown.pixels = NULL;
    etch_screen_close_panel(screen);
}

/* Appends a name to the text, or only counts it. Returns the text's new size. */
static size_t append(char *text, size_t size, const char *name)
{
    if (text != NULL) {
        (void)strcpy(text + size, size != 0 ? " " : "");
        (void)strcat(text + size, name);
    }
    return size + strlen(name) + (size != 0);
}

char *etch_screen_names(void)
{
    char *text = NULL;

    for (int pass = 0; pass < 2; pass++) {
        size_t size = 0;

        for (int i = 0; i < PLAIN; i++) {
            size = append(text, size, plain[i]);
        }
        for (const struct etch_panel_type *t = etch_panel_types; t->name != NULL; t++) {
            size = append(text, size, t->name);
        }
        text = pass == 0 ? malloc(size + 1) : text;
        if (text == NULL) {
            break;
        }
    }
    return text;
}
