/* ports/tools/image_pack.c: brings pictures to a format. Called by etch-image. See image_format.h.
 */
#include <stdlib.h>
#include <string.h>

#include "../../core/base/rgb565.h"
#include "image_format.h"

/* A picture on its way. */
struct packing {
    struct packed *out;
    const struct picture *p;
    const struct image_options *options;
    uint8_t palette[256][3];
    int first; /* the palette's first colour that is drawn */
    int (*error)[3],
        (*below)[3]; /* of dithering, 1/16 steps: this row, the next; one more each side */
};

static void expand(uint8_t rgb[3], uint16_t color)
{
    rgb[0] = etch_rgb565_red(color);
    rgb[1] = etch_rgb565_green(color);
    rgb[2] = etch_rgb565_blue(color);
}

static bool is_left_out(const struct packing *k, size_t i)
{
    const uint8_t *const c = k->p->rgba + 4 * i;

    return k->out->format->key &&
           ((k->options->has_key && memcmp(c, k->options->key, 3) == 0) || c[3] < 128);
}

/* What pixel i is to look like. */
static void wanted(uint8_t rgb[3], const struct packing *k, size_t i)
{
    const uint8_t *const c = k->p->rgba + 4 * i;
    const bool over = !k->out->format->key && !k->out->format->alpha;

    for (int n = 0; n < 3; n++)
        rgb[n] = over ? image_over(c[n], c[3], k->options->background[n]) : c[n];
}

/* The palette of what is drawn, in steps of RGB565. */
static void make_palette(struct packing *k)
{
    const size_t count = (size_t)k->out->width * (size_t)k->out->height;
    uint8_t(*const pixel)[3] = image_memory(count * 3);
    size_t n = 0;

    k->first = k->out->format->key ? 1 : 0;
    for (size_t i = 0; i < count; i++) {
        if (!is_left_out(k, i)) {
            wanted(pixel[n], k, i);
            expand(pixel[n], etch_rgb565(pixel[n][0], pixel[n][1], pixel[n][2]));
            n++;
        }
    }
    k->out->colors = k->first + image_palette(k->palette + k->first,
                                              (1 << k->out->format->bits) - k->first,
                                              (const uint8_t(*)[3])pixel, n);
    for (int i = 0; i < k->out->colors; i++) {
        k->out->palette[i] = etch_rgb565(k->palette[i][0], k->palette[i][1], k->palette[i][2]);
        expand(k->palette[i], k->out->palette[i]);
    }
    free(pixel);
}

/* palette[0] is a colour that no pixel has, pink if it can be. Where pixels have all 65536 it is
 * pink, and choose() moves those aside. */
static void make_key(struct packing *k)
{
    const size_t count = (size_t)k->out->width * (size_t)k->out->height;
    bool *const used = image_memory(65536);
    uint32_t key = 0xF81F;

    for (size_t i = 0; i < count; i++) {
        uint8_t rgb[3];

        wanted(rgb, k, i);
        used[etch_rgb565(rgb[0], rgb[1], rgb[2])] = !is_left_out(k, i) ||
                                                    used[etch_rgb565(rgb[0], rgb[1], rgb[2])];
    }
    for (int tries = 0; used[key] && tries < 65536; tries++) /* all of them lead back to pink */
        key = (key + 1) & 0xFFFF;
    k->out->palette[0] = (uint16_t)key;
    k->out->colors = 1;
    free(used);
}

static int hold(int v)
{
    return v < 0 ? 0 : v > 255 ? 255 : v;
}

/* The texel for a colour, and the colour that it is. */
static uint16_t choose(const struct packing *k, uint8_t shown[3], const int rgb[3])
{
    const int first = k->first;
    int found;

    if (k->out->format->kind == IMAGE_COLORS) {
        const uint16_t color = etch_rgb565((uint8_t)rgb[0], (uint8_t)rgb[1], (uint8_t)rgb[2]);
        const bool is_key = k->out->format->key && color == k->out->palette[0];

        expand(shown, is_key ? color ^ 0x20 : color); /* one step of green away */
        return is_key ? color ^ 0x20 : color;
    }
    found = first +
            image_nearest((const uint8_t(*)[3])k->palette + first, k->out->colors - first, rgb);
    memcpy(shown, k->palette[found], 3);
    return (uint16_t)found;
}

/* Hands 7, 3, 5 and 1 of 16 parts on (R. Floyd, L. Steinberg, 1976). */
static void spread(struct packing *k, int x, const int rgb[3], const uint8_t shown[3])
{
    for (int n = 0; n < 3; n++) {
        const int error = rgb[n] - shown[n];

        k->error[x + 2][n] += 7 * error;
        k->below[x][n] += 3 * error;
        k->below[x + 1][n] += 5 * error;
        k->below[x + 2][n] += error;
    }
}

static void put(struct plane *plane, int x, int y, int bits, uint32_t value)
{
    uint8_t *const row = plane->bytes + (size_t)y * (size_t)plane->pitch;

    if (bits == 16)
        row[2 * x] = (uint8_t)(value & 255), row[2 * x + 1] = (uint8_t)(value >> 8);
    else
        row[x * bits / 8] |= (uint8_t)(value << x * bits % 8);
}

/* A texel in the order that is asked for. */
static void put_texel(struct packing *k, int x, int y, uint16_t value)
{
    const int bits = k->out->format->bits;

    put(&k->out->texels, x, y, bits,
        bits == 16 && k->options->swapped ? etch_rgb565_swap(value) : value);
}

static void pack_color(struct packing *k, int x, int y)
{
    const size_t i = (size_t)y * (size_t)k->out->width + (size_t)x;
    uint8_t *const shown = k->out->shown + 4 * i;
    uint8_t want[3];
    int rgb[3];

    if (is_left_out(k, i)) {
        put_texel(k, x, y, k->out->format->kind == IMAGE_COLORS ? k->out->palette[0] : 0);
        return;
    }
    wanted(want, k, i);
    for (int n = 0; n < 3; n++)
        rgb[n] = hold(want[n] + (k->options->dither ? (k->error[x + 1][n] + 8) / 16 : 0));
    put_texel(k, x, y, choose(k, shown, rgb));
    if (k->options->dither)
        spread(k, x, rgb, shown);
    shown[3] = 255;
}

/* How much of a mask's colour pixel i has: its alpha, or how light it is. */
static uint8_t level(const struct packing *k, size_t i)
{
    const uint8_t *const c = k->p->rgba + 4 * i;

    return k->p->alpha || k->out->format->kind != IMAGE_MASK
               ? c[3]
               : (uint8_t)((c[0] * 77 + c[1] * 151 + c[2] * 28 + 128) >> 8);
}

static void pack_alpha(struct packing *k, int x, int y)
{
    const size_t i = (size_t)y * (size_t)k->out->width + (size_t)x;
    const int bits = k->out->format->bits == 4 ? 4 : 8;
    const uint8_t a = level(k, i), value = bits == 4 ? (uint8_t)((a * 15 + 127) / 255) : a;

    put(&k->out->alpha, x, y, bits, value);
    k->out->shown[4 * i + 3] = (uint8_t)(bits == 4 ? value * 17 : value);
}

static void open_plane(struct plane *plane, const struct packed *out, int bits)
{
    plane->pitch = out->stride * bits / 8;
    plane->unit_size = bits == 16 ? 2 : 1;
    plane->size = (size_t)plane->pitch * (size_t)out->height;
    plane->bytes = image_memory(plane->size);
}

static void pack_rows(struct packing *k)
{
    const size_t room = ((size_t)k->out->width + 3) * sizeof *k->error;

    k->error = image_memory(room), k->below = image_memory(room);
    for (int y = 0; y < k->out->height; y++) {
        int(*const done)[3] = k->error;

        for (int x = 0; x < k->out->width; x++) {
            if (k->out->format->kind != IMAGE_MASK)
                pack_color(k, x, y);
            if (k->out->format->alpha)
                pack_alpha(k, x, y);
        }
        k->error = k->below, k->below = done;
        memset(k->below, 0, room);
    }
    free(k->error);
    free(k->below);
}

void image_pack(struct packed *out, const struct picture *p, const struct image_format *format,
                const struct image_options *options)
{
    const int per_byte = format->bits < 8 ? 8 / format->bits : 1;
    struct packing k = {.out = out, .p = p, .options = options};

    *out = (struct packed){.format = format, .width = p->width, .height = p->height};
    out->stride = (p->width + per_byte - 1) / per_byte * per_byte;
    out->shown = image_memory((size_t)p->width * (size_t)p->height * 4);
    if (format->kind != IMAGE_MASK)
        open_plane(&out->texels, out, format->bits);
    if (format->alpha)
        open_plane(&out->alpha, out, format->bits == 4 ? 4 : 8);
    if (format->kind == IMAGE_PALETTE)
        make_palette(&k);
    else if (format->key)
        make_key(&k);
    else if (format->kind == IMAGE_MASK)
        out->palette[out->colors++] = etch_rgb565(options->ink[0], options->ink[1],
                                                  options->ink[2]);
    pack_rows(&k);
    if (options->compressed) {
        if (format->kind == IMAGE_PALETTE)
            out->colors = 1 << format->bits; /* so that no data names a colour that is not there */
        image_compress(&out->texels, out->height, options->rows_shift);
        image_compress(&out->alpha, out->height, options->rows_shift);
    }
}
