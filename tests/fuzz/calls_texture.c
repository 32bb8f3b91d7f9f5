/* tests/fuzz: textured triangles, affine and in perspective; filters, exchanges and moves of whole
 * surfaces are in calls_frame.c, images in calls_image.c. */
#include "calls.h"

#include "core/draw/texture_small.h"
#include "core/fragment/texture_small.h"

typedef const struct etch_texture_vertex *const vertices[3];

/* A texture of 1 x 1 to 16 x 16 texels. */
static struct etch_texture texture(struct fuzz_calls *c)
{
    const uint16_t width = (uint16_t)(1 << fuzz_byte(c) % 5),
                   height = (uint16_t)(1 << fuzz_byte(c) % 5);
    const size_t size = (size_t)width * height;
    uint16_t *texels = fuzz_memory(size * sizeof *texels);
    struct etch_texture t;

    for (size_t i = 0; i < size; i++) {
        texels[i] = (uint16_t)(i * 257);
    }
    if (etch_texture_init(&t, texels, width, height) != ETCH_OK) {
        fuzz_fail("a texture is refused");
    }
    return t;
}

static struct etch_texture_vertex vertex(struct fuzz_calls *c)
{
    const struct etch_vertex at = fuzz_vertex(c);
    const int32_t u = fuzz_s32(c), v = fuzz_s32(c);
    const uint8_t near = fuzz_byte(c);
    const uint32_t w = near < 64    ? 1
                       : near < 96  ? 65535
                       : near < 112 ? UINT32_MAX
                       : near < 120 ? 0
                       : near < 200 ? near
                                    : fuzz_long(c);

    return (struct etch_texture_vertex){at, u, v, w};
}

static void affine(struct fuzz_calls *c, fuzz_function *f)
{
    static etch_kernel *const kernels[] = {etch_kernel_texture_less, etch_kernel_texture_lequal};
    const struct etch_texture t = texture(c);
    const struct etch_texture_vertex v[3] = {vertex(c), vertex(c), vertex(c)};
    const vertices p = {&v[0], &v[1], &v[2]};

    if (f == NULL) {
        etch_triangle_texture(&c->s, p, &t, etch_kernel_texture);
    } else {
        etch_triangle_texture_depth(&c->s, p, &t, kernels[fuzz_byte(c) % 2]);
    }
}

static void perspective(struct fuzz_calls *c, fuzz_function *f)
{
    static const struct etch_perspective_kernels *const without[] = {&etch_perspective,
                                                                     &etch_perspective_exact};
    static const struct etch_perspective_kernels *const with[] = {
        &etch_perspective_less, &etch_perspective_lequal, &etch_perspective_exact_less,
        &etch_perspective_exact_lequal};
    const struct etch_texture t = texture(c);
    const struct etch_texture_vertex v[3] = {vertex(c), vertex(c), vertex(c)};
    const vertices p = {&v[0], &v[1], &v[2]};
    const uint8_t kind = fuzz_byte(c);

    if (f == NULL) {
        etch_triangle_perspective(&c->s, p, &t, without[kind % 2]);
    } else {
        etch_triangle_perspective_depth(&c->s, p, &t, with[kind % 4]);
    }
}

static void perspective_small(struct fuzz_calls *c, fuzz_function *f)
{
    static etch_kernel *const kernels[] = {etch_kernel_perspective_less_small,
                                           etch_kernel_perspective_exact_less};
    const struct etch_texture t = texture(c);
    const struct etch_texture_vertex v[3] = {vertex(c), vertex(c), vertex(c)};
    const vertices p = {&v[0], &v[1], &v[2]};

    (void)f;
    etch_triangle_perspective_depth_small(&c->s, p, &t, kernels[fuzz_byte(c) % 2]);
}

#define ROW(name, call)                                                                            \
    {                                                                                              \
#name, call, (fuzz_function *)name                                                         \
    }

const struct fuzz_row fuzz_texture_rows[] = {
    {"etch_triangle_texture", affine, NULL},
    ROW(etch_triangle_texture_depth, affine),
    {"etch_triangle_perspective", perspective, NULL},
    ROW(etch_triangle_perspective_depth, perspective),
    {"etch_triangle_perspective_depth_small", perspective_small, NULL},
    {NULL, NULL, NULL},
};
