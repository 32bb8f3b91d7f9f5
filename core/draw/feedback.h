/* draw/feedback.h: transformed, clipped, culled primitives given back instead of drawn.
 *
 *      etch_feedback_init(&feedback, buffer, room);
 *      assembly.sink = &feedback.sink;
 *      etch_mesh_draw(&stage, &assembly, ..);
 *      if (etch_feedback_status(&feedback) == ETCH_ENOMEM) .. feedback.count would be needed
 */
#ifndef ETCH_DRAW_FEEDBACK_H
#define ETCH_DRAW_FEEDBACK_H

#include "../base/sink.h"

/* A primitive as a sink gets it, 1 vertex a point, 2 a line, 3 a triangle. Of wider vertices only
 * what an etch_vertex holds is kept. */
struct etch_feedback_primitive {
    struct etch_vertex v[3];
    uint8_t size;
};

struct etch_feedback {
    struct etch_sink sink;                     /* takes points, lines and triangles */
    struct etch_feedback_primitive *primitive; /* the caller's, in the order of their drawing */
    uint32_t room;
    uint32_t count; /* of primitives that came; those beyond `room` are counted, not kept */
};

/* Empties *f over the caller's buffer. room = 0 only counts; then primitive may be NULL. */
void etch_feedback_init(struct etch_feedback *f, struct etch_feedback_primitive *primitive,
                        uint32_t room);

/* ETCH_OK, or ETCH_ENOMEM if more came than there was room for. */
enum etch_status etch_feedback_status(const struct etch_feedback *f);

#endif
