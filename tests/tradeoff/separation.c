/* tradeoff/separation.c: how far apart two walls must be to be told apart, for near : far of three
 * scenes and distances from near to far; on the host. Writes distance,ratio,linear,inverse, the
 * separations as shares of the distance. Walls face the eye, so their depth is one number, and a
 * layout tells a pair apart if the nearer wall's depth is less, here and at 36 places up to twice
 * as far. */
#include <math.h>
#include <stdio.h>

#include "../../core/draw/inverse.h"
#include "../../core/fragment/flat.h"
#include "tradeoff.h"

#define FAR_Q16 4294901760.0

static uint16_t color[64], depth[64];

/* The depth at a pixel of a wall w times as far as near. */
static uint16_t depth_of(double w, double far, etch_triangle_painter *painter, etch_kernel *kernel)
{
    const double z = FAR_Q16 * (1 - 1 / w) / (1 - 1 / far);
    const uint32_t z_q16 = z >= FAR_Q16 ? UINT32_C(0xFFFF0000) : (uint32_t)(z + 0.5);
    const struct etch_vertex v[3] = {
        {0, 0, z_q16, 0, 0, 0, 0}, {4096, 0, z_q16, 0, 0, 0, 0}, {0, 4096, z_q16, 0, 0, 0, 0}};
    const struct etch_vertex *const corners[3] = {&v[0], &v[1], &v[2]};
    const struct etch_rect window = {0, 0, 8, 8};
    struct etch_surface s;

    (void)etch_surface_init(&s, color, window, 8);
    s.depth = depth;
    depth[0] = UINT16_MAX;
    painter(&s, corners, kernel);
    return depth[0];
}

/* The smallest separation, by steps of 2 %; 0 if none below 1 will do. */
static double separation(double w, double far, etch_triangle_painter *painter, etch_kernel *kernel)
{
    for (double apart = 1.0 / 65536; apart < 1; apart *= 1.02) {
        bool told = true;

        for (int i = 0; told && i < 37; i++) {
            const double from = w * (1 + i / 37.0), to = from * (1 + apart);

            if (to < far)
                told = depth_of(from, far, painter, kernel) < depth_of(to, far, painter, kernel);
        }
        if (told)
            return apart;
    }
    return 0;
}

int main(void)
{
    static const double ratios[3] = {100, 1000, 65535};

    for (int r = 0; r < 3; r++)
        for (double w = 1; w * 2 <= ratios[r] * 1.3; w *= 4)
            printf("%g,%g,%.3g,%.3g\n", ratios[r], w,
                   separation(w, ratios[r], etch_triangle_flat_depth, etch_kernel_flat_less),
                   separation(w, ratios[r], etch_triangle_flat_inverse,
                              etch_kernel_flat_inverse_less));
    return 0;
}
