/* bench/check.c: is a workload's picture right?
 *
 *      check WORKLOAD DIR      reads DIR/frameN.565 and, if there, frameN.z16, N = 0 ..
 *
 * Prints "primitives N pixels N frames N" (pixels: covered, summed over primitives, the unit of the
 * table) if it is; otherwise says where it is wrong on stderr and ends with status 1.
 */
#include "check.h"

#include <stdio.h>
#include <stdlib.h>

static struct check c;

/* A plane of the machine's own words, that of the given frame, or NULL if there is none. */
static const uint16_t *read_plane(const char *dir, const char *kind, int frame)
{
    const size_t n = WL_W * WL_H;
    uint16_t *plane = malloc(n * sizeof *plane);
    char path[4096];

    snprintf(path, sizeof path, "%s/frame%d.%s", dir, frame, kind);
    FILE *f = fopen(path, "rb");
    if (f == NULL)
        return NULL;
    if (plane == NULL || fread(plane, sizeof *plane, n, f) != n) {
        fprintf(stderr, "%s: too short\n", path);
        exit(1);
    }
    fclose(f);
    return plane;
}

static bool depth_is_right(int64_t exact, uint16_t drawn)
{
    return exact == CHECK_FAR ? drawn == 65535
                              : llabs(((int64_t)drawn << 16) - exact) <= CHECK_TOLERANCE;
}

static bool pixel_is_right(int workload, int x, int y)
{
    const int i = y * WL_W + x;

    if (workload == WL_BIG_TEX)
        return c.expected[y][x].drawn ? c.matched[y][x] : c.color[i] == 0;

    if (c.depth == NULL)
        return c.expected[y][x].drawn ? check_color(c.color[i], c.expected[y][x].channel)
                                      : c.color[i] == 0;
    if (!depth_is_right(c.least[y][x], c.depth[i]))
        return false;
    return c.least[y][x] == CHECK_FAR ? c.color[i] == 0 : c.matched[y][x];
}

/* The number of wrong pixels; the first ones are named. */
static int compare(int workload)
{
    int wrong = 0;

    for (int y = 0; y < WL_H; y++)
        for (int x = 0; x < WL_W; x++)
            if (!pixel_is_right(workload, x, y) && wrong++ < 5)
                fprintf(stderr, "W%d: pixel (%d, %d) is wrong: 0x%04x\n", workload, x, y,
                        (unsigned)c.color[y * WL_W + x]);
    return wrong;
}

/* Draws the frame that should be there, as far as a comparison needs it. */
static bool expect(int workload, uint8_t frame)
{
    for (int i = 0; i < WL_W * WL_H; i++) {
        c.least[i / WL_W][i % WL_W] = CHECK_FAR;
        c.matched[i / WL_W][i % WL_W] = false;
    }
    if (workload == WL_MESH)
        return check_torus(&c, frame);
    if (workload <= WL_DISC)
        check_2d(&c, workload);
    else if (workload == WL_BIG_TEX || workload == WL_BIG_TEXP_Z)
        check_textures(&c);
    else if (workload == WL_TEXT)
        check_text(&c);
    else
        check_triangles(&c, workload);
    return true;
}

int main(int argc, char **argv)
{
    const int workload = argc == 3 ? atoi(argv[1]) : 0;
    const uint8_t frames = workload == WL_MESH ? WL_NFRAME : 1;

    if (workload == 0)
        return fprintf(stderr, "usage: check WORKLOAD DIR\n"), 2;
    for (uint8_t frame = 0; frame < frames; frame++) {
        c.color = read_plane(argv[2], "565", frame);
        c.depth = read_plane(argv[2], "z16", frame);
        if (c.color == NULL)
            return fprintf(stderr, "W%d: no picture\n", workload), 1;
        const int wrong = expect(workload, frame) ? compare(workload) : WL_W * WL_H;
        if (wrong != 0)
            return fprintf(stderr, "W%d: %d pixels are wrong\n", workload, wrong), 1;
    }
    printf("primitives %lu pixels %lu frames %d\n", (unsigned long)c.primitives,
           (unsigned long)c.pixels, frames);
    return 0;
}
