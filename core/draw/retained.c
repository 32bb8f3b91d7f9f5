/* draw/retained.c: triangles set up once a frame. The sink is called by assembly and draw/mesh,
 * the drawing by the application, once a strip. See retained.h. */
#include "retained.h"
#include "setup.h"

/* Takes the rows of triangle `i` into its group's. Kept triangles meet the frame, so their rows
 * that int16_t cannot hold are none that a strip has. */
static void join_group(struct etch_retained_triangle *triangle, uint16_t i)
{
    const struct etch_triangle *const t = &triangle[i].shape;
    struct etch_retained_triangle *const first = &triangle[i - i % ETCH_RETAINED_GROUP];
    const int16_t y0 = (int16_t)(t->y0 < INT16_MIN ? INT16_MIN : t->y0);
    const int16_t y1 = (int16_t)(t->y1 > INT16_MAX ? INT16_MAX : t->y1);

    if (first == &triangle[i] || y0 < first->group_y0)
        first->group_y0 = y0;
    if (first == &triangle[i] || y1 > first->group_y1)
        first->group_y1 = y1;
}

static void keep(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    /* sink is the first member, so it has the address of the whole */
    struct etch_retained *const r = (struct etch_retained *)(void *)sink;
    const struct etch_point_q8 p[3] = {
        {v[0]->x_q8, v[0]->y_q8}, {v[1]->x_q8, v[1]->y_q8}, {v[2]->x_q8, v[2]->y_q8}};
    struct etch_triangle spare;
    struct etch_retained_triangle *const kept = &r->triangle[r->count];
    struct etch_triangle *const t = r->count < r->room ? &kept->shape : &spare;
    struct etch_basis b;

    if (!etch_triangle_setup(t, p) || !etch_triangle_is_visible(t, &r->frame))
        return;
    if (r->count == r->room) {
        r->lost = (uint16_t)(r->lost + (r->lost != UINT16_MAX));
        return;
    }

    const struct etch_basis *const basis = etch_basis_setup(&b, t) ? &b : NULL;

    kept->paint.paint.kernel = r->kernel;
    setup_depth(&kept->paint.z, t, basis, v);
    setup_color(&kept->paint, t, basis, v);
    join_group(r->triangle, r->count++);
}

void etch_retained_init(struct etch_retained *r, struct etch_rect frame, etch_kernel *kernel,
                        struct etch_retained_triangle *triangle, uint16_t room)
{
    r->sink.triangle = keep;
    r->frame = frame;
    r->triangle = triangle;
    r->kernel = kernel;
    r->room = room;
    r->count = 0;
    r->lost = 0;
}

void etch_retained_draw(const struct etch_retained *r, const struct etch_surface *surface)
{
    const int32_t top = surface->clip.y0, bottom = surface->clip.y1;
    const struct etch_retained_triangle *kept = r->triangle;
    const struct etch_retained_triangle *const end = kept + r->count;

    while (kept != end) {
        const uint16_t left = (uint16_t)(end - kept);
        const uint16_t n = left < ETCH_RETAINED_GROUP ? left : ETCH_RETAINED_GROUP;
        const struct etch_retained_triangle *const next = kept + n;

        if (kept->group_y0 < bottom && kept->group_y1 > top)
            for (; kept != next; kept++)
                if (kept->shape.y0 < bottom && kept->shape.y1 > top)
                    etch_triangle_runs(surface, &kept->shape, &kept->paint.paint);
        kept = next;
    }
}
