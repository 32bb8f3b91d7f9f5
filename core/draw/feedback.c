/* draw/feedback.c: a sink that stores. Called by the vertex stage, once a visible primitive. See
 * feedback.h. */
#include "feedback.h"

static void keep(struct etch_sink *sink, const struct etch_vertex *const *v, uint8_t size)
{
    struct etch_feedback *const f = (void *)sink;

    if (f->count < f->room) {
        struct etch_feedback_primitive *const p = &f->primitive[f->count];

        p->size = size;
        for (uint8_t i = 0; i < size; i++)
            p->v[i] = *v[i];
    }
    if (f->count < UINT32_MAX)
        f->count++;
}

static void keep_triangle(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    keep(sink, v, 3);
}

static void keep_line(struct etch_sink *sink, const struct etch_vertex *const v[2])
{
    keep(sink, v, 2);
}

static void keep_point(struct etch_sink *sink, const struct etch_vertex *v)
{
    keep(sink, &v, 1);
}

void etch_feedback_init(struct etch_feedback *f, struct etch_feedback_primitive *primitive,
                        uint32_t room)
{
    f->sink = (struct etch_sink){keep_triangle, keep_line, keep_point};
    f->primitive = primitive;
    f->room = room;
    f->count = 0;
}

enum etch_status etch_feedback_status(const struct etch_feedback *f)
{
    return f->count > f->room ? ETCH_ENOMEM : ETCH_OK;
}
