/* tradeoff/error_visible.c: pixels that show another triangle than the nearest. Called by error.c.
 */
#include "error.h"

#include <stdlib.h>

/* A depth as whole + rest / area, exact. */
struct place {
    uint64_t whole, rest, area;
};

static bool is_nearer(struct place a, struct place b)
{
    return a.whole != b.whole ? a.whole < b.whole
                              : (wide128)a.rest * b.area < (wide128)b.rest * a.area;
}

static struct place place_of(const struct error_triangle *t, int x, int y)
{
    const uint32_t z[3] = {t->v[0].at.z_q16, t->v[1].at.z_q16, t->v[2].at.z_q16};
    const wide128 value = error_value(t, x, y, z);

    return (struct place){(uint64_t)(value / t->exact.area), (uint64_t)(value % t->exact.area),
                          (uint64_t)t->exact.area};
}

/* The colour of triangle i, 1 and up, which RGB565 holds exactly. */
static void paint(struct etch_vertex *v, int i)
{
    v->r = (uint8_t)((i >> 6 & 31) * 255 / 31.0 + 0.5);
    v->g = (uint8_t)((i & 63) * 255 / 63.0 + 0.5);
    v->b = 0;
}

/* Whether pixel (x, y) may show triangle `shown`, 1 and up, or none. */
static bool is_right(const struct error_triangle *t, int n, int x, int y, int shown, bool *covered)
{
    struct place nearest = {UINT64_MAX, 0, 1}, mine = {UINT64_MAX, 0, 1};

    *covered = false;
    for (int i = 0; i < n; i++) {
        if (x < t[i].x0 || x >= t[i].x1 || y < t[i].y0 || y >= t[i].y1 ||
            !oracle_triangle_covers(&t[i].exact, x, y))
            continue;
        const struct place at = place_of(&t[i], x, y);

        *covered = true;
        if (is_nearer(at, nearest))
            nearest = at;
        if (i + 1 == shown)
            mine = at;
    }
    return *covered ? !is_nearer(nearest, mine) : shown == 0;
}

void error_visible(const struct tradeoff_mode *mode, const struct tradeoff_scene *scene,
                   const struct etch_surface *s)
{
    struct etch_texture_vertex *const v = malloc(sizeof *v * 3 * scene->count);
    struct error_triangle *const t = malloc(sizeof *t * scene->count);
    const struct tradeoff_scene painted = {scene->name, v, scene->count};

    if (v == NULL || t == NULL)
        exit(1);
    for (int i = 0; i < scene->count; i++) {
        int32_t x[3], y[3];

        for (int k = 0; k < 3; k++) {
            v[3 * i + k] = scene->v[3 * i + k];
            paint(&v[3 * i + k].at, i + 1);
            x[k] = v[3 * i + k].at.x_q8, y[k] = v[3 * i + k].at.y_q8;
        }
        t[i].v = &v[3 * i];
        oracle_triangle_make(&t[i].exact, x, y);
        error_find(&t[i]);
    }
    mode->draw(s, &painted);
    for (int y = 0; y < TRADEOFF_H; y++)
        for (int x = 0; x < TRADEOFF_W; x++) {
            const uint16_t shown = s->pixels[y * TRADEOFF_W + x];
            bool covered;
            const bool right = is_right(t, scene->count, x, y,
                                        (shown >> 11) << 6 | (shown >> 5 & 63), &covered);

            if (covered || !right)
                error_add(right ? 0 : 1);
        }
    free(v);
    free(t);
}
