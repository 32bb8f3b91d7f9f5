/* bench/workloads.h: the deterministic workloads W1..W15 that the bench draws and the peers
 * were measured on. Part of etch, MIT licence (see LICENSE). Kept as it was when the peers
 * were measured: a change here would end the comparison.
 *
 * deterministic raster workloads W1..W15 and a coverage mesh.
 *
 * Plain C99, integers only, no allocation, no libc.  Every list is a pure
 * function of a fixed seed, so two renderers that include this header draw
 * the same primitives.  Target: 320x240, colours RGB565, y down, pixel (x,y)
 * has its centre on the integer point (x,y).
 *
 * Rules that the lists keep:
 *  - no colour channel is ever dark (8-bit value >= 40), so 0x0000 can be used
 *    as "nothing was drawn here";
 *  - all triangles wind the same way: wl_area2() > 0 (clockwise on screen);
 *  - rects, lines and triangles are fully on screen; circles are not.
 */
#ifndef WORKLOADS_H
#define WORKLOADS_H

#include <stdint.h>

#define WL_W 320
#define WL_H 240

#define WL_NRECT 1000
#define WL_NLINE 2000
#define WL_NCIRC 500
#define WL_NSMALL 2000
#define WL_NBIG 100
#define WL_NGLYPH 2000
#define WL_TEXN 64  /* texture is WL_TEXN x WL_TEXN */
#define WL_NFRAME 4 /* frames of the mesh workload */
#define WL_TORUS_A 32
#define WL_TORUS_B 32
#define WL_TORUS_NV (WL_TORUS_A * WL_TORUS_B)
#define WL_TORUS_NT (2 * WL_TORUS_NV)

enum {
    WL_CLEAR = 1,
    WL_RECT,
    WL_LINE,
    WL_CIRCLE,
    WL_DISC,
    WL_SMALL_FLAT,
    WL_BIG_FLAT,
    WL_SMALL_GOURAUD,
    WL_BIG_GOURAUD,
    WL_BIG_FLAT_Z,
    WL_BIG_GOURAUD_Z,
    WL_BIG_TEX,
    WL_BIG_TEXP_Z,
    WL_TEXT,
    WL_MESH
};

typedef struct {
    int16_t x, y, w, h;
    uint16_t c;
} wl_rect;
typedef struct {
    int16_t x0, y0, x1, y1;
    uint16_t c;
} wl_line;
typedef struct {
    int16_t x, y, r;
    uint16_t c;
} wl_circ;
typedef struct {
    int16_t x, y;
    uint16_t c;
    uint8_t ch;
} wl_glyph;
typedef struct {
    int16_t x[3], y[3]; /* screen, pixels */
    uint16_t z[3];      /* 16-bit depth, 0 = near; linear on screen */
    uint16_t c[3];      /* RGB565 per vertex; flat colour is c[0] */
    uint8_t u[3], v[3]; /* texels, 0..WL_TEXN-1 */
    uint16_t w[3];      /* view-space depth for the perspective workload */
} wl_tri;

typedef struct {
    int16_t x, y, z;
    uint16_t c;
} wl_vert;
typedef struct {
    uint16_t v[3];
} wl_face;

/* ---- generator ---------------------------------------------------------- */

static inline uint32_t wl_next(uint32_t *s)
{
    uint32_t x = *s;
    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    return *s = x;
}

/* uniform enough in lo..hi inclusive, for small ranges */
static inline int32_t wl_range(uint32_t *s, int32_t lo, int32_t hi)
{
    uint32_t n = (uint32_t)(hi - lo) + 1u;
    return lo + (int32_t)(((wl_next(s) >> 8) & 0xFFFFu) * n >> 16);
}

static inline uint16_t wl_rgb(int32_t r, int32_t g, int32_t b)
{
    return (uint16_t)(((uint32_t)(r & 0xF8) << 8) | ((uint32_t)(g & 0xFC) << 3) |
                      ((uint32_t)b >> 3));
}

static inline uint16_t wl_color(uint32_t *s)
{
    int32_t r = wl_range(s, 40, 255), g = wl_range(s, 40, 255);
    int32_t b = wl_range(s, 40, 255);
    return wl_rgb(r, g, b);
}

static inline int wl_r8(uint16_t c)
{
    return (c >> 8) & 0xF8;
}
static inline int wl_g8(uint16_t c)
{
    return (c >> 3) & 0xFC;
}
static inline int wl_b8(uint16_t c)
{
    return (c << 3) & 0xF8;
}

/* ---- 2D lists ----------------------------------------------------------- */

static inline void wl_make_rects(wl_rect *o)
{
    uint32_t s = 0x1234567u;
    for (int i = 0; i < WL_NRECT; i++) {
        o[i].w = (int16_t)wl_range(&s, 1, 100);
        o[i].h = (int16_t)wl_range(&s, 1, 80);
        o[i].x = (int16_t)wl_range(&s, 0, WL_W - o[i].w);
        o[i].y = (int16_t)wl_range(&s, 0, WL_H - o[i].h);
        o[i].c = wl_color(&s);
    }
}

static inline void wl_make_lines(wl_line *o)
{
    uint32_t s = 0x2345678u;
    for (int i = 0; i < WL_NLINE; i++) {
        o[i].x0 = (int16_t)wl_range(&s, 0, WL_W - 1);
        o[i].y0 = (int16_t)wl_range(&s, 0, WL_H - 1);
        o[i].x1 = (int16_t)wl_range(&s, 0, WL_W - 1);
        o[i].y1 = (int16_t)wl_range(&s, 0, WL_H - 1);
        o[i].c = wl_color(&s);
    }
}

/* centres on screen, r 1..100, so many are cut by the screen edge */
static inline void wl_make_circles(wl_circ *o)
{
    uint32_t s = 0x3456789u;
    for (int i = 0; i < WL_NCIRC; i++) {
        o[i].x = (int16_t)wl_range(&s, 0, WL_W - 1);
        o[i].y = (int16_t)wl_range(&s, 0, WL_H - 1);
        o[i].r = (int16_t)wl_range(&s, 1, 100);
        o[i].c = wl_color(&s);
    }
}

/* top-left corners such that a 16x16 cell stays on screen; chars '!'..'~' */
static inline void wl_make_glyphs(wl_glyph *o)
{
    uint32_t s = 0x456789Au;
    for (int i = 0; i < WL_NGLYPH; i++) {
        o[i].x = (int16_t)wl_range(&s, 0, WL_W - 16);
        o[i].y = (int16_t)wl_range(&s, 0, WL_H - 20);
        o[i].ch = (uint8_t)wl_range(&s, 33, 126);
        o[i].c = wl_color(&s);
    }
}

/* ---- triangles ---------------------------------------------------------- */

static inline int32_t wl_area2(const int16_t *x, const int16_t *y)
{
    return (int32_t)(x[1] - x[0]) * (y[2] - y[0]) - (int32_t)(x[2] - x[0]) * (y[1] - y[0]);
}

/* twice the area is kept in lo2..hi2; box limits how far apart vertices are */
static inline void wl_make_tris(wl_tri *o, int n, uint32_t s, int bw, int bh, int32_t lo2,
                                int32_t hi2)
{
    for (int i = 0; i < n;) {
        wl_tri *t = &o[i];
        int ox = (int)wl_range(&s, 0, WL_W - bw);
        int oy = (int)wl_range(&s, 0, WL_H - bh);
        for (int k = 0; k < 3; k++) {
            t->x[k] = (int16_t)(ox + wl_range(&s, 0, bw - 1));
            t->y[k] = (int16_t)(oy + wl_range(&s, 0, bh - 1));
        }
        int32_t a = wl_area2(t->x, t->y);
        if (a < 0) {
            int16_t q = t->x[1];
            t->x[1] = t->x[2];
            t->x[2] = q;
            q = t->y[1];
            t->y[1] = t->y[2];
            t->y[2] = q;
            a = -a;
        }
        if (a < lo2 || a > hi2)
            continue;
        int32_t wbase = wl_range(&s, 256, 1023);
        for (int k = 0; k < 3; k++) {
            t->z[k] = (uint16_t)wl_range(&s, 1000, 64000);
            t->c[k] = wl_color(&s);
            t->u[k] = (uint8_t)wl_range(&s, 0, WL_TEXN - 1);
            t->v[k] = (uint8_t)wl_range(&s, 0, WL_TEXN - 1);
            t->w[k] = (uint16_t)(wbase + wl_range(&s, 0, wbase));
        }
        i++;
    }
}

/* about 50 pixels each */
static inline void wl_make_small(wl_tri *o)
{
    wl_make_tris(o, WL_NSMALL, 0x56789ABu, 20, 20, 80, 120);
}

/* 5000 pixels or more each */
static inline void wl_make_big(wl_tri *o)
{
    wl_make_tris(o, WL_NBIG, 0x6789ABCu, WL_W, WL_H, 10000, 70000);
}

/* xor pattern, never dark */
static inline void wl_make_texture(uint16_t *t)
{
    for (int y = 0; y < WL_TEXN; y++)
        for (int x = 0; x < WL_TEXN; x++)
            t[y * WL_TEXN + x] = wl_rgb(48 + x * 3, 48 + y * 3, 48 + ((x ^ y) & 63) * 3);
}

/* ---- mesh --------------------------------------------------------------- */

/* sine, 1024 steps a turn, result Q14; odd 5th-order fit, max error < 0.0005 */
static inline int32_t wl_sin(int32_t a)
{
    a &= 1023;
    int neg = a >= 512;
    a &= 511;
    if (a > 256)
        a = 512 - a;
    int32_t z = a << 6, z2 = z * z >> 14;
    /* (pi/2) z - (pi - 5/2) z^3 + (pi/2 - 3/2) z^5, coefficients Q14 */
    int32_t p = 10512 - (1160 * z2 >> 14);
    p = 25736 - (p * z2 >> 14);
    p = p * z >> 14;
    return neg ? -p : p;
}
static inline int32_t wl_cos(int32_t a)
{
    return wl_sin(a + 256);
}

#define WL_TORUS_R 1000 /* object units */
#define WL_TORUS_r 400
#define WL_CAM_DIST 3500 /* camera to object centre, object units */
#define WL_FOCAL 240     /* pixels */
#define WL_NEAR 500
#define WL_FAR 8000

/* Right-handed object space; faces counter-clockwise seen from outside. */
static inline void wl_make_torus(wl_vert *v, wl_face *f)
{
    for (int i = 0; i < WL_TORUS_A; i++)
        for (int j = 0; j < WL_TORUS_B; j++) {
            int32_t ca = wl_cos(i * 32), sa = wl_sin(i * 32);
            int32_t cb = wl_cos(j * 32), sb = wl_sin(j * 32);
            int32_t d = WL_TORUS_R + (WL_TORUS_r * cb >> 14);
            wl_vert *p = &v[i * WL_TORUS_B + j];
            p->x = (int16_t)(d * ca >> 14);
            p->y = (int16_t)(d * sa >> 14);
            p->z = (int16_t)(WL_TORUS_r * sb >> 14);
            int32_t nx = cb * ca >> 14, ny = cb * sa >> 14;
            p->c = wl_rgb(147 + (nx * 100 >> 14), 147 + (ny * 100 >> 14), 147 + (sb * 100 >> 14));
        }
    for (int i = 0; i < WL_TORUS_A; i++)
        for (int j = 0; j < WL_TORUS_B; j++) {
            int i1 = (i + 1) % WL_TORUS_A, j1 = (j + 1) % WL_TORUS_B;
            uint16_t a = (uint16_t)(i * WL_TORUS_B + j);
            uint16_t b = (uint16_t)(i1 * WL_TORUS_B + j);
            uint16_t c = (uint16_t)(i1 * WL_TORUS_B + j1);
            uint16_t d = (uint16_t)(i * WL_TORUS_B + j1);
            wl_face *q = &f[2 * (i * WL_TORUS_B + j)];
            q[0].v[0] = a;
            q[0].v[1] = b;
            q[0].v[2] = c;
            q[1].v[0] = a;
            q[1].v[1] = c;
            q[1].v[2] = d;
        }
}

/* rotation of frame k, row-major, Q14; view space is x right, y up,
 * z towards the viewer, the object centre at z = -WL_CAM_DIST.
 * screen x = WL_W/2 + F*X/-Z, screen y = WL_H/2 - F*Y/-Z */
static inline void wl_frame_matrix(int k, int32_t m[9])
{
    int32_t cx = wl_cos(120 + 70 * k), sx = wl_sin(120 + 70 * k);
    int32_t cy = wl_cos(40 + 90 * k), sy = wl_sin(40 + 90 * k);
    m[0] = cy;
    m[1] = 0;
    m[2] = sy;
    m[3] = sx * sy >> 14;
    m[4] = cx;
    m[5] = -(sx * cy >> 14);
    m[6] = -(cx * sy >> 14);
    m[7] = sx;
    m[8] = cx * cy >> 14;
}

/* ---- coverage mesh ------------------------------------------------------ */

/* A WL_COVN x WL_COVN grid of cells with jittered inner vertices, its outer
 * edge a straight rectangle from WL_COVX to WL_COVX + WL_COVN*WL_COVC in x and
 * the same in y.  Every pixel strictly inside the rectangle belongs to
 * exactly one triangle under any consistent fill rule. */
#define WL_COVN 4
#define WL_COVC 16
#define WL_COVX 8
#define WL_COVNT (2 * WL_COVN * WL_COVN)
#define WL_COVMESHES 2000

static inline void wl_make_cover_mesh(uint32_t *s, wl_tri *o)
{
    int16_t px[WL_COVN + 1][WL_COVN + 1], py[WL_COVN + 1][WL_COVN + 1];
    for (;;) {
        int n = 0, ok = 1;
        uint32_t diag = wl_next(s);
        for (int i = 0; i <= WL_COVN; i++)
            for (int j = 0; j <= WL_COVN; j++) {
                int jx = (int)wl_range(s, -7, 7), jy = (int)wl_range(s, -7, 7);
                if (j == 0 || j == WL_COVN)
                    jx = 0;
                if (i == 0 || i == WL_COVN)
                    jy = 0;
                px[i][j] = (int16_t)(WL_COVX + j * WL_COVC + jx);
                py[i][j] = (int16_t)(WL_COVX + i * WL_COVC + jy);
            }
        for (int i = 0; i < WL_COVN; i++)
            for (int j = 0; j < WL_COVN; j++) {
                static const uint8_t q[2][6] = {{0, 1, 3, 0, 3, 2}, {0, 1, 2, 1, 3, 2}};
                const uint8_t *d = q[diag >> (i * WL_COVN + j) & 1];
                for (int t = 0; t < 2; t++, n++) {
                    for (int k = 0; k < 3; k++) {
                        int c = d[t * 3 + k];
                        o[n].x[k] = px[i + (c >> 1)][j + (c & 1)];
                        o[n].y[k] = py[i + (c >> 1)][j + (c & 1)];
                        o[n].z[k] = 32000;
                        o[n].c[k] = 0xFFFF;
                        o[n].u[k] = 0;
                        o[n].v[k] = 0;
                        o[n].w[k] = 512;
                    }
                    if (wl_area2(o[n].x, o[n].y) <= 0)
                        ok = 0;
                }
            }
        if (ok)
            return;
    }
}

#endif
