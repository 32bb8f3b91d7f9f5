/* draw/retained.h: triangles set up once a frame and drawn strip by strip.
 *
 * Drawing in strips sets up a triangle again for every strip that it crosses. Where there is RAM
 * for it, keep what set-up makes:
 *
 *      once a frame:        mesh or triangles -> assembly -> &retained.sink -> caller's buffer
 *      for every strip:     etch_retained_draw(&retained, strip)
 *
 * The pixels are those of etch_triangle_gouraud_depth, in the order in which the triangles came.
 */
#ifndef ETCH_DRAW_RETAINED_H
#define ETCH_DRAW_RETAINED_H

#include "../fragment/gouraud.h"
#include "../raster/triangle.h"
#include "../vertex/assembly.h"

/* A triangle with its planes, about 115 bytes. */
struct etch_retained_triangle {
    int16_t group_y0, group_y1; /* rows of ETCH_RETAINED_GROUP triangles, in their first: what is
                                   near in a mesh is near on the screen, so a strip skips them */
    struct etch_triangle shape;
    struct etch_gouraud_paint paint;
};

#define ETCH_RETAINED_GROUP 8

struct etch_retained {
    struct etch_sink sink;  /* give &retained.sink to etch_assembly */
    struct etch_rect frame; /* what lies outside is not kept */
    struct etch_retained_triangle *triangle;
    etch_kernel *kernel; /* that they are drawn by */
    uint16_t room;
    uint16_t count; /* of triangles kept; set it to 0 to begin another frame */
    uint16_t lost;  /* of visible ones that found no room, up to 65535: draw without, or in two
                       passes over the scene */
};

/* Empties *r over the caller's buffer of `room` triangles; `frame` is usually the whole frame,
 * kernel: etch_kernel_gouraud_less, .. (draw/triangle.h). */
void etch_retained_init(struct etch_retained *r, struct etch_rect frame, etch_kernel *kernel,
                        struct etch_retained_triangle *triangle, uint16_t room);

/* Draws what is kept inside surface->clip. Cost on ARMv6-M: 9 instructions for a
 * triangle or a group on other rows, and no set-up but that of its edges for the others. */
void etch_retained_draw(const struct etch_retained *r, const struct etch_surface *surface);

#endif
