/* ports/host/scene_place.c: where the triangles of one of several drawings go. What paints
 * triangles calls it if the run has a pass. */
#include "scene_passes.h"
#include "scene_staged.h"

enum {
    SMOOTH,
    FLAT
};
enum {
    OFF = 0,
    LESS = 2,
    LEQUAL = 4
};

static int32_t hold(int64_t v)
{
    const int64_t limit = INT64_C(1) << 23;

    return (int32_t)(v < -limit ? -limit : v > limit ? limit : v);
}

/* The way so far, to the nearest 1/256 px. */
static int64_t moved(int32_t whole_q8, const struct etch_scene_pass *pass)
{
    const int64_t twice = (int64_t)whole_q8 * (2 * pass->moment + 1);

    return pass->moments > 1 ? (twice + pass->moments) / (2 * pass->moments) : 0;
}

/* Positions reach to +-2^23 / scale; beyond, they are held. */
static void place(const struct etch_scene_run *run, struct etch_vertex *v)
{
    const struct etch_scene_pass *pass = run->pass;

    v->x_q8 = hold((v->x_q8 + moved(run->motion_x_q8, pass)) * pass->scale) - pass->offset.x;
    v->y_q8 = hold((v->y_q8 + moved(run->motion_y_q8, pass)) * pass->scale) - pass->offset.y;
}

bool etch_scene_pass_paints(const struct etch_scene_pipeline *pipeline)
{
    const bool depth = (pipeline->ztest == LESS || pipeline->ztest == LEQUAL) &&
                       pipeline->zwrite != 0;

    return pipeline->texture == NULL && pipeline->staged == NULL &&
           (pipeline->ztest == OFF || depth);
}

/* By samples: flat or smooth, without depth, less, or less or equal. */
static void paint_samples(const struct etch_scene_pass *pass,
                          const struct etch_scene_pipeline *pipeline,
                          const struct etch_vertex *const v[3])
{
    static etch_multisample_painter *const own[2][3] = {
        {etch_multisample_gouraud, etch_multisample_gouraud_less, etch_multisample_gouraud_lequal},
        {etch_multisample_flat, etch_multisample_flat_less, etch_multisample_flat_lequal}};
    static etch_shared_painter *const pairs[2][3] = {
        {etch_shared_gouraud, etch_shared_gouraud_less, etch_shared_gouraud_lequal},
        {etch_shared_flat, etch_shared_flat_less, etch_shared_flat_lequal}};
    const int shade = pipeline->shade == FLAT ? FLAT : SMOOTH, test = pipeline->ztest / 2;

    if (pass->samples != NULL) {
        own[shade][test](pass->samples, v);
    } else {
        pairs[shade][test](pass->pairs, v);
    }
}

void etch_scene_pass_triangle(struct etch_scene_run *run,
                              const struct etch_scene_pipeline *pipeline,
                              const struct etch_vertex *const v[3])
{
    struct etch_vertex placed[3] = {*v[0], *v[1], *v[2]};
    const struct etch_vertex *const corners[3] = {&placed[0], &placed[1], &placed[2]};

    for (int i = 0; i < 3; i++) {
        place(run, &placed[i]);
    }
    if (run->pass->samples != NULL || run->pass->pairs != NULL) {
        paint_samples(run->pass, pipeline, corners);
    } else if (pipeline->staged != NULL) {
        etch_scene_staged_draw(run, pipeline->staged, corners);
    } else {
        etch_scene_painter(run, pipeline)(&run->surface, corners, etch_scene_kernel(run, pipeline));
    }
}

void etch_scene_pass_texture(struct etch_scene_run *run, const struct etch_scene_pipeline *pipeline,
                             const struct etch_texture_vertex *const v[3],
                             const struct etch_texture *texture)
{
    const struct etch_scene_pass *const pass = run->pass;
    struct etch_shade_vertex placed[3];
    const struct etch_texture_vertex *const corners[3] = {&placed[0].at, &placed[1].at,
                                                          &placed[2].at};

    etch_scene_vertices_take(placed, v,
                             pipeline->staged != NULL && pipeline->staged->phong != NULL);
    for (int i = 0; i < 3; i++) {
        place(run, &placed[i].at.at);
    }
    run->pass = NULL;
    etch_scene_paint_texture(run, pipeline, corners, texture);
    run->pass = pass;
}
