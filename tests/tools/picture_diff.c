/* tests/tools: compares two pictures pixel by pixel. Called by tests/golden/golden.sh.
 *      picture-diff EXPECTED.png ACTUAL.png DIFFERENCE.png
 * Exit status 0 if they are equal, 1 if not: then DIFFERENCE.png shows the expected picture dim
 * with what differs in red, and the first differing pixel is printed; 2 if one cannot be read. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "png_read.h"
#include "png_write.h"

/* Turns p->rgb into the difference picture; returns how many pixels differ. */
static size_t compare(struct picture *expected, const struct picture *actual)
{
    size_t i, n = 0;

    for (i = 0; i < (size_t)expected->width * expected->height; i++) {
        uint8_t *e = expected->rgb + 3 * i;
        const uint8_t *a = actual->rgb + 3 * i;

        if (memcmp(e, a, 3) == 0) {
            memset(e, (e[0] + e[1] + e[2]) / 8, 3);
            continue;
        }
        if (n++ == 0)
            printf("first at x %zu, y %zu: expected %d %d %d, drawn %d %d %d\n",
                   i % expected->width, i / expected->width, e[0], e[1], e[2], a[0], a[1], a[2]);
        e[0] = 255;
        e[1] = 0;
        e[2] = 0;
    }
    return n;
}

int main(int argc, char **argv)
{
    struct picture p[2];
    size_t n;
    int i;

    if (argc != 4) {
        fprintf(stderr, "usage: picture-diff EXPECTED.png ACTUAL.png DIFFERENCE.png\n");
        return 2;
    }
    for (i = 0; i < 2; i++) {
        const char *wrong = png_read(&p[i], argv[1 + i]);

        if (wrong != NULL) {
            fprintf(stderr, "%s: %s\n", argv[1 + i], wrong);
            return 2;
        }
    }
    if (p[0].width != p[1].width || p[0].height != p[1].height) {
        printf("%s is %u x %u, %s is %u x %u\n", argv[1], (unsigned)p[0].width,
               (unsigned)p[0].height, argv[2], (unsigned)p[1].width, (unsigned)p[1].height);
        return 1;
    }
    n = compare(&p[0], &p[1]);
    if (n > 0) {
        printf("%zu pixels differ\n", n);
        if (!png_write(&p[0], argv[3]))
            fprintf(stderr, "%s: cannot be written\n", argv[3]);
    }
    free(p[0].rgb);
    free(p[1].rgb);
    return n > 0 ? 1 : 0;
}
