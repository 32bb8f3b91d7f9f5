/* base/map.h: which texel of an image a pixel of the frame shows, when the image is scaled, turned
 * or sheared.
 *
 * The centre of pixel (x, y) is at the place (u + ux x + uy y, v + vx x + vy y) of the image, in
 * texels; texel (i, j) covers [i, i + 1) x [j, j + 1). All numbers have 32 fraction bits and
 * nothing is rounded on the way: a clip or a strip changes no pixel. A pixel is drawn iff it is
 * inside `bounds` and its place inside `from`. The functions here fill a map in; one made by hand
 * keeps |ux| .. |vy| <= 2^45, |u| and |v| <= 2^62.
 */
#ifndef ETCH_BASE_MAP_H
#define ETCH_BASE_MAP_H

#include "rect.h"

struct etch_map {
    int64_t u, v; /* of the centre of pixel (0, 0) */
    int64_t ux, vx, uy, vy;
    struct etch_rect from;   /* texels */
    struct etch_rect bounds; /* pixels of the frame: rows outside cost nothing */
};

/* The texels `from` stretched over the rectangle (x, y, w, h), centre on centre: pixel i of w
 * columns shows the place (2 i + 1) n / (2 w) of n texels, and what is nearest, its whole part, is
 * exact for every size; rows likewise. `from` is inside 0 .. 32767. If it, w or h is empty nothing
 * is drawn. */
void etch_map_scale(struct etch_map *map, struct etch_rect from, int16_t x, int16_t y, int16_t w,
                    int16_t h);

/* How an image lies on the frame: what is at (u, v) of the image goes to (x, y) of the frame (pixel
 * (0, 0) is [0, 1) x [0, 1)), turned clockwise by `angle` about there and scale times as large. */
struct etch_map_place {
    etch_q16 u, v, x, y;
    uint16_t angle;
    etch_q16 scale_u, scale_v; /* before it is turned; below 0: mirrored */
};

/* Steps are rounded to 2^-32 texel. ETCH_EINVAL if a scale is nearer to 0 than 1/8192 or `from` is
 * empty; nothing is drawn with the map then. */
enum etch_status etch_map_rotate(struct etch_map *map, struct etch_rect from,
                                 const struct etch_map_place *place);

/* The inverse of
 *      x = xu u + xv v + x0        from texels to pixels, as above
 *      y = yu u + yv v + y0
 * with steps rounded to 1/65536 texel. |xu| .. |yv| <= 2^30. ETCH_EINVAL if they are larger, have
 * no inverse or one of steps above 8191 texels, or `from` is empty; nothing is drawn with the map
 * then. */
struct etch_affine {
    etch_q16 xu, xv, x0, yu, yv, y0;
};
enum etch_status etch_map_invert(struct etch_map *map, struct etch_rect from,
                                 const struct etch_affine *affine);

/* Of the pixels *x0 .. *x1 - 1 of row y, inside 0 .. 32767, those that the map draws; none if
 * *x1 <= *x0. Takes no division where all or none are, and at most one for each side of `from`. */
void etch_map_interval(const struct etch_map *map, int16_t y, int16_t *x0, int16_t *x1);

#endif
