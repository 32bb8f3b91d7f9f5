/* frame/shared_sink.c: the sink that paints samples. Called by the vertex stage, once a visible
 * triangle. See shared.h. */
#include "shared.h"

static void paint(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    /* sink is the first member, so it has the address of the whole */
    const struct etch_shared_sink *whole = (const struct etch_shared_sink *)(const void *)sink;

    whole->painter(whole->samples, v);
}

void etch_shared_sink_init(struct etch_shared_sink *sink, const struct etch_shared_samples *samples,
                           etch_shared_painter *painter)
{
    sink->sink = (struct etch_sink){.triangle = paint};
    sink->samples = samples;
    sink->painter = painter;
}
