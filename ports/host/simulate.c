/* ports/host/simulate.c: draws a scene as an application would: opens a display, gives the frame
 * loop its buffers, draws on every strip. etch-sim calls it. */
#include "simulate.h"

#include <stdlib.h>
#include <string.h>

#include "../../hal/frame.h"

/* The buffers of the application. */
struct buffers {
    uint16_t *pixels[2], *depth;
    uint8_t *stencil;
};

static void free_buffers(struct buffers *b)
{
    free(b->pixels[0]);
    free(b->pixels[1]);
    free(b->depth);
    free(b->stencil);
}

static uint16_t *get_plane(size_t elements, bool *ok)
{
    uint16_t *plane = *ok ? malloc(elements * sizeof *plane) : NULL;

    *ok = plane != NULL;
    return plane;
}

/* A stencil plane if the scene or the user wants one. */
static bool get_stencil(struct etch_simulation *s, struct buffers *b, size_t elements, size_t frame)
{
    bool ok = true;

    if (s->scene->uses_stencil || s->keeps_stencil) {
        b->stencil = malloc(elements);
        ok = b->stencil != NULL;
        s->stencil_bytes = elements;
    }
    if (s->keeps_stencil) {
        s->stencil = get_plane(frame, &ok);
    }
    return ok;
}

/* Buffers of `elements` each: colour as the screen wants, depth if the scene does. The depth
 * plane of the whole frame, if it is wanted, serves as its own buffer on a direct display. */
static bool get_buffers(struct etch_simulation *s, struct buffers *b, size_t elements)
{
    const size_t frame = (size_t)s->scene->width * (size_t)s->scene->height;
    const bool depth = s->scene->uses_depth || s->keeps_depth;
    bool ok = true;

    for (int i = 0; i < s->screen.buffers; i++) {
        b->pixels[i] = get_plane(elements, &ok);
    }
    if (depth) {
        b->depth = get_plane(elements, &ok);
    }
    if (s->keeps_depth) {
        s->depth = get_plane(frame, &ok);
    }
    s->color_bytes = (s->screen.buffers == 0 ? frame : s->screen.buffers * elements) *
                     (uint64_t)sizeof(uint16_t);
    s->depth_bytes = depth ? (uint64_t)elements * sizeof(uint16_t) : 0;
    return ok && get_stencil(s, b, elements, frame);
}

/* Copies the strip's depth to its place in the frame. */
static void keep_depth(struct etch_simulation *s, const struct etch_surface *strip)
{
    for (int16_t y = strip->window.y0; s->depth != NULL && y < strip->window.y1; y++) {
        memcpy(s->depth + (size_t)y * (size_t)s->scene->width,
               strip->depth + etch_surface_index(strip, 0, y),
               (size_t)s->scene->width * sizeof *s->depth);
    }
}

static void keep_stencil(struct etch_simulation *s, const struct etch_surface *strip)
{
    for (int16_t y = strip->window.y0; s->stencil != NULL && y < strip->window.y1; y++) {
        const uint8_t *row = strip->stencil + etch_surface_index(strip, 0, y);

        for (int16_t x = 0; x < s->scene->width; x++) {
            s->stencil[(size_t)y * (size_t)s->scene->width + (size_t)x] = row[x];
        }
    }
}

static bool draw_frame(struct etch_simulation *s, const struct buffers *b, size_t elements,
                       const char *path, struct etch_error *error)
{
    const struct etch_frame_memory memory = {.pixels = {b->pixels[0], b->pixels[1]},
                                             .depth = b->depth,
                                             .size = (uint32_t)elements,
                                             .stencil = b->stencil};
    struct etch_frame frame;
    bool ok = true;
    int status = etch_frame_init(&frame, &s->screen.display, memory);

    if (status == ETCH_OK) {
        for (struct etch_surface *strip = etch_frame_begin(&frame); strip != NULL && ok;
             strip = etch_frame_next(&frame)) {
            ok = etch_scene_draw(s->scene, strip, s->counts ? &s->stats : NULL);
            keep_depth(s, strip);
            keep_stencil(s, strip);
        }
        status = etch_frame_end(&frame);
    }
    if (status != ETCH_OK) {
        return etch_error_set(error, path, 0, "the display failed with %d", status);
    }
    return ok || etch_error_set(error, path, 0, "out of memory");
}

/* Rows of a strip: as asked for, and up to what panels with several rows in a byte take. */
static int16_t rows_of(const struct etch_simulation *s)
{
    const int align = s->screen.display.align_y > 1 ? s->screen.display.align_y : 1;
    const int rows = (s->rows + align - 1) / align * align;

    return s->screen.buffers == 0 || rows > s->scene->height ? s->scene->height : (int16_t)rows;
}

bool etch_simulate(struct etch_simulation *s, const char *path, struct etch_error *error)
{
    const struct etch_scene *scene = s->scene;
    struct buffers buffers = {{NULL, NULL}, NULL, NULL};
    const struct etch_display frame = {
        .width = scene->width, .height = scene->height, .format = scene->format};
    size_t elements;
    bool ok = false;

    if (!etch_screen_open(&s->screen, s->port, &frame, &s->panel, path, error)) {
        return false;
    }
    elements = (size_t)etch_mul_s16(rows_of(s), scene->width);
    if (!get_buffers(s, &buffers, elements)) {
        (void)etch_error_set(error, path, 0, "no memory for a frame of %d x %d", scene->width,
                             scene->height);
    } else {
        ok = draw_frame(s, &buffers, elements, path, error) &&
             etch_screen_look(&s->screen, path, error);
    }
    free_buffers(&buffers);
    return ok;
}

void etch_simulation_close(struct etch_simulation *s)
{
    etch_screen_close(&s->screen);
    free(s->depth);
    free(s->stencil);
    s->depth = s->stencil = NULL;
}
