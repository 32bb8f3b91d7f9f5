/* tests/oracle: textures by their definition. See sampler.h. */
#include "sampler.h"

int32_t oracle_wrapped(enum oracle_wrap wrap, int32_t k, int32_t size)
{
    const int32_t period = wrap == ORACLE_MIRROR ? 2 * size : size;
    const int32_t in = k % period < 0 ? k % period + period : k % period;

    if (wrap == ORACLE_CLAMP)
        return k < 0 ? 0 : k < size ? k : size - 1;
    return in < size ? in : period - 1 - in;
}

static void at(const struct oracle_sampler *s, int64_t x, int64_t y, uint8_t channel[4])
{
    s->texel(oracle_wrapped(s->wrap_u, (int32_t)x, s->width),
             oracle_wrapped(s->wrap_v, (int32_t)y, s->height), channel);
}

/* floor(c / 65536) */
static int64_t whole(int64_t c)
{
    int64_t k = c / 65536;

    return k * 65536 > c ? k - 1 : k;
}

void oracle_nearest(const struct oracle_sampler *s, int32_t u, int32_t v, uint8_t channel[4])
{
    at(s, whole(u), whole(v), channel);
}

void oracle_linear(const struct oracle_sampler *s, int32_t u, int32_t v, uint64_t mean_q32[4],
                   uint8_t spread[4])
{
    const int64_t x = whole((int64_t)u - 32768), y = whole((int64_t)v - 32768);
    const uint64_t right = (uint64_t)((int64_t)u - 32768 - x * 65536);
    const uint64_t below = (uint64_t)((int64_t)v - 32768 - y * 65536);
    const uint64_t weight[4] = {(65536 - right) * (65536 - below), right * (65536 - below),
                                (65536 - right) * below, right * below};
    uint8_t texel[4][4];
    int i, k;

    for (i = 0; i < 4; i++)
        at(s, x + i % 2, y + i / 2, texel[i]);
    for (k = 0; k < 4; k++) {
        uint8_t least = 255, most = 0;

        mean_q32[k] = 0;
        for (i = 0; i < 4; i++) {
            mean_q32[k] += weight[i] * texel[i][k];
            least = texel[i][k] < least ? texel[i][k] : least;
            most = texel[i][k] > most ? texel[i][k] : most;
        }
        spread[k] = (uint8_t)(most - least);
    }
}
