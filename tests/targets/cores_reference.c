/* tests/targets: the torus of cores.c by one thread, whole, as big-endian RGB565 on standard
 * output. */
#include <stdio.h>

#include "tests/workers/torus.h"

enum {
    WIDTH = 320,
    HEIGHT = 240
};

int main(void)
{
    static struct torus torus;
    static uint16_t pixels[WIDTH * HEIGHT], depth[WIDTH * HEIGHT];
    const struct etch_rect window = {0, 0, WIDTH, HEIGHT};
    struct etch_surface s;

    torus_make(&torus);
    torus_turn(&torus, 0, WIDTH, HEIGHT);
    if (etch_surface_init(&s, pixels, window, WIDTH) != ETCH_OK)
        return 1;
    s.depth = depth;
    torus_draw_alone(&torus, &s);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        putchar(pixels[i] >> 8);
        putchar(pixels[i] & 0xFF);
    }
    return ferror(stdout) == 0 ? 0 : 1;
}
