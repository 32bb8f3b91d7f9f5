/* bench/main.c: runs one workload; see bench.h. `bench_counted` and `bench_done` are the
 * markers that plugin.c and callgrind look for. */
#include "bench.h"

#include "../../core/draw/shapes.h"

#define NAME_OF(n) bench_w##n
#define WORKLOAD_NAME(n) NAME_OF(n)
#define THE_WORKLOAD WORKLOAD_NAME(WORKLOAD)

static uint32_t color[WL_W * WL_H / 2], depth[WL_W * WL_H / 2]; /* words: aligned */

int main(void);
void bench_counted(const struct etch_surface *s, uint8_t frame);
void bench_done(void);

__attribute__((noinline)) void bench_done(void)
{
    __asm__ volatile("");
}

__attribute__((noinline)) void bench_counted(const struct etch_surface *s, uint8_t frame)
{
    THE_WORKLOAD.draw(s, frame);
    bench_done();
}

int main(void)
{
    const struct etch_rect window = {0, 0, WL_W, WL_H};
    char color_name[] = "frame0.565", depth_name[] = "frame0.z16";
    struct etch_surface s;

    if (etch_surface_init(&s, (uint16_t *)color, window, WL_W) != ETCH_OK)
        return 1;
    if (THE_WORKLOAD.depth)
        s.depth = (uint16_t *)depth;
    THE_WORKLOAD.prepare();
    for (uint8_t frame = 0; frame < THE_WORKLOAD.frames; frame++) {
        for (int i = 0; i < WL_W * WL_H / 2; i++) {
            color[i] = 0;
            depth[i] = 0xFFFFFFFF;
        }
        bench_counted(&s, frame);
        color_name[5] = depth_name[5] = (char)('0' + frame);
        bench_write(color_name, color, sizeof color);
        if (THE_WORKLOAD.depth)
            bench_write(depth_name, depth, sizeof depth);
    }
    return 0;
}
