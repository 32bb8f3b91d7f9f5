/* draw/image_rle.c: compressed images, a row at a time. Called by applications. See image_rle.h. */
#include "image_rle.h"

/* A plane on its way down. */
struct reader {
    const struct etch_rle_plane *plane;
    struct etch_rle_cursor cursor;
    void *out;
};

/* Goes to row y. A row that is not in the data leaves nothing to read. */
static void seek(struct reader *r, int16_t y)
{
    const struct etch_rle_plane *const plane = r->plane;
    const uint32_t offset = plane->rows[y >> plane->rows_shift];
    const uint16_t over = (uint16_t)((uint32_t)y & ((UINT32_C(1) << plane->rows_shift) - 1));

    r->cursor.end = plane->data + (size_t)plane->size;
    r->cursor.at = offset < plane->size ? plane->data + (size_t)offset : r->cursor.end;
    for (uint16_t i = 0; i < over; i++)
        (void)plane->decode(&r->cursor, r->out, 0, plane->units);
}

/* Decodes row y, if there is such a plane, as far as its first n texels; returns how many there
 * are. A row of the table begins where it says, whatever the one above was. */
static int32_t read(struct reader *r, bool first, int16_t y, int32_t n)
{
    const struct etch_rle_plane *const plane = r->plane;

    if (plane->decode == NULL)
        return n;
    const int32_t units = (int32_t)((uint32_t)(n + plane->per_unit - 1) / plane->per_unit);
    int32_t got;

    if (first || ((uint32_t)y & ((UINT32_C(1) << plane->rows_shift) - 1)) == 0)
        seek(r, y);
    got = plane->decode(&r->cursor, r->out, (uint16_t)(units < plane->units ? units : plane->units),
                        plane->units);
    got *= plane->per_unit;
    return got < n ? got : n;
}

/* What is drawn: columns and rows of the image, half-open. */
struct part {
    int32_t x0, y0, x1, y1;
};

static bool clip(struct part *p, const struct etch_surface *s, const struct etch_image *image,
                 int16_t x, int16_t y)
{
    const int32_t left = (int32_t)s->clip.x0 - x, right = (int32_t)s->clip.x1 - x;
    const int32_t above = (int32_t)s->clip.y0 - y, below = (int32_t)s->clip.y1 - y;

    p->x0 = left > 0 ? left : 0;
    p->y0 = above > 0 ? above : 0;
    p->x1 = right < image->width ? right : image->width;
    p->y1 = below < image->height ? below : image->height;
    return p->x0 < p->x1 && p->y0 < p->y1 && image->width <= INT16_MAX &&
           image->height <= INT16_MAX;
}

void etch_rle_draw(const struct etch_surface *s, const struct etch_rle_style *style, int16_t x,
                   int16_t y)
{
    const struct etch_rle_image *const rle = style->image;
    const size_t size = (size_t)etch_rle_plane_size(&rle->texels);
    struct reader texels = {.plane = &rle->texels, .out = style->line};
    struct reader alpha = {.plane = &rle->alpha, .out = (uint8_t *)style->line + size};
    struct etch_image image = rle->image;
    struct etch_image_line line = {
        .image = &image, .step_q32 = UINT64_C(1) << 32, .opacity = style->opacity};
    struct part p;

    if (!clip(&p, s, &image, x, y))
        return;
    image.texels = texels.out, image.alpha = alpha.out;
    line.place_q32 = (uint64_t)(uint32_t)p.x0 << 32;
    for (int32_t row = p.y0; row < p.y1; row++) {
        const bool first = row == p.y0;
        const int32_t end = read(&alpha, first, (int16_t)row,
                                 read(&texels, first, (int16_t)row, p.x1));

        if (p.x0 < end)
            style->row(s->pixels + etch_surface_index(s, (int16_t)(x + p.x0), (int16_t)(y + row)),
                       (uint16_t)(end - p.x0), &line);
    }
}
