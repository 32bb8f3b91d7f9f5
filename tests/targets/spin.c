/* tests/targets: the program of the table of throughput: a torus of 100 triangles turns once in 8
 * frames, of which FRAMES are drawn after a first one that is not counted. tests/bench/plugin.c
 * counts from bench_counted to bench_done. */
#include "hal/frame.h"
#include "ports/board.h"
#include "scenes.h"

int main(void);
int bench_counted(struct etch_frame *frame, bool swapped);
void bench_done(void);

static uint16_t depth[STRIP];
static uint16_t pixels[BUFFERS][STRIP];

static int draw(struct etch_frame *frame, bool swapped)
{
    target_spin.prepare(frame->display->width, frame->display->height);
    for (struct etch_surface *s = etch_frame_begin(frame); s != NULL; s = etch_frame_next(frame))
        target_spin.draw(s, swapped);
    return etch_frame_end(frame);
}

__attribute__((noinline)) int bench_counted(struct etch_frame *frame, bool swapped)
{
    int status = 0;

    for (int n = 0; n < FRAMES && status == 0; n++)
        status = draw(frame, swapped);
    return status;
}

__attribute__((noinline)) void bench_done(void)
{
    __asm__ volatile("");
}

int main(void)
{
    const struct etch_display *display = board_open();
    const struct etch_frame_memory memory = {
        .pixels = {pixels[0], BUFFERS > 1 ? pixels[BUFFERS - 1] : NULL},
        .depth = depth,
        .size = STRIP};
    struct etch_frame frame;
    int status = ETCH_EIO;

    if (display != NULL && etch_frame_init(&frame, display, memory) == ETCH_OK) {
        const bool swapped = display->format == ETCH_FORMAT_RGB565_SWAPPED;

        status = draw(&frame, swapped);
        status = status == 0 ? bench_counted(&frame, swapped) : status;
        bench_done();
    }
    board_print(status == 0 ? "drawn\n" : "FAIL\n");
    return status == 0 ? 0 : 1;
}
