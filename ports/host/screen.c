/* ports/host/screen.c: simulated displays. The frame loop calls their ports, simulate.c opens
 * them. See screen.h. */
#include "screen.h"

#include <stdlib.h>
#include <string.h>

const char etch_screen_names[] = "memory strips strips1";

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

enum etch_screen_status etch_screen_open(struct etch_screen *screen, const char *name,
                                         int16_t width, int16_t height, uint8_t format)
{
    const bool direct = strcmp(name, "memory") == 0;

    *screen = (struct etch_screen){0};
    if (!direct && strcmp(name, "strips") != 0 && strcmp(name, "strips1") != 0) {
        return ETCH_SCREEN_UNKNOWN;
    }
    screen->buffers = direct ? 0 : name[6] == '1' ? 1 : 2;
    screen->shown.stride = (uint16_t)width;
    screen->shown.pixels = calloc((size_t)width * (size_t)height, sizeof *screen->shown.pixels);
    screen->display = (struct etch_display){
        .context = direct ? (void *)&screen->shown : (void *)screen,
        .width = width,
        .height = height,
        .format = format,
        .flush = direct ? etch_framebuffer_flush : start_transfer,
        .wait = direct ? etch_framebuffer_wait : finish_transfer,
        .memory = direct ? etch_framebuffer_memory : NULL,
    };
    return screen->shown.pixels != NULL ? ETCH_SCREEN_OK : ETCH_SCREEN_NO_MEMORY;
}

void etch_screen_close(struct etch_screen *screen)
{
    free(screen->shown.pixels);
    screen->shown.pixels = NULL;
}
