/* tradeoff/scenes.c: the fixed scenes. See tradeoff.h. Integers only: they are the same on every
 * machine. */
#include "../../core/base/sink.h"
#include "../bench/bench.h"
#include "tradeoff.h"

#define MOST 960

static struct etch_texture_vertex near_v[3 * 24], far_v[3 * 12], floor_v[3 * 16], sliver_v[3 * 60],
    mesh_v[3 * MOST], ramp_v[3 * 12], plane_v[3 * 26];
struct tradeoff_scene tradeoff_scenes[TRADEOFF_SCENES];
uint16_t tradeoff_texels[TRADEOFF_TEXTURE * TRADEOFF_TEXTURE];

static uint32_t state;

static uint32_t random_wrap(void)
{
    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    return state;
}

static int32_t range(int32_t least, int32_t most)
{
    return least + (int32_t)(random_wrap() % (uint32_t)(most - least + 1));
}

/* A vertex there, all else at random, one after the other: the order of calls must not be the
 * compiler's. */
static struct etch_texture_vertex vertex(int32_t x_q8, int32_t y_q8)
{
    struct etch_texture_vertex v = {{x_q8, y_q8, 0, 0, 0, 0, 255}, 0, 0, 0};

    v.at.z_q16 = random_wrap() % UINT32_C(0xFFFF0000);
    v.u = range(0, 256 * 65536);
    v.v = range(0, 256 * 65536);
    v.w = (uint32_t)range(65536, 4 * 65536);
    v.at.r = (uint8_t)range(0, 255);
    v.at.g = (uint8_t)range(0, 255);
    v.at.b = (uint8_t)range(0, 255);
    return v;
}

/* A vertex anywhere in a box. */
static struct etch_texture_vertex vertex_in(int32_t x0, int32_t x1, int32_t y0, int32_t y1)
{
    const int32_t x = range(x0, x1), y = range(y0, y1);

    return vertex(x, y);
}

/* Twice the area of the triangle. */
static int64_t area(const struct etch_texture_vertex *v)
{
    return (int64_t)(v[1].at.x_q8 - v[0].at.x_q8) * (v[2].at.y_q8 - v[0].at.y_q8) -
           (int64_t)(v[2].at.x_q8 - v[0].at.x_q8) * (v[1].at.y_q8 - v[0].at.y_q8);
}

/* Triangles in a box, at least `least` px^2. */
static void large(struct etch_texture_vertex *v, int32_t count, int32_t reach, int32_t least)
{
    for (int32_t i = 0; i < count; i++, v += 3) {
        int64_t a;

        do {
            for (int k = 0; k < 3; k++)
                v[k] = vertex_in(-reach, TRADEOFF_W * 256 + reach, -reach,
                                 TRADEOFF_H * 256 + reach);
            a = area(v);
        } while ((a < 0 ? -a : a) >> 17 < least);
    }
}

static void slivers(void)
{
    for (int32_t i = 0; i < 60; i++) {
        struct etch_texture_vertex *v = &sliver_v[3 * i];
        const int32_t thick = 1 << range(0, 8), y = range(10, 230) * 256 + 128;
        const int32_t end = y + range(-1, 1) * 256 * (i % 3) - thick / 3;

        v[0] = vertex_in(0, 10 * 256, y - thick / 2, y - thick / 2);
        v[1] = vertex_in(300 * 256, 319 * 256, end, end);
        v[2] = vertex_in(0, 319 * 256, y + thick, y + thick);
        if (i % 2 != 0) /* along a diagonal */
            v[1].at.y_q8 = v[1].at.x_q8 - v[0].at.x_q8 > 0 ? v[0].at.y_q8 + 128 * range(1, 200) : y,
            v[2].at.x_q8 = (v[0].at.x_q8 + v[1].at.x_q8) / 2,
            v[2].at.y_q8 = (v[0].at.y_q8 + v[1].at.y_q8) / 2 + thick;
    }
}

/* Row k of the floor is w = 2^(k / 2) from the eye (1.5 at halves) and 600 / w px below the
 * horizon. */
static struct etch_texture_vertex floor_corner(int32_t k, int32_t side)
{
    const int32_t w_q8 = k % 2 == 0 ? 256 << k / 2 : 384 << k / 2;
    struct etch_texture_vertex v = vertex(160 * 256 + side * (400 * 65536 / w_q8),
                                          90 * 256 + 150 * 65536 / w_q8);

    v.at.z_q16 = UINT32_C(0xFFFF0000) - (uint32_t)(UINT64_C(0xFFFF0000) * 256 / (uint32_t)w_q8);
    v.u = (side + 1) * 64 * 65536;
    v.v = w_q8 * 256 * 8; /* 8 texels to a unit of distance */
    v.w = (uint32_t)w_q8 * 256;
    return v;
}

static void floor_to_the_horizon(void)
{
    for (int32_t k = 0; k < 8; k++) {
        struct etch_texture_vertex *v = &floor_v[6 * k];
        const struct etch_texture_vertex a = floor_corner(k, -1), b = floor_corner(k, 1);
        const struct etch_texture_vertex c = floor_corner(k + 1, 1), d = floor_corner(k + 1, -1);

        v[0] = a, v[1] = b, v[2] = c, v[3] = a, v[4] = c, v[5] = d;
    }
}

static void ramps(void)
{
    large(ramp_v, 12, 0, 8000);
    for (int32_t i = 0; i < 36; i++) {
        struct etch_vertex *const v = &ramp_v[i].at, *const first = &ramp_v[i / 3 * 3].at;

        v->r = (uint8_t)(first->r / 2 + i % 3);
        v->g = (uint8_t)(first->g / 2 + i % 3 % 2);
        v->b = (uint8_t)(first->b / 2 + 2 * (i % 3));
    }
}

/* Thirteen pairs of triangles over the same pixels, a cell of the screen each: the second is 16
 * units of depth nearer than the first, 8, .. 1/256, from the far end of the range to the near one.
 */
static void planes(void)
{
    for (int32_t i = 0; i < 13; i++) {
        struct etch_texture_vertex *const v = &plane_v[6 * i];
        const int32_t x = i % 4 * 80 * 256, y = i / 4 * 60 * 256;
        const uint32_t at = (uint32_t)(64000 - 4900 * i) << 16, apart = UINT32_C(16 * 65536) >> i;

        v[0] = vertex(x, y);
        v[1] = vertex(x + 79 * 256, y + 20 * 256);
        v[2] = vertex(x + 10 * 256, y + 59 * 256);
        for (int k = 0; k < 3; k++) {
            v[k].at.z_q16 = at + (uint32_t)k * (100 << 16);
            v[3 + k] = v[k];
            v[3 + k].at.z_q16 -= apart;
            v[3 + k].at.g = (uint8_t)~v[k].at.g;
        }
    }
}

static void keep(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    struct etch_texture_vertex *const to = &mesh_v[3 * tradeoff_scenes[4].count];

    (void)sink;
    if (tradeoff_scenes[4].count == MOST)
        return;
    for (int k = 0; k < 3; k++)
        to[k] = (struct etch_texture_vertex){*v[k], 0, 0, 65536};
    tradeoff_scenes[4].count++;
}

/* Firmware has no initialised data. */
static void name_scenes(void)
{
    static const struct tradeoff_scene scenes[TRADEOFF_SCENES] = {
        {"near", near_v, 24},      {"far", far_v, 12},  {"floor", floor_v, 16},
        {"slivers", sliver_v, 60}, {"mesh", mesh_v, 0}, {"ramps", ramp_v, 12},
        {"planes", plane_v, 26}};

    for (int i = 0; i < TRADEOFF_SCENES; i++)
        tradeoff_scenes[i] = scenes[i];
}

void tradeoff_prepare(void)
{
    struct etch_sink recorder = {keep, NULL, NULL};

    name_scenes();

    state = 1;
    large(near_v, 24, 0, 6000);
    large(far_v, 12, 30000 * 256, 1000000);
    floor_to_the_horizon();
    slivers();
    ramps();
    planes();
    bench_w15.prepare();
    bench_torus_draw(0, &recorder);
    for (int32_t i = 0; i < TRADEOFF_TEXTURE * TRADEOFF_TEXTURE; i++)
        tradeoff_texels[i] = (uint16_t)i;
}
