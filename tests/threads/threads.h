/* tests/threads: what its files share: a scene on a panel whose transfers are made by a thread, and
 * the same scene drawn by one thread into memory, to compare. */
#ifndef TESTS_THREADS_H
#define TESTS_THREADS_H

#include "hal/frame.h"
#include "ports/host/scene.h"
#include "ports/spi_lcd/panels.h"
#include "wire.h"

enum {
    WIDTH = 320,
    HEIGHT = 240,
    ROWS = 16,
    STRIP = WIDTH * ROWS,
    WHOLE = WIDTH * HEIGHT
};

/* A panel of 320 x 240 with all that a task needs to draw on it. */
struct station {
    struct line line;
    struct etch_panel panel;
    struct etch_lcd lcd;
    struct etch_scene scene;
    uint16_t pixels[2][STRIP], depth[STRIP];
    uint8_t stencil[STRIP];
    int status; /* of its last frame */
};

/* Opens a panel on the wire. One that cannot be had ends the program. */
void station_open(struct station *s, struct wire *wire);
void station_close(struct station *s);

/* Draws a scene's frame on it: by the calling thread, whose transfers run beside it. */
void station_draw(struct station *s, const char *path);

/* Reads a scene, in a format (enum etch_format); one that cannot be read ends the program. Each
 * thread reads its own: what a scene keeps while it is drawn is then nobody else's. */
void scene_open(struct etch_scene *scene, const char *path, uint8_t format);

/* Draws a scene on a strip; no memory for it ends the program. */
void scene_draw(const struct etch_scene *scene, struct etch_surface *strip);

/* Fails the test unless the glass shows the scene as one thread draws it. */
void station_check(const struct station *s, const char *path);

/* Scenes of the command line, at least two. */
extern const char *const *scene_paths;
extern int scene_count;

void suite_tasks(void);
void suite_workers(void);

#endif
