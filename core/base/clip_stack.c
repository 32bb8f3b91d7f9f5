/* base/clip_stack.c: clips inside clips. Called by applications. See clip_stack.h. */
#include "clip_stack.h"

void etch_clip_stack_init(struct etch_clip_stack *stack, struct etch_rect *saved, uint16_t room)
{
    ETCH_ASSERT(saved != NULL || room == 0);
    stack->saved = saved;
    stack->room = room;
    stack->depth = stack->lost = 0;
}

enum etch_status etch_clip_push(struct etch_surface *s, struct etch_clip_stack *stack,
                                struct etch_rect clip)
{
    if (stack->depth == stack->room) {
        if (stack->lost != UINT16_MAX)
            stack->lost++;
        return ETCH_ENOMEM;
    }
    stack->saved[stack->depth++] = s->clip;
    etch_surface_clip(s, etch_rect_intersect(s->clip, clip));
    return ETCH_OK;
}

enum etch_status etch_clip_pop(struct etch_surface *s, struct etch_clip_stack *stack)
{
    if (stack->lost != 0) {
        stack->lost--;
        return ETCH_OK;
    }
    if (stack->depth == 0)
        return ETCH_EINVAL;
    s->clip = stack->saved[--stack->depth];
    return ETCH_OK;
}
