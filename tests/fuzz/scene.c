/* tests/fuzz: one scene file a run: read, drawn whole and in two strips, which must agree. The
 * simulator's reader is linked as it is but for etch_file_read: here files are parts of the input.
 *
 *      the scene's lines
 *      ==                  after this line what is read as any file the scene names
 *      the file
 *
 * fuzz.mk links it with libFuzzer, and with replay.c. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"
#include "ports/host/file.h"
#include "ports/host/scene.h"

/* What one run may cost: pixels of the frame, steps of the scene. */
#define MOST_PIXELS 1024
#define MOST_STEPS 16

/* Read where the input has no file of its own. */
static const char mesh_file[] = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 1\nvt 0 0\nvt 1 0\nvt 1 1\n"
                                "f 1/1 2/2 3/3 4\nf 1 3 2\n";
static const char picture_file[] =
    "P6 4 2 255\n"
    "\1\2\3\377\0\0\0\377\0\0\0\377\40\100\200\377\377\377\7\7\7\1\1\1";

static struct {
    const uint8_t *scene, *file;
    size_t scene_size, file_size;
} input;

/* In place of ports/host/file.c's. */
char *etch_file_read(const char *path, size_t *size)
{
    const size_t length = strlen(path);
    const bool mesh = length > 4 && strcmp(path + length - 4, ".obj") == 0;
    const bool is_scene = strcmp(path, "scene") == 0;
    const void *from = is_scene               ? (const void *)input.scene
                       : input.file_size != 0 ? (const void *)input.file
                       : mesh                 ? mesh_file
                                              : picture_file;
    char *data;

    *size = is_scene               ? input.scene_size
            : input.file_size != 0 ? input.file_size
            : mesh                 ? sizeof mesh_file - 1
                                   : sizeof picture_file - 1;
    data = malloc(*size + 1);
    if (data != NULL && *size != 0) {
        memcpy(data, from, *size);
    }
    return data;
}

static void split(const uint8_t *data, size_t size)
{
    input.scene = data, input.scene_size = size;
    input.file = data, input.file_size = 0;
    for (size_t i = 0; i + 4 <= size; i++) {
        if (memcmp(data + i, "\n==\n", 4) == 0) {
            input.scene_size = i + 1;
            input.file = data + i + 4, input.file_size = size - i - 4;
            return;
        }
    }
}

/* Draws the scene in strips of so many rows; the frame's pixels and depths to `shown`. */
static void draw(const struct etch_scene *scene, int16_t rows, uint16_t *shown,
                 struct etch_scene_stats *stats)
{
    const size_t width = (uint16_t)scene->width, room = width * (uint16_t)rows;
    struct fuzz_planes planes = fuzz_planes_open(room);

    for (int16_t y = 0; y < scene->height; y = (int16_t)(y + rows)) {
        const int16_t end = (int16_t)(y + rows < scene->height ? y + rows : scene->height);
        struct etch_surface s;

        if (etch_surface_init(&s, planes.pixels, (struct etch_rect){0, y, scene->width, end},
                              (uint16_t)width) != ETCH_OK) {
            fuzz_fail("no surface");
        }
        s.depth = scene->uses_depth ? planes.depth : NULL;
        s.stencil = scene->uses_stencil ? planes.stencil : NULL;
        if (!etch_scene_draw(scene, &s, stats)) {
            fuzz_fail("no memory to draw");
        }
        for (int16_t row = y; row < end; row++) {
            memcpy(shown + (size_t)row * width, planes.pixels + (size_t)(row - y) * width,
                   width * sizeof *shown);
        }
    }
    fuzz_planes_close(&planes);
}

static void draw_both(const struct etch_scene *scene)
{
    static uint16_t whole[MOST_PIXELS], strips[MOST_PIXELS];
    struct etch_scene_stats stats = {.triangles = 0};
    const size_t bytes = (size_t)scene->width * (size_t)scene->height * sizeof whole[0];

    draw(scene, scene->height, whole, NULL);
    draw(scene, (int16_t)(scene->height / 2 + 1), strips, &stats);
    if (memcmp(whole, strips, bytes) != 0) {
        fuzz_fail("strips differ from the whole frame");
    }
}

int fuzz_one(const uint8_t *data, size_t size)
{
    static struct etch_error error;
    struct etch_scene scene;

    split(data, size);
    if (!etch_scene_open(&scene, "scene", &error)) {
        if (error.text[0] == '\0') {
            fuzz_fail("refused without a reason");
        }
        return 0;
    }
    if ((int32_t)scene.width * scene.height <= MOST_PIXELS && scene.count <= MOST_STEPS) {
        draw_both(&scene);
    }
    etch_scene_close(&scene);
    return 0;
}

const char *fuzz_missing(void)
{
    return NULL;
}
