/* tests/threads: a scene on a panel, and what it must show. See threads.h. */
#include "threads.h"

#include <stdio.h>
#include <stdlib.h>

#include "tests/harness/harness.h"

static void stop(const char *reason)
{
    fprintf(stderr, "%s\n", reason);
    exit(2);
}

void station_open(struct station *s, struct wire *wire)
{
    if (!etch_panel_open(&s->panel, etch_panel_find("ili9341")))
        stop("no memory for a panel");
    line_open(&s->line, wire, &s->panel);
    if (etch_lcd_open(&s->lcd, &etch_ili9341, &s->line.bus, (struct etch_lcd_setup){.turn = 1}) < 0)
        stop("the panel does not open");
}

void station_close(struct station *s)
{
    etch_panel_close(&s->panel);
}

void scene_open(struct etch_scene *scene, const char *path, uint8_t format)
{
    struct etch_error error;

    if (!etch_scene_open_in(scene, path, format, &error))
        stop(path);
    if (scene->width != WIDTH || scene->height != HEIGHT)
        stop("not a scene of 320 x 240");
}

void scene_draw(const struct etch_scene *scene, struct etch_surface *strip)
{
    if (!etch_scene_draw(scene, strip, NULL))
        stop("no memory to draw");
}

void station_draw(struct station *s, const char *path)
{
    const struct etch_frame_memory memory = {.pixels = {s->pixels[0], s->pixels[1]},
                                             .depth = s->depth,
                                             .stencil = s->stencil,
                                             .size = STRIP};
    struct etch_frame frame;

    scene_open(&s->scene, path, s->lcd.display.format);
    s->status = etch_frame_init(&frame, &s->lcd.display, memory);
    if (s->status == 0) {
        for (struct etch_surface *strip = etch_frame_begin(&frame); strip != NULL;
             strip = etch_frame_next(&frame))
            scene_draw(&s->scene, strip);
        s->status = etch_frame_end(&frame);
    }
    etch_scene_close(&s->scene);
}

/* The scene in one piece, by this thread alone. */
static void draw_alone(const char *path, uint16_t *pixels)
{
    static uint16_t depth[WHOLE];
    static uint8_t stencil[WHOLE];
    const struct etch_rect window = {0, 0, WIDTH, HEIGHT};
    struct etch_scene scene;
    struct etch_surface surface;

    scene_open(&scene, path, ETCH_FORMAT_RGB565);
    if (etch_surface_init(&surface, pixels, window, WIDTH) != ETCH_OK)
        stop("no surface");
    surface.depth = depth;
    surface.stencil = stencil;
    scene_draw(&scene, &surface);
    etch_scene_close(&scene);
}

void station_check(const struct station *s, const char *path)
{
    static uint16_t expected[WHOLE];
    int different = 0;

    draw_alone(path, expected);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            const uint32_t c = etch_panel_view(&s->panel, 1, x, y);

            different += (c >> 19 << 11 | (c >> 10 & 63) << 5 | (c >> 3 & 31)) !=
                         expected[y * WIDTH + x];
        }
    CHECK_EQ(s->status, 0);
    CHECK(s->panel.error[0] == '\0');
    if (!CHECK_EQ(different, 0))
        test_print(path);
}
