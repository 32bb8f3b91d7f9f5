/* tests/targets: the program of every board: draws the scene SCENE through the frame loop, in
 * strips of what STRIP pixels hold, then says so. Two buffers where the board gives two. */
#include "hal/frame.h"
#include "ports/board.h"
#include "scenes.h"

int main(void);

static uint16_t depth[STRIP];
static uint16_t pixels[BUFFERS][STRIP];

static int draw(const struct etch_display *display, const struct target_scene *scene)
{
    const bool swapped = display->format == ETCH_FORMAT_RGB565_SWAPPED;
    const struct etch_frame_memory memory = {
        .pixels = {pixels[0], BUFFERS > 1 ? pixels[BUFFERS - 1] : NULL},
        .depth = depth,
        .size = STRIP};
    struct etch_frame frame;
    const int status = etch_frame_init(&frame, display, memory);

    if (status != 0)
        return status;
    scene->prepare(display->width, display->height);
    for (struct etch_surface *s = etch_frame_begin(&frame); s != NULL; s = etch_frame_next(&frame))
        scene->draw(s, swapped);
    return etch_frame_end(&frame);
}

int main(void)
{
    const struct etch_display *display = board_open();
    const int status = display == NULL ? ETCH_EIO : draw(display, &SCENE);

    board_print(status == 0 ? "drawn\n" : "FAIL\n");
    return status == 0 ? 0 : 1;
}
