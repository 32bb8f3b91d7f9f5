/* tests/images: writes the pictures that etch-image is tested with: colours that RGB565 has
 * exactly. pictures DIR */
#include <stdint.h>
#include <stdio.h>

#define WIDTH 37 /* no multiple of what a byte holds */
#define HEIGHT 23

/* Wide blocks of `colors` colours, number 0 a pink. */
static void color(uint8_t rgb[3], int x, int y, int colors)
{
    const int i = (x / 5 * 3 + y / 4 + x * y / 40) % colors;

    rgb[0] = (uint8_t)(i == 0 ? 255 : i * 16 | i * 16 >> 5);
    rgb[1] = (uint8_t)(i == 0 ? 0 : ((255 - i * 12) & 0xFC) | (255 - i * 12) >> 6);
    rgb[2] = (uint8_t)(i == 0 ? 255 : i % 3 * 8);
}

static int write_colors(const char *dir, const char *name, int colors)
{
    char path[4096];
    FILE *out;

    (void)snprintf(path, sizeof path, "%s/%s", dir, name);
    out = fopen(path, "wb");
    if (out == NULL)
        return 1;
    fprintf(out, "P6\n# %d colours\n%d %d\n255\n", colors, WIDTH, HEIGHT);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        uint8_t rgb[3];

        color(rgb, i % WIDTH, i / WIDTH, colors);
        (void)fwrite(rgb, 1, 3, out);
    }
    return fclose(out);
}

static int write_ramp(const char *dir, int width)
{
    char path[4096];
    FILE *out;

    (void)snprintf(path, sizeof path, "%s/ramp%d.pgm", dir, width);
    out = fopen(path, "wb");
    if (out == NULL)
        return 1;
    fprintf(out, "P5 %d %d 255\n", width, HEIGHT);
    for (int i = 0; i < width * HEIGHT; i++)
        (void)putc(i % width < 9 ? 0 : i % width > 27 ? 255 : i * 7 & 255, out);
    return fclose(out);
}

/* Every colour of RGB565. */
static int write_all(const char *dir)
{
    char path[4096];
    FILE *out;

    (void)snprintf(path, sizeof path, "%s/all.ppm", dir);
    out = fopen(path, "wb");
    if (out == NULL)
        return 1;
    fprintf(out, "P6 256 256 255\n");
    for (int c = 0; c < 65536; c++) {
        const int r = c >> 11, g = c >> 5 & 63, b = c & 31;
        const uint8_t rgb[3] = {(uint8_t)(r << 3 | r >> 2), (uint8_t)(g << 2 | g >> 4),
                                (uint8_t)(b << 3 | b >> 2)};

        (void)fwrite(rgb, 1, 3, out);
    }
    return fclose(out);
}

int main(int argc, char **argv)
{
    return argc != 2 || write_colors(argv[1], "c2.ppm", 2) != 0 ||
           write_colors(argv[1], "c4.ppm", 4) != 0 || write_colors(argv[1], "c16.ppm", 16) != 0 ||
           write_all(argv[1]) != 0 || write_ramp(argv[1], WIDTH) != 0 ||
           write_ramp(argv[1], WIDTH + 1) != 0;
}
