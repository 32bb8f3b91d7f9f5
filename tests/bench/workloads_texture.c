/* bench/workloads_texture.c: W12 and W13, the big triangles textured, affine without depth and in
 * perspective with it. See bench.h. */
#include "bench.h"

#include "../../core/draw/texture.h"
#include "../../core/fragment/texture.h"

static wl_tri triangles[WL_NBIG];
static struct etch_texture_vertex vertices[WL_NBIG][3];
static uint16_t texels[WL_TEXN * WL_TEXN];
static struct etch_texture texture;

static void prepare(void)
{
    wl_make_big(triangles);
    wl_make_texture(texels);
    etch_texture_init(&texture, texels, WL_TEXN, WL_TEXN);
    for (int i = 0; i < WL_NBIG; i++)
        for (int k = 0; k < 3; k++) {
            const wl_tri *t = &triangles[i];
            struct etch_texture_vertex *v = &vertices[i][k];

            v->at.x_q8 = t->x[k] * 256 + 128;
            v->at.y_q8 = t->y[k] * 256 + 128;
            v->at.z_q16 = (uint32_t)t->z[k] << 16;
            v->u = (int32_t)t->u[k] << 16;
            v->v = (int32_t)t->v[k] << 16;
            v->w = t->w[k];
        }
}

static void draw_affine(const struct etch_surface *s, uint8_t frame)
{
    (void)frame;
    for (int i = 0; i < WL_NBIG; i++) {
        const struct etch_texture_vertex *const v[3] = {&vertices[i][0], &vertices[i][1],
                                                        &vertices[i][2]};
        etch_triangle_texture(s, v, &texture, etch_kernel_texture);
    }
}

static void draw_perspective(const struct etch_surface *s, uint8_t frame)
{
    (void)frame;
    for (int i = 0; i < WL_NBIG; i++) {
        const struct etch_texture_vertex *const v[3] = {&vertices[i][0], &vertices[i][1],
                                                        &vertices[i][2]};
        etch_triangle_perspective_depth(s, v, &texture, &etch_perspective_less);
    }
}

const struct bench_workload bench_w12 = {1, false, prepare, draw_affine};
const struct bench_workload bench_w13 = {1, true, prepare, draw_perspective};
