/* tests/familiar: run FRAME.png: a sketch as it is, on an ILI9341: its frame whole in memory,
 * the panel turned when it says so; what the simulated panel shows goes to FRAME.png. Then the
 * same in strips of 16 rows: setup and loop are called for each. Fails if the two differ or the
 * panel refuses a byte. */
#include <stdio.h>
#include <string.h>

#include "glue.h"
#include "hal/frame.h"
#include "ports/host/dump.h"
#include "ports/host/panel_port.h"

enum {
    PIXELS = 240 * 320
};

static struct etch_panel_port port;
static uint16_t memory[PIXELS], strips[2][PIXELS], seen[2][PIXELS];

/* The whole frame, as the panel stands now. */
static struct etch_surface whole_frame(void)
{
    const int16_t width = port.lcd.display.width, height = port.lcd.display.height;
    const struct etch_rect window = {0, 0, width, height};
    struct etch_surface s = {0};

    (void)etch_surface_init(&s, memory, window, (uint16_t)width); /* by constants */
    return s;
}

static void turn(struct gfx *g)
{
    int *const status = g->context;

    port.turn = g->rotation;
    *status |= etch_lcd_turn(&port.lcd, g->rotation);
    g->surface = whole_frame();
}

/* As a display with memory for a whole frame. */
static int draw_whole(void)
{
    const struct etch_display *const display = &port.lcd.display;
    struct etch_surface s = whole_frame();
    int status = 0;

    sketch_draw(&s, turn, &status);
    s = whole_frame();
    status |= display->flush(display, s.window, s.pixels, s.stride);
    return status | display->wait(display);
}

static int draw_strips(void)
{
    struct etch_frame frame;
    const struct etch_frame_memory buffers = {.pixels = {strips[0], strips[1]},
                                              .size = (uint32_t)port.lcd.display.width * 16};
    int status = etch_frame_init(&frame, &port.lcd.display, buffers);

    if (status != 0)
        return status;
    for (struct etch_surface *s = etch_frame_begin(&frame); s != NULL; s = etch_frame_next(&frame))
        sketch_draw(s, NULL, NULL);
    return etch_frame_end(&frame);
}

static bool save(const char *path)
{
    const struct etch_display *const d = &port.lcd.display;
    const struct etch_plane16 plane = {seen[0], d->width, d->height, d->width, false};
    FILE *const file = fopen(path, "wb");
    bool ok = file != NULL && etch_dump_png(file, &plane);

    if (file != NULL && fclose(file) != 0)
        ok = false;
    return ok;
}

int main(int argc, char **argv)
{
    int status = 0;

    if (argc != 2 || etch_panel_port_open(&port, "ili9341", 0) != 0)
        return 2;
    for (int way = 0; way < 2; way++) {
        status |= way == 0 ? draw_whole() : draw_strips();
        etch_panel_port_shown(&port, seen[way]);
    }
    if (status != 0 || port.panel.error[0] != '\0')
        fprintf(stderr, "status %d, the panel says: %s\n", status, port.panel.error);
    else if (memcmp(seen[0], seen[1], sizeof seen[0]) != 0)
        fprintf(stderr, "strips differ from the frame drawn whole\n"), status = 1;
    else if (!save(argv[1]))
        perror(argv[1]), status = 1;
    etch_panel_port_close(&port);
    return status != 0 || port.panel.error[0] != '\0';
}
