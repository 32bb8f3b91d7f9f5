/* ports/tools/image_error.c: sizes and errors of formats. Called by etch-image. See image_format.h.
 */
#include <math.h>
#include <stdlib.h>

#include "image_format.h"

struct sum {
    double absolute, squared, samples;
    int most;
};

static void add(struct sum *s, int a, int b)
{
    const int error = abs(a - b);

    s->absolute += error;
    s->squared += (double)error * error;
    s->samples += 1;
    s->most = error > s->most ? error : s->most;
}

static void add_pixel(struct sum *s, const struct packed *packed, const struct picture *p, size_t i,
                      const struct image_options *o)
{
    const uint8_t *const c = p->rgba + 4 * i, *const shown = packed->shown + 4 * i;
    const struct image_format *const f = packed->format;
    const bool keyed = f->key && o->has_key && c[0] == o->key[0] && c[1] == o->key[1] &&
                       c[2] == o->key[2];

    if (f->kind == IMAGE_MASK)
        add(s, p->alpha ? c[3] : (c[0] * 77 + c[1] * 151 + c[2] * 28 + 128) >> 8, shown[3]);
    else if ((f->alpha || f->key) && (p->alpha || o->has_key))
        add(s, keyed ? 0 : c[3], shown[3]);
    if (f->kind == IMAGE_MASK || shown[3] == 0)
        return;
    for (int n = 0; n < 3; n++)
        add(s, f->alpha || f->key ? c[n] : image_over(c[n], c[3], o->background[n]), shown[n]);
}

struct image_error image_compare(const struct packed *packed, const struct picture *p,
                                 const struct image_options *options)
{
    struct image_error error = {0, HUGE_VAL, 0};
    struct sum s = {0, 0, 0, 0};

    for (size_t i = 0; i < (size_t)p->width * (size_t)p->height; i++)
        add_pixel(&s, packed, p, i, options);
    error.most = s.most;
    if (s.squared > 0) {
        error.mean = s.absolute / s.samples;
        error.psnr = 10 * log10(255.0 * 255.0 * s.samples / s.squared);
    }
    return error;
}

static size_t plane_size(const struct plane *plane, int height, int rows_shift)
{
    return plane->size + (plane->rows != NULL ? 4 * ((size_t)((height - 1) >> rows_shift) + 1) : 0);
}

size_t image_size(const struct packed *packed, const struct image_options *options)
{
    return plane_size(&packed->texels, packed->height, options->rows_shift) +
           plane_size(&packed->alpha, packed->height, options->rows_shift) +
           2 * (size_t)packed->colors;
}
