/* tests/harness: the kernel that checks what the raster stage hands over. See canvas.h. */
#include "canvas.h"

struct test_run_paint test_run_paint(struct test_run_log *log, uint16_t color)
{
    const struct test_run_paint p = {{test_kernel_checked}, color, false, log};
    const struct test_run_log fresh = {INT32_MIN, 0, 0, false, 1};

    *log = fresh;
    return p;
}

static uint32_t mix_wrap(uint32_t hash, uint32_t v)
{
    hash = (hash ^ v) * UINT32_C(0x01000193);
    return hash ^ hash >> 15;
}

static void check_run(const struct etch_surface *s, int16_t y, struct etch_run run,
                      const struct test_run_paint *p)
{
    uint16_t *row;
    int32_t i;

    if (run.x1 < run.x0)
        p->log->broken = true;
    if (run.x1 <= run.x0)
        return;
    if (y < s->clip.y0 || y >= s->clip.y1 || run.x0 < s->clip.x0 || run.x1 > s->clip.x1) {
        p->log->broken = true;
        return;
    }
    p->log->hash = mix_wrap(p->log->hash, (uint32_t)(int32_t)y);
    p->log->hash = mix_wrap(p->log->hash, (uint32_t)(uint16_t)run.x0 << 16 | (uint16_t)run.x1);
    p->log->pixels += run.x1 - run.x0;
    row = s->pixels + etch_surface_index(s, run.x0, y);
    for (i = 0; i < run.x1 - run.x0; i++) {
        if (p->count)
            row[i] = (uint16_t)(row[i] + p->color);
        else if (row[i] != TEST_BACKGROUND)
            p->log->broken = true;
        else
            row[i] = p->color;
    }
}

void test_kernel_checked(const struct etch_surface *s, int16_t y0, const struct etch_run *runs,
                         uint8_t n, const struct etch_paint *paint)
{
    const struct test_run_paint *p = (const struct test_run_paint *)paint;
    uint8_t i;

    if (n < 1 || n > ETCH_RUN_BLOCK || y0 < p->log->next_row)
        p->log->broken = true;
    for (i = 0; i < n; i++)
        check_run(s, (int16_t)(y0 + i), runs[i], p);
    p->log->next_row = (int32_t)y0 + n;
    p->log->blocks++;
}
