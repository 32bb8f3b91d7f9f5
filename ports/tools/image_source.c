/* ports/tools/image_source.c: reads PPM and PGM for etch-image. See image_source.h. */
#include "image_source.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

void image_fail(const char *what, const char *detail)
{
    fprintf(stderr, "etch-image: %s%s\n", what, detail);
    exit(2);
}

void *image_memory(size_t size)
{
    void *const memory = calloc(size + 1, 1);

    if (memory == NULL)
        image_fail("out of memory", "");
    return memory;
}

void image_open(struct picture *p, long width, long height, const char *path)
{
    if (width < 1 || width > IMAGE_SIDE || height < 1 || height > IMAGE_SIDE)
        image_fail("sides are 1 to 32767 pixels, not so in ", path);
    p->width = (int)width, p->height = (int)height;
    p->alpha = false;
    p->rgba = image_memory((size_t)width * (size_t)height * 4);
}

/* The next number of a header, behind blanks and comments; -1 if there is none. */
static long number(FILE *file)
{
    long value = 0;
    int c = getc(file);

    while (isspace(c) || c == '#') {
        while (c == '#' || (c != '\n' && c != EOF && !isspace(c)))
            do
                c = getc(file);
            while (c != '\n' && c != EOF);
        c = getc(file);
    }
    if (!isdigit(c))
        return -1;
    for (; isdigit(c); c = getc(file))
        value = value > 99999 ? value : value * 10 + (c - '0');
    return isspace(c) ? value : -1; /* one blank ends the header */
}

static void read_netpbm(struct picture *p, FILE *file, const char *path, int channels)
{
    const long width = number(file), height = number(file), most = number(file);

    if (width < 0 || height < 0 || most != 255)
        image_fail("not a PPM or PGM of 8 bits a channel: ", path);
    image_open(p, width, height, path);
    for (size_t i = 0; i < (size_t)width * (size_t)height; i++) {
        uint8_t c[3];

        if (fread(c, 1, (size_t)channels, file) != (size_t)channels)
            image_fail("the file ends too soon: ", path);
        p->rgba[4 * i] = c[0];
        p->rgba[4 * i + 1] = c[channels == 3 ? 1 : 0];
        p->rgba[4 * i + 2] = c[channels == 3 ? 2 : 0];
        p->rgba[4 * i + 3] = 255;
    }
}

void image_read(struct picture *p, const char *path)
{
    FILE *const file = fopen(path, "rb");
    uint8_t head[2];

    if (file == NULL)
        image_fail("cannot read ", path);
    if (fread(head, 1, 2, file) != 2)
        image_fail("neither PPM, PGM nor PNG: ", path);
    if (head[0] == 'P' && (head[1] == '6' || head[1] == '5'))
        read_netpbm(p, file, path, head[1] == '6' ? 3 : 1);
    else if (head[0] == 0x89 && head[1] == 'P')
        image_read_png(p, file, path);
    else
        image_fail("neither PPM (P6), PGM (P5) nor PNG: ", path);
    (void)fclose(file);
}
