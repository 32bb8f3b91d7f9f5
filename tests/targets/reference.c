/* tests/targets: reference SCENE WIDTH HEIGHT [PANEL]: writes the frame that a board must show,
 * drawn whole, as big-endian RGB565 to standard output: as it lies in memory, or as the simulated
 * panel of that name shows it where a panel has other colours. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ports/host/panel_port.h"
#include "scenes.h"

static const struct target_scene *const scenes[] = {&target_shapes, &target_torus, &target_mesh,
                                                    &target_spin, &target_floor};

static void put(unsigned pixel)
{
    putchar((int)(pixel >> 8));
    putchar((int)(pixel & 0xFF));
}

static bool make_surface(struct etch_surface *s, int16_t width, int16_t height)
{
    const size_t n = (size_t)width * (size_t)height;
    uint16_t *pixels = calloc(n, sizeof *pixels), *depth = calloc(n, sizeof *depth);
    const struct etch_rect window = {0, 0, width, height};

    if (pixels == NULL || depth == NULL ||
        etch_surface_init(s, pixels, window, (uint16_t)width) != ETCH_OK) {
        free(pixels);
        free(depth);
        return false;
    }
    s->depth = depth;
    return true;
}

/* Sends the frame in one piece and writes what is seen. */
static bool show_on(const char *name, const struct etch_surface *s)
{
    static struct etch_panel_port port;
    const struct etch_display *display = &port.lcd.display;

    if (etch_panel_port_open(&port, name, 0) != 0)
        return false;
    if (display->width != s->window.x1 || display->height != s->window.y1 ||
        display->flush(display, s->window, s->pixels, s->stride) != 0 ||
        display->wait(display) != 0 || port.panel.error[0] != '\0')
        return false;
    for (int y = 0; y < display->height; y++)
        for (int x = 0; x < display->width; x++) {
            const uint32_t c = etch_panel_view(&port.panel, 0, x, y);

            put((c >> 19 & 31) << 11 | (c >> 10 & 63) << 5 | (c >> 3 & 31));
        }
    etch_panel_port_close(&port);
    return true;
}

static int draw(const struct target_scene *scene, int16_t width, int16_t height, const char *panel)
{
    const bool swapped = panel != NULL && ETCH_FORMAT_HIGH_BYTE_FIRST == ETCH_FORMAT_RGB565_SWAPPED;
    struct etch_surface s;
    bool ok = make_surface(&s, width, height);

    if (!ok)
        return 1;
    scene->prepare(width, height);
    scene->draw(&s, swapped);
    if (panel != NULL)
        ok = show_on(panel, &s);
    else
        for (size_t i = 0; i < (size_t)width * (size_t)height; i++)
            put(s.pixels[i]);
    free(s.pixels);
    free(s.depth);
    return ok && ferror(stdout) == 0 ? 0 : 1;
}

int main(int argc, char **argv)
{
    const bool counted = argc == 4 || argc == 5;
    const int width = counted ? atoi(argv[2]) : 0, height = counted ? atoi(argv[3]) : 0;

    if (width >= 1 && width <= 4096 && height >= 1 && height <= 4096)
        for (size_t i = 0; i < sizeof scenes / sizeof scenes[0]; i++)
            if (strcmp(scenes[i]->name, argv[1]) == 0)
                return draw(scenes[i], (int16_t)width, (int16_t)height, argc == 5 ? argv[4] : NULL);
    fputs("usage: reference SCENE WIDTH HEIGHT [PANEL]\n", stderr);
    return 2;
}
