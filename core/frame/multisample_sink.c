/* frame/multisample_sink.c: the sink that paints samples. Called by the vertex stage, once a
 * visible triangle. See multisample.h. */
#include "multisample.h"

static void paint(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    /* sink is the first member, so it has the address of the whole */
    const struct etch_multisample_sink *whole = (const struct etch_multisample_sink *)(const void *)
        sink;

    whole->painter(whole->samples, v);
}

void etch_multisample_sink_init(struct etch_multisample_sink *sink,
                                const struct etch_multisample *samples,
                                etch_multisample_painter *painter)
{
    sink->sink = (struct etch_sink){.triangle = paint};
    sink->samples = samples;
    sink->painter = painter;
}
