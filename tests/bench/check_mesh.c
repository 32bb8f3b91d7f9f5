/* bench/check_mesh.c: W15. The triangles that the vertex stage hands on are recorded, compared
 * with a projection of their own in double, and then drawn by the oracle. See check.h. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "../../core/base/sink.h"
#include "bench.h"
#include "check.h"

/* What the vertex stage may be off: position in px (1/512 is rounding), depth in units. */
#define POSITION_BOUND (1.0 / 256)
#define DEPTH_BOUND 1.0

struct recorder {
    struct etch_sink sink;
    struct check_vertex triangle[WL_TORUS_NT][3];
    int n;
};

struct point {
    double x, y, z;
    uint16_t color;
};

static void record(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    struct recorder *r = (struct recorder *)sink;

    for (int i = 0; i < 3; i++) {
        const struct check_vertex c = {
            v[i]->x_q8, v[i]->y_q8, v[i]->z_q16, {v[i]->r, v[i]->g, v[i]->b}};
        r->triangle[r->n][i] = c;
    }
    r->n++;
}

/* As workloads.h says it, moved half a pixel right and down to etch's pixel centres. */
static struct point project(const wl_vert *v, const int32_t m[9])
{
    const double x = (m[0] * v->x + m[1] * v->y + m[2] * v->z) / 16384.0;
    const double y = (m[3] * v->x + m[4] * v->y + m[5] * v->z) / 16384.0;
    const double w = WL_CAM_DIST - (m[6] * v->x + m[7] * v->y + m[8] * v->z) / 16384.0;
    const double n = WL_NEAR, f = WL_FAR;
    const struct point p = {WL_W / 2 + 0.5 + WL_FOCAL * x / w, WL_H / 2 + 0.5 - WL_FOCAL * y / w,
                            65535 * f * (w - n) / (w * (f - n)), v->c};
    return p;
}

static bool is_at(const struct check_vertex *v, const struct point *p)
{
    return fabs(v->x_q8 / 256.0 - p->x) <= POSITION_BOUND &&
           fabs(v->y_q8 / 256.0 - p->y) <= POSITION_BOUND &&
           fabs(v->z_q16 / 65536.0 - p->z) <= DEPTH_BOUND && v->channel[0] == wl_r8(p->color) &&
           v->channel[1] == wl_g8(p->color) && v->channel[2] == wl_b8(p->color);
}

/* The recorded triangles are the front faces in order, none missing, none too many. */
static bool is_torus(const struct recorder *r, uint8_t frame)
{
    static wl_vert vertices[WL_TORUS_NV];
    static wl_face faces[WL_TORUS_NT];
    int32_t m[9];
    int n = 0;

    wl_make_torus(vertices, faces);
    wl_frame_matrix(frame, m);
    for (int i = 0; i < WL_TORUS_NT; i++) {
        const struct point a = project(&vertices[faces[i].v[0]], m);
        const struct point b = project(&vertices[faces[i].v[1]], m);
        const struct point c = project(&vertices[faces[i].v[2]], m);
        const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
        if (n < r->n && is_at(&r->triangle[n][0], &a) && is_at(&r->triangle[n][1], &b) &&
            is_at(&r->triangle[n][2], &c))
            n++;
        else if (area < -0.5) /* counter-clockwise as seen, and more than rounding turns over */
            return fprintf(stderr, "W15: face %d is missing or misplaced\n", i), false;
    }
    return n == r->n || (fprintf(stderr, "W15: triangle %d is not one of the torus\n", n), false);
}

bool check_torus(struct check *c, uint8_t frame)
{
    static struct recorder r;

    bench_w15.prepare();
    r.n = 0;
    r.sink.triangle = record;
    bench_torus_draw(frame, &r.sink);
    if (!is_torus(&r, frame))
        return false;
    c->primitives += (uint32_t)r.n;
    for (int pass = 1; pass <= 2; pass++)
        for (int i = 0; i < r.n; i++)
            check_triangle(c, r.triangle[i], NULL, pass);
    return true;
}
