/* tests/images: draws what etch-image wrote and compares with the pictures it was made of. */
#include "check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/rgb565.h"
#include "ports/tools/image_source.h"

enum {
    SIDE = 64
};
static uint16_t pixels[2][SIDE * SIDE];
static int passed, failed;

static void check(bool ok, const struct image_case *c, const char *what)
{
    if (ok)
        passed++;
    else
        failed++, printf("FAIL %s: %s\n", c->label, what);
}

/* Both forms over a background with every pixel of its own. */
static void draw(const struct image_case *c, uint16_t background)
{
    static uint16_t line[2 * SIDE];
    const struct etch_rect all = {0, 0, SIDE, SIDE};
    const struct etch_image_style plain = {c->plain, c->row, 255};
    const struct etch_rle_style packed = {c->packed, c->row, 255, line};
    struct etch_surface s;

    for (int i = 0; i < SIDE * SIDE; i++)
        pixels[0][i] = pixels[1][i] = (uint16_t)(background ^ i * 977);
    (void)etch_surface_init(&s, pixels[0], all, SIDE);
    etch_image_draw(&s, &plain, 0, 0);
    s.pixels = pixels[1];
    etch_rle_draw(&s, &packed, 0, 0);
    check(memcmp(pixels[0], pixels[1], sizeof pixels[0]) == 0, c, "compressed, it looks different");
    check(etch_rle_line_size(c->packed) <= sizeof line, c, "a line is too long");
}

static bool is_left_out(const struct image_case *c, const uint8_t *rgb)
{
    return c->key[0] != '\0' && strtoul(c->key, NULL, 16) == ((unsigned long)rgb[0] << 16 |
                                                              (unsigned long)rgb[1] << 8 | rgb[2]);
}

/* The error of what was drawn is what the tool said of it. */
static void compare_report(const struct image_case *c, const struct picture *p)
{
    double absolute = 0, squared = 0;
    int most = 0, samples = 0;
    char text[64];

    for (int i = 0; i < p->width * p->height; i++) {
        const uint8_t *const rgb = p->rgba + 4 * i;
        const uint16_t at = pixels[0][i / p->width * SIDE + i % p->width];
        const uint16_t color = c->swapped ? etch_rgb565_swap(at) : at;
        const uint8_t drawn[3] = {etch_rgb565_red(color), etch_rgb565_green(color),
                                  etch_rgb565_blue(color)};

        samples += c->key[0] != '\0';
        for (int k = 0; k < 3 && !is_left_out(c, rgb); k++) {
            const int error = abs(rgb[k] - drawn[k]);

            absolute += error, squared += (double)error * error, samples++;
            most = error > most ? error : most;
        }
    }
    (void)snprintf(text, sizeof text, "mean %6.3f   max %3d   PSNR ", absolute / samples, most);
    check(strstr(c->report, text) != NULL, c, text);
    if (most == 0)
        (void)snprintf(text, sizeof text, "PSNR exact");
    else
        (void)snprintf(text, sizeof text, "PSNR %.2f dB",
                       10 * log10(255.0 * 255.0 * samples / squared));
    check(strstr(c->report, text) != NULL, c, text);
}

/* Pixels that are left out keep the background, whatever it is. */
static void compare_holes(const struct image_case *c, const struct picture *p, uint16_t background)
{
    int wrong = 0, holes = 0;

    for (int i = 0; i < p->width * p->height; i++) {
        const int at = i / p->width * SIDE + i % p->width;

        if (is_left_out(c, p->rgba + 4 * i))
            wrong += pixels[0][at] != (uint16_t)(background ^ at * 977), holes++;
    }
    check(wrong == 0 && (holes > 0) == (c->key[0] != '\0'), c, "what is left out");
}

static int luma(const uint8_t *c)
{
    return (c[0] * 77 + c[1] * 151 + c[2] * 28 + 128) >> 8;
}

/* The plane of alpha holds how light the pixels are. */
static void compare_alpha(const struct image_case *c, const struct picture *p)
{
    const bool half = c->row == etch_row_mask4 || c->row == etch_row_mask4_swapped;
    int wrong = 0;

    for (int i = 0; i < p->width * p->height; i++) {
        const int place = i / p->width * c->plain->stride + i % p->width;
        const int want = luma(p->rgba + 4 * i);
        const int got = half ? (c->plain->alpha[place / 2] >> place % 2 * 4 & 15)
                             : c->plain->alpha[place];

        wrong += half ? abs(got * 17 - want) > 8 : got != want;
    }
    check(wrong == 0, c, "alpha");
}

int main(void)
{
    for (const struct image_case *c = image_cases; c->label != NULL; c++) {
        struct picture p;

        image_read(&p, c->picture);
        check(c->plain->width == p.width && c->plain->height == p.height, c, "its size");
        draw(c, 0x1234);
        if (c->alpha[0] == '\0') {
            compare_report(c, &p);
            compare_holes(c, &p, 0x1234);
            draw(c, 0xEDCB);
            compare_holes(c, &p, 0xEDCB);
        } else {
            struct picture alpha;

            image_read(&alpha, c->alpha);
            compare_alpha(c, &alpha);
            free(alpha.rgba);
        }
        free(p.rgba);
    }
    printf("%d passed, %d failed\n", passed, failed);
    return failed != 0;
}
