/* tradeoff/main.c: draws every mode over its scenes, on Cortex-M under QEMU and on the host. The
 * plugin counts from bench_counted to bench_done, one figure for each drawing; `hashes` holds a
 * word for each picture, so that the host's, whose errors are known, can be compared. See
 * tradeoff.h. */
#include "../bench/bench.h"
#include "tradeoff.h"

static uint32_t color[TRADEOFF_W * TRADEOFF_H / 2], depth[TRADEOFF_W * TRADEOFF_H / 2];
static uint32_t hash[512];

int main(void);
void bench_counted(const struct etch_surface *s, const struct tradeoff_mode *mode,
                   const struct tradeoff_scene *scene);
void bench_done(void);

__attribute__((noinline)) void bench_done(void)
{
    __asm__ volatile("");
}

__attribute__((noinline)) void bench_counted(const struct etch_surface *s,
                                             const struct tradeoff_mode *mode,
                                             const struct tradeoff_scene *scene)
{
    mode->draw(s, scene);
    bench_done();
}

static uint32_t mixed_wrap(uint32_t h, uint32_t v)
{
    return (h ^ v) * UINT32_C(16777619);
}

int main(void)
{
    const struct etch_rect window = {0, 0, TRADEOFF_W, TRADEOFF_H};
    struct etch_surface s;
    uint32_t n = 0;

    if (etch_surface_init(&s, (uint16_t *)color, window, TRADEOFF_W) != ETCH_OK)
        return 1;
    s.depth = (uint16_t *)depth;
    tradeoff_prepare();
    for (uint8_t m = 0; m < tradeoff_mode_count; m++) {
        for (uint8_t k = 0; k < TRADEOFF_SCENES; k++) {
            if ((tradeoff_modes[m].scenes >> k & 1) == 0)
                continue;
            for (uint32_t i = 0; i < TRADEOFF_W * TRADEOFF_H / 2; i++)
                color[i] = 0, depth[i] = UINT32_MAX;
            bench_counted(&s, &tradeoff_modes[m], &tradeoff_scenes[k]);
            hash[n] = 1;
            for (uint32_t i = 0; i < TRADEOFF_W * TRADEOFF_H / 2; i++)
                hash[n] = mixed_wrap(mixed_wrap(hash[n], color[i]), depth[i]);
            n++;
        }
    }
    bench_write("hashes", hash, n * 4);
    return 0;
}
