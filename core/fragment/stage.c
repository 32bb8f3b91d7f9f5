/* fragment/stage.c: runs to chunks to stages. Called by the raster stage through a paint that
 * draw/staged.c sets up. See stage.h. */
#include "stage.h"

static void run_stages(struct etch_chunk *c, const struct etch_stage *stage)
{
    for (; stage->run != NULL && (c->alive | c->stencilled) != 0; stage++)
        stage->run(c, stage->data);
}

static void run_row(struct etch_chunk *c, struct etch_run run, const struct etch_stage *stages)
{
    uint16_t left = (uint16_t)(run.x1 - run.x0); /* 0 <= x0 <= x1 <= 32767 */

    if (left == 0)
        return;
    c->first = etch_surface_index(c->surface, run.x0, c->y);
    c->x = run.x0;
    do {
        const uint16_t block = (uint16_t)(ETCH_CHUNK - (c->x & (ETCH_CHUNK - 1)));

        c->n = left < block ? left : block;
        c->alive = (uint16_t)((UINT32_C(1) << c->n) - 1);
        c->stencilled = 0;
        run_stages(c, stages);
        left = (uint16_t)(left - c->n);
        c->first += c->n;
        c->x = (int16_t)(c->x + (int16_t)c->n);
    } while (left != 0);
}

void etch_kernel_staged(const struct etch_surface *surface, int16_t y0, const struct etch_run *runs,
                        uint8_t n, const struct etch_paint *paint)
{
    const struct etch_stage *const stages = ((const struct etch_staged_paint *)paint)->stages;
    struct etch_chunk c;

    c.surface = surface;
    c.paint = paint;
    for (uint8_t i = 0; i < n; i++) {
        c.y = (int16_t)(y0 + i);
        run_row(&c, runs[i], stages);
    }
}
