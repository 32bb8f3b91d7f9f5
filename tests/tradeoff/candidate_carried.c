/* tradeoff/candidate_carried.c: exact colours by quotient and remainder at every pixel. See
 * candidates.h. A channel is N / (510 D) as whole + rest / (510 D); both step, and rest carries
 * into whole. */
#include "../../core/draw/setup_exact.h"
#include "candidates.h"

struct carried {
    uint64_t rest, step_rest;
    uint32_t whole, step;
};

struct carried_paint {
    struct etch_gouraud_exact_paint exact;
    struct carried r, g, b;
    uint64_t unit;
};

static void set_step_wrap(struct carried *c, const struct etch_exact_plane *p, uint64_t unit)
{
    const int64_t n = (int64_t)p->dx;
    const struct etch_quotient q = etch_divide_u64(n < 0 ? -(uint64_t)n : (uint64_t)n, unit);

    c->step = (uint32_t)q.quotient;
    c->step_rest = q.remainder;
    if (n < 0) {
        c->step = -c->step;
        if (c->step_rest != 0)
            c->step--, c->step_rest = unit - c->step_rest;
    }
}

static void start_wrap(struct carried *c, const struct etch_exact_plane *p, uint64_t unit,
                       int16_t x, int16_t y)
{
    const struct etch_quotient q = etch_divide_u64(
        p->origin + p->dx * (uint16_t)x + p->dy * (uint16_t)y, unit);

    c->whole = (uint32_t)q.quotient;
    c->rest = q.remainder;
}

static void step_wrap(struct carried *c, uint64_t unit)
{
    c->whole += c->step;
    c->rest += c->step_rest;
    if (c->rest >= unit)
        c->rest -= unit, c->whole++;
}

static void kernel(const struct etch_surface *s, int16_t y0, const struct etch_run *runs, uint8_t n,
                   const struct etch_paint *paint)
{
    const struct carried_paint *const p = (const struct carried_paint *)paint;

    for (; n != 0; n--, runs++, y0++) {
        struct carried r = p->r, g = p->g, b = p->b;
        uint16_t *pixel = s->pixels + etch_surface_index(s, runs->x0, y0);

        if (runs->x0 == runs->x1)
            continue;
        start_wrap(&r, &p->exact.r, p->unit, runs->x0, y0);
        start_wrap(&g, &p->exact.g, p->unit, runs->x0, y0);
        start_wrap(&b, &p->exact.b, p->unit, runs->x0, y0);
        for (int32_t left = runs->x1 - runs->x0; left != 0; left--) {
            *pixel++ = (uint16_t)(r.whole << 11 | g.whole << 5 | b.whole);
            step_wrap(&r, p->unit);
            step_wrap(&g, p->unit);
            step_wrap(&b, p->unit);
        }
    }
}

void candidate_triangle_carried(const struct etch_surface *s, const struct etch_vertex *const v[3],
                                etch_kernel *unused)
{
    struct carried_paint paint;
    struct etch_triangle t;

    (void)unused;
    if (!setup_visible(&t, s, v))
        return;
    etch_setup_exact_color(&paint.exact, &t, v);
    paint.exact.gouraud.paint.kernel = kernel;
    paint.unit = t.area * 510;
    set_step_wrap(&paint.r, &paint.exact.r, paint.unit);
    set_step_wrap(&paint.g, &paint.exact.g, paint.unit);
    set_step_wrap(&paint.b, &paint.exact.b, paint.unit);
    etch_triangle_runs(s, &t, &paint.exact.gouraud.paint);
}
