/* draw/triangle_fill.c: triangles in one colour, the 2D calls. Called by applications. See
 * shapes.h and triangle.h. */
#include "../fragment/flat.h"
#include "../raster/triangle.h"
#include "shapes.h"
#include "triangle.h"

static void fill(const struct etch_surface *s, const struct etch_point_q8 v[3], uint16_t color)
{
    const struct etch_flat_paint paint = {{etch_kernel_flat}, color};
    struct etch_triangle t;

    if (etch_triangle_setup(&t, v))
        etch_triangle_runs(s, &t, &paint.paint);
}

/* The centre of pixel column or row i. */
static int32_t centre_q8(int16_t i)
{
    return (int32_t)i * 256 + 128;
}

void etch_triangle_fill(const struct etch_surface *s, int16_t x0, int16_t y0, int16_t x1,
                        int16_t y1, int16_t x2, int16_t y2, uint16_t color)
{
    const struct etch_point_q8 v[3] = {{centre_q8(x0), centre_q8(y0)},
                                       {centre_q8(x1), centre_q8(y1)},
                                       {centre_q8(x2), centre_q8(y2)}};

    fill(s, v, color);
}

void etch_triangle_fill_q16(const struct etch_surface *s, const struct etch_point_q16 v[3],
                            uint16_t color)
{
    struct etch_point_q8 snapped[3];

    for (uint8_t i = 0; i < 3; i++) {
        snapped[i].x = etch_snap_q8(v[i].x);
        snapped[i].y = etch_snap_q8(v[i].y);
    }
    fill(s, snapped, color);
}
