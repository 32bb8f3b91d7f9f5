/* draw/retained_rows.c: visible triangles listed once a frame, assembled strip by strip. Called by
 * the application. See retained_rows.h. */
#include "retained_rows.h"

/* The first row whose centre is at or below y. */
static int16_t row_of(int32_t y_q8)
{
    const int32_t row = (y_q8 + 127) >> 8;

    return (int16_t)(row > INT16_MAX ? INT16_MAX : row);
}

/* The rows of a triangle; false if there are none. */
static bool set_rows(struct etch_mesh_row_range *range, const struct etch_vertex *const v[3])
{
    const int32_t a = v[0]->y_q8, b = v[1]->y_q8, c = v[2]->y_q8;
    int32_t least = a < b ? a : b, most = a < b ? b : a;

    least = c < least ? c : least;
    most = c > most ? c : most;
    range->y0 = row_of(least);
    range->y1 = row_of(most);
    return range->y0 < range->y1;
}

/* Whether the triangle can be seen, and on which rows. */
static bool is_visible(const struct etch_mesh_vertex *buffer, const uint16_t index[3],
                       enum etch_cull cull, struct etch_mesh_row_range *range)
{
    const struct etch_mesh_vertex *const a = &buffer[index[0]];
    const struct etch_mesh_vertex *const b = &buffer[index[1]];
    const struct etch_mesh_vertex *const c = &buffer[index[2]];
    const struct etch_vertex *const v[3] = {&a->v, &b->v, &c->v};

    if ((a->out & b->out & c->out & ETCH_OUT_REJECT) != 0)
        return false;
    if (((a->out | b->out | c->out) & ETCH_OUT_CLIP) == 0)
        return etch_cull_keeps(cull, v) && set_rows(range, v);
    range->y0 = INT16_MIN;
    range->y1 = INT16_MAX;
    return true;
}

/* Takes the rows of entry `i` into its group's. */
static void join_group(struct etch_mesh_row_range *list, uint16_t i)
{
    struct etch_mesh_row_range *const first = &list[i - i % ETCH_MESH_ROWS_GROUP];

    if (first == &list[i] || list[i].y0 < first->group_y0)
        first->group_y0 = list[i].y0;
    if (first == &list[i] || list[i].y1 > first->group_y1)
        first->group_y1 = list[i].y1;
}

uint16_t etch_mesh_rows_range(const struct etch_mesh_stage *stage,
                              const struct etch_assembly *assembly,
                              const struct etch_mesh_vertex *buffer,
                              struct etch_mesh_row_range *list, uint16_t room, uint16_t first,
                              uint16_t end)
{
    const struct etch_mesh *const mesh = stage->mesh;
    const uint16_t count = mesh->vertex_count;
    struct etch_mesh_row_range spare;
    uint16_t n = 0;

    for (uint16_t t = first; t < end; t++) {
        struct etch_mesh_row_range *const range = n < room ? &list[n] : &spare;
        uint16_t index[3];

        etch_mesh_triangle(mesh, t, index);
        if (index[0] >= count || index[1] >= count || index[2] >= count ||
            !is_visible(buffer, index, assembly->cull, range))
            continue;
        range->triangle = t;
        if (n < room)
            join_group(list, n);
        n++;
    }
    return n;
}

uint16_t etch_mesh_rows(const struct etch_mesh_stage *stage, const struct etch_assembly *assembly,
                        const struct etch_mesh_vertex *buffer, struct etch_mesh_row_range *list,
                        uint16_t room)
{
    return etch_mesh_rows_range(stage, assembly, buffer, list, room, 0,
                                stage->mesh->triangle_count);
}

/* The long way, for what is clipped or takes one vertex's colour. */
static ETCH_COLD void assemble_again(const struct etch_mesh_stage *stage,
                                     const struct etch_assembly *assembly, const uint16_t index[3])
{
    struct etch_clip_vertex v[3];

    for (uint8_t i = 0; i < 3; i++)
        stage->vertex(stage, index[i], &v[i]);
    etch_assemble_triangle(assembly, v);
}

/* Triangles that are clipped have all rows, others nearly never: those may go the long way too. */
ETCH_INLINE void assemble(const struct etch_mesh_stage *stage, const struct etch_assembly *assembly,
                          const struct etch_mesh_vertex *buffer,
                          const struct etch_mesh_row_range *range)
{
    uint16_t index[3];

    etch_mesh_triangle(stage->mesh, range->triangle, index);
    if (range->y0 == INT16_MIN || assembly->flat) {
        assemble_again(stage, assembly, index);
    } else {
        const struct etch_vertex *const v[3] = {&buffer[index[0]].v, &buffer[index[1]].v,
                                                &buffer[index[2]].v};

        assembly->sink->triangle(assembly->sink, v);
    }
}

void etch_mesh_assemble_rows(const struct etch_mesh_stage *stage,
                             const struct etch_assembly *assembly,
                             const struct etch_mesh_vertex *buffer,
                             const struct etch_mesh_row_range *list, uint16_t count, int16_t y0,
                             int16_t y1)
{
    const struct etch_mesh_row_range *const end = list + count;

    while (list != end) {
        const uint16_t left = (uint16_t)(end - list);
        const uint16_t n = left < ETCH_MESH_ROWS_GROUP ? left : ETCH_MESH_ROWS_GROUP;
        const struct etch_mesh_row_range *const next = list + n;

        if (list->group_y0 < y1 && list->group_y1 > y0)
            for (; list != next; list++)
                if (list->y0 < y1 && list->y1 > y0)
                    assemble(stage, assembly, buffer, list);
        list = next;
    }
}
