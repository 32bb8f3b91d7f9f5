/* base/clip_stack.h: clips inside clips, held by the caller.
 *
 *      struct etch_rect saved[4];
 *      struct etch_clip_stack stack;
 *
 *      etch_clip_stack_init(&stack, saved, 4);
 *      etch_clip_push(&surface, &stack, panel);    the clip is its part inside panel
 *      .. draw ..
 *      etch_clip_pop(&surface, &stack);            the clip is what it was
 *
 * On strips push and pop are drawing calls like others: the same ones for every strip.
 */
#ifndef ETCH_BASE_CLIP_STACK_H
#define ETCH_BASE_CLIP_STACK_H

#include "surface.h"

struct etch_clip_stack {
    struct etch_rect *saved; /* the caller's */
    uint16_t room, depth;    /* of `saved`, and how many are in use */
    uint16_t lost;           /* pushes without room that wait for their pop */
};

void etch_clip_stack_init(struct etch_clip_stack *stack, struct etch_rect *saved, uint16_t room);

/* Keeps the clip and narrows it to its part inside `clip`, whatever that is. ETCH_ENOMEM without
 * room: the clip then stays as it is, and so it does at the pop of this push, so that pairs stay
 * pairs (up to 65535 lost ones; more are not counted). */
enum etch_status etch_clip_push(struct etch_surface *s, struct etch_clip_stack *stack,
                                struct etch_rect clip);

/* The clip before the latest push that has not been popped. ETCH_EINVAL if there is none; nothing
 * is changed then. */
enum etch_status etch_clip_pop(struct etch_surface *s, struct etch_clip_stack *stack);

#endif
