/* draw/select.h: which object is under this pixel.
 *
 * Objects are drawn with names in the place of colours: what a pixel then holds is the name of the
 * nearest object (or of the latest, without depth). Coverage and depth are those of the painters of
 * draw/triangle.h, so what is selected is what was seen, to the pixel.
 *
 *      etch_select_init(&select, x, y, etch_kernel_flat_less);
 *      assembly.sink = &select.names.sink;
 *      for each object:  select.names.name = 1 + i;  etch_mesh_assemble(..);
 *      select.name is the nearest, 0 if there is none
 */
#ifndef ETCH_DRAW_SELECT_H
#define ETCH_DRAW_SELECT_H

#include "../base/paint.h"
#include "../base/sink.h"

/* Draws triangles in `name`, onto a surface whose pixels are names: a whole frame of them, or one
 * pixel below. */
struct etch_name_sink {
    struct etch_sink sink; /* takes triangles */
    const struct etch_surface *surface;
    etch_kernel *kernel; /* etch_kernel_flat_less, _lequal: with a depth plane; or one of yours for
                            the same paint (fragment/flat.h) */
    uint16_t name;       /* of what is drawn next; the caller's to set */
};

void etch_name_sink_init(struct etch_name_sink *names, const struct etch_surface *surface,
                         etch_kernel *kernel);

struct etch_select {
    struct etch_name_sink names;
    struct etch_surface surface; /* the one pixel */
    uint16_t name, depth;        /* what it holds: 0 and 65535 at first */
};

/* Selects at frame pixel (x, y). ETCH_EINVAL for one that no frame has (below 0, or 32767);
 * *select is then not to be used. It must not be moved afterwards: it points to itself. */
enum etch_status etch_select_init(struct etch_select *select, int16_t x, int16_t y,
                                  etch_kernel *kernel);

#endif
