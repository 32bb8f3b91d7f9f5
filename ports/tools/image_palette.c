/* ports/tools/image_palette.c: palettes by median cut (P. Heckbert, "Color image quantization for
 * frame buffer display", 1982). Called by image_pack.c. See image_format.h. */
#include <stdlib.h>
#include <string.h>

#include "image_format.h"

/* A colour and how many pixels have it. */
struct color {
    uint8_t rgb[3];
    uint32_t count;
};

struct box {
    size_t first, count; /* colours */
    int channel;         /* the widest */
    uint64_t spread;     /* its width times the pixels */
};

static int by_channel[3][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}};

static int compare(const struct color *a, const struct color *b, const int order[3])
{
    for (int i = 0; i < 3; i++)
        if (a->rgb[order[i]] != b->rgb[order[i]])
            return a->rgb[order[i]] < b->rgb[order[i]] ? -1 : 1;
    return 0;
}

static int by_red(const void *a, const void *b)
{
    return compare(a, b, by_channel[0]);
}

static int by_green(const void *a, const void *b)
{
    return compare(a, b, by_channel[1]);
}

static int by_blue(const void *a, const void *b)
{
    return compare(a, b, by_channel[2]);
}

static void sort(struct color *c, size_t count, int channel)
{
    qsort(c, count, sizeof *c, channel == 0 ? by_red : channel == 1 ? by_green : by_blue);
}

/* Equal colours become one. */
static size_t gather(struct color *c, const uint8_t (*pixel)[3], size_t count)
{
    size_t n = 0;

    for (size_t i = 0; i < count; i++) {
        memcpy(c[i].rgb, pixel[i], 3);
        c[i].count = 1;
    }
    sort(c, count, 0);
    for (size_t i = 0; i < count; i++) {
        if (n != 0 && memcmp(c[n - 1].rgb, c[i].rgb, 3) == 0)
            c[n - 1].count++;
        else
            c[n++] = c[i];
    }
    return n;
}

static void measure(struct box *box, const struct color *c)
{
    uint64_t pixels = 0;

    box->spread = 0;
    for (size_t i = box->first; i < box->first + box->count; i++)
        pixels += c[i].count;
    for (int k = 0; k < 3; k++) {
        int least = 255, most = 0;

        for (size_t i = box->first; i < box->first + box->count; i++) {
            least = c[i].rgb[k] < least ? c[i].rgb[k] : least;
            most = c[i].rgb[k] > most ? c[i].rgb[k] : most;
        }
        if ((uint64_t)(most - least) * pixels > box->spread)
            box->spread = (uint64_t)(most - least) * pixels, box->channel = k;
    }
}

/* Cuts a box of two colours or more where half of its pixels are on each side. */
static void cut(struct box *box, struct box *other, struct color *c)
{
    uint64_t pixels = 0, half = 0;
    size_t at;

    sort(c + box->first, box->count, box->channel);
    for (size_t i = box->first; i < box->first + box->count; i++)
        pixels += c[i].count;
    for (at = box->first; at < box->first + box->count - 1; at++) {
        half += c[at].count;
        if (half * 2 >= pixels)
            break;
    }
    at += at < box->first + box->count - 1;
    *other = (struct box){.first = at, .count = box->first + box->count - at};
    box->count = at - box->first;
    measure(box, c);
    measure(other, c);
}

int image_nearest(const uint8_t (*palette)[3], int colors, const int rgb[3])
{
    long best = -1;
    int found = 0;

    for (int i = 0; i < colors; i++) {
        const long r = rgb[0] - palette[i][0], g = rgb[1] - palette[i][1],
                   b = rgb[2] - palette[i][2];
        const long distance = 3 * r * r + 6 * g * g + b * b; /* about what the eye weighs */

        if (best < 0 || distance < best)
            best = distance, found = i;
    }
    return found;
}

/* Each colour becomes the mean of the pixels nearest to it (S. Lloyd, 1957). */
static void settle(uint8_t (*palette)[3], int colors, const struct color *c, size_t count)
{
    static uint64_t sum[256][4];

    memset(sum, 0, sizeof sum);
    for (size_t i = 0; i < count; i++) {
        const int rgb[3] = {c[i].rgb[0], c[i].rgb[1], c[i].rgb[2]};
        uint64_t *const s = sum[image_nearest((const uint8_t(*)[3])palette, colors, rgb)];

        for (int k = 0; k < 3; k++)
            s[k] += (uint64_t)c[i].rgb[k] * c[i].count;
        s[3] += c[i].count;
    }
    for (int i = 0; i < colors; i++)
        for (int k = 0; k < 3 && sum[i][3] != 0; k++)
            palette[i][k] = (uint8_t)((sum[i][k] + sum[i][3] / 2) / sum[i][3]);
}

int image_palette(uint8_t (*palette)[3], int most, const uint8_t (*pixel)[3], size_t count)
{
    struct color *const c = image_memory(count * sizeof *c);
    struct box box[256];
    const size_t n = gather(c, pixel, count);
    int boxes = 1;

    box[0] = (struct box){.count = n};
    measure(&box[0], c);
    while (boxes < most) {
        int widest = 0;

        for (int i = 1; i < boxes; i++)
            widest = box[i].spread > box[widest].spread ? i : widest;
        if (box[widest].spread == 0)
            break;
        cut(&box[widest], &box[boxes], c);
        boxes++;
    }
    for (int i = 0; i < boxes; i++)
        memcpy(palette[i], c[box[i].first].rgb, 3);
    for (int i = 0; i < 8 && (size_t)boxes < n; i++)
        settle(palette, boxes, c, n);
    free(c);
    return count == 0 ? 0 : boxes;
}
