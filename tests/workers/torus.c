/* tests/workers: the torus. See torus.h. */
#include "torus.h"

#include "core/base/trig.h"
#include "core/draw/shapes.h"
#include "core/fragment/gouraud.h"

enum {
    RING = 1 << 12, /* radii in 1/4096 */
    TUBE = 1700
};

/* a b / 65536, towards zero. */
static int32_t product_q16(int32_t a, etch_q16 b)
{
    return a * (b / 16) / 4096;
}

static void make_vertex(struct torus *t, uint16_t i, uint16_t j)
{
    const uint16_t along = (uint16_t)(65536 * (uint32_t)i / TORUS_AROUND);
    const uint16_t round = (uint16_t)(65536 * (uint32_t)j / TORUS_ALONG);
    const int32_t out = product_q16(TUBE, etch_cos_q16(round));
    const int32_t face = product_q16(127, etch_cos_q16(round));
    int16_t *p = t->positions + (i * TORUS_ALONG + j) * 3;
    int8_t *n = t->normals + (i * TORUS_ALONG + j) * 3;

    p[0] = (int16_t)product_q16(RING + out, etch_cos_q16(along));
    p[1] = (int16_t)product_q16(RING + out, etch_sin_q16(along));
    p[2] = (int16_t)product_q16(TUBE, etch_sin_q16(round));
    n[0] = (int8_t)product_q16(face, etch_cos_q16(along));
    n[1] = (int8_t)product_q16(face, etch_sin_q16(along));
    n[2] = (int8_t)product_q16(127, etch_sin_q16(round));
}

void torus_make(struct torus *t)
{
    uint16_t *index = t->indices;

    for (uint16_t i = 0; i < TORUS_AROUND; i++)
        for (uint16_t j = 0; j < TORUS_ALONG; j++) {
            const uint16_t next = (uint16_t)((i + 1) % TORUS_AROUND * TORUS_ALONG);
            const uint16_t up = (uint16_t)((j + 1) % TORUS_ALONG);
            const uint16_t row = (uint16_t)(i * TORUS_ALONG);

            make_vertex(t, i, j);
            *index++ = (uint16_t)(row + j);
            *index++ = (uint16_t)(next + j);
            *index++ = (uint16_t)(next + up);
            *index++ = (uint16_t)(row + j);
            *index++ = (uint16_t)(next + up);
            *index++ = (uint16_t)(row + up);
        }
    t->mesh = (struct etch_mesh){.positions = t->positions,
                                 .normals = t->normals,
                                 .indices = t->indices,
                                 .vertex_count = TORUS_VERTICES,
                                 .triangle_count = TORUS_TRIANGLES,
                                 .extent = RING + TUBE,
                                 .bits = 12};
}

void torus_turn(struct torus *t, uint16_t turn, int16_t width, int16_t height)
{
    const struct etch_vector eye = {etch_sin_q16(turn) * 5 / 2, -(etch_cos_q16(turn) * 5 / 2),
                                    ETCH_Q16(2, 1)};
    const struct etch_vector target = {0, 0, 0}, up = {0, 0, ETCH_Q16_ONE};
    const struct etch_vector sun = {ETCH_Q16(1, 1), ETCH_Q16(-2, 1), ETCH_Q16(3, 1)};
    struct etch_matrix model, view, clip;

    etch_matrix_identity(&model);
    (void)etch_matrix_look_at(&view, &eye, &target, &up);
    (void)etch_matrix_perspective(&clip, 65536 / 8, (etch_q16)((int32_t)width * 65536 / height),
                                  ETCH_Q16(1, 1), ETCH_Q16(9, 1));
    (void)etch_matrix_multiply(&clip, &clip, &view);
    t->light = (struct etch_light){.diffuse = {220, 160, 60}};
    (void)etch_light_aim(&t->light, &model, &sun);
    t->lighting = (struct etch_lighting){.ambient = {30, 30, 50}, .count = 1, .light = &t->light};
    t->assembly = (struct etch_assembly){.cull = ETCH_CULL_CLOCKWISE};
    (void)etch_viewport_init(&t->assembly.viewport, (struct etch_rect){0, 0, width, height});
    etch_mesh_stage_init(&t->stage, &t->mesh, &clip, etch_vertex_lit, &t->lighting);
}

/* ---- a share --------------------------------------------------------------------------------- */

/* Where share `part` of n begins. */
static uint16_t first_of(uint16_t part, uint16_t n)
{
    return (uint16_t)((uint32_t)n * part / TORUS_PARTS);
}

/* Clears the surface and makes a sink that draws on it. */
static void open_sink(struct etch_raster_sink *raster, const struct torus *t,
                      const struct etch_surface *s)
{
    const uint16_t night = etch_rgb565(0, 12, 30);

    etch_surface_clear(s, t->swapped ? etch_rgb565_swap(night) : night);
    etch_depth_clear(s, 65535);
    etch_raster_sink_init(raster, s, etch_triangle_gouraud_depth,
                          t->swapped ? etch_kernel_gouraud_less_swapped : etch_kernel_gouraud_less);
}

static void draw_strip(const struct torus *t, const struct etch_surface *s)
{
    struct etch_assembly assembly = t->assembly;
    struct etch_raster_sink raster;

    open_sink(&raster, t, s);
    assembly.sink = &raster.sink;
    for (uint16_t part = 0; part < TORUS_PARTS; part++)
        etch_mesh_assemble_rows(&t->stage, &assembly, t->vertex,
                                t->list + first_of(part, TORUS_TRIANGLES), t->visible[part],
                                s->clip.y0, s->clip.y1);
}

void torus_draw_share(struct torus *t, struct etch_worker *worker)
{
    uint16_t part;

    while (etch_worker_part(worker, TORUS_PARTS, &part))
        etch_mesh_transform_range(&t->stage, &t->assembly.viewport, t->vertex,
                                  first_of(part, TORUS_VERTICES),
                                  first_of((uint16_t)(part + 1), TORUS_VERTICES));
    while (etch_worker_part(worker, TORUS_PARTS, &part)) {
        const uint16_t first = first_of(part, TORUS_TRIANGLES);
        const uint16_t end = first_of((uint16_t)(part + 1), TORUS_TRIANGLES);

        t->visible[part] = etch_mesh_rows_range(&t->stage, &t->assembly, t->vertex, t->list + first,
                                                (uint16_t)(end - first), first, end);
    }
    for (const struct etch_surface *s; (s = etch_worker_next(worker)) != NULL;)
        draw_strip(t, s);
}

void torus_draw_alone(struct torus *t, const struct etch_surface *s)
{
    struct etch_assembly assembly = t->assembly;
    struct etch_raster_sink raster;

    open_sink(&raster, t, s);
    assembly.sink = &raster.sink;
    (void)etch_mesh_draw(&t->stage, &assembly, t->vertex, TORUS_VERTICES);
}
