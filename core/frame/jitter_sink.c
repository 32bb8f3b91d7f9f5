/* frame/jitter_sink.c: moves what the vertex stage emits to where one of several samples sees it.
 * Stands between the vertex stage and the sink that rasterises. See jitter.h. */
#include "jitter.h"

static void move(const struct etch_sink *sink, const struct etch_vertex *const v[],
                 struct etch_vertex *moved, uint8_t n)
{
    /* sink is the first member, so it has the jitter sink's address */
    const struct etch_jitter_sink *jitter = (const struct etch_jitter_sink *)(const void *)sink;

    for (uint8_t i = 0; i < n; i++)
        moved[i] = etch_vertex_jitter(v[i], jitter->offset);
}

static struct etch_sink *next_of(struct etch_sink *sink)
{
    return ((struct etch_jitter_sink *)(void *)sink)->next;
}

static void triangle(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    struct etch_vertex moved[3];
    const struct etch_vertex *const out[3] = {&moved[0], &moved[1], &moved[2]};

    move(sink, v, moved, 3);
    next_of(sink)->triangle(next_of(sink), out);
}

static void line(struct etch_sink *sink, const struct etch_vertex *const v[2])
{
    struct etch_vertex moved[2];
    const struct etch_vertex *const out[2] = {&moved[0], &moved[1]};

    move(sink, v, moved, 2);
    next_of(sink)->line(next_of(sink), out);
}

static void point(struct etch_sink *sink, const struct etch_vertex *v)
{
    struct etch_vertex moved;

    move(sink, &v, &moved, 1);
    next_of(sink)->point(next_of(sink), &moved);
}

void etch_jitter_sink_init(struct etch_jitter_sink *jitter, struct etch_sink *next,
                           struct etch_offset_q8 offset)
{
    jitter->sink = (struct etch_sink){triangle, line, point};
    jitter->next = next;
    jitter->offset = offset;
}
