/* ports/host/scene_facts.c: notes what a scene's triangles are like. scene_draw.c and
 * scene_triangles.c call it while they draw. See scene_facts.h. */
#include "scene_facts.h"

#include "scene_staged.h"

static bool is_at_centre(const struct etch_vertex *v)
{
    return ((uint32_t)v->x_q8 & 255) == 128 && ((uint32_t)v->y_q8 & 255) == 128;
}

static bool is_of_color(const struct etch_vertex *a, const struct etch_vertex *b)
{
    return a->r == b->r && a->g == b->g && a->b == b->b && a->a == b->a;
}

void etch_scene_facts_triangle(const struct etch_scene_run *run,
                               const struct etch_scene_pipeline *pipeline,
                               const struct etch_vertex *const v[3])
{
    struct etch_scene_facts *facts = run->stats != NULL ? run->stats->facts : NULL;

    if (facts == NULL) {
        return;
    }
    facts->triangles++;
    facts->testing = (pipeline->staged != NULL ? pipeline->staged->state.ztest : pipeline->ztest) !=
                     0;
    facts->tested += facts->testing;
    facts->of_one_color += is_of_color(v[0], v[1]) && is_of_color(v[0], v[2]);
    facts->at_centres += is_at_centre(v[0]) && is_at_centre(v[1]) && is_at_centre(v[2]);
}

void etch_scene_facts_texture(const struct etch_scene_run *run,
                              const struct etch_scene_pipeline *pipeline,
                              const struct etch_texture_vertex *const v[3])
{
    const struct etch_vertex *const corners[3] = {&v[0]->at, &v[1]->at, &v[2]->at};

    etch_scene_facts_triangle(run, pipeline, corners);
    if (run->stats != NULL && run->stats->facts != NULL) {
        run->stats->facts->textured++;
        run->stats->facts->of_equal_w += v[0]->w == v[1]->w && v[0]->w == v[2]->w;
    }
}

void etch_scene_facts_runs(struct etch_scene_facts *facts, int16_t y0, const struct etch_run *runs,
                           uint8_t n)
{
    for (uint8_t i = 0; facts->testing && i < n; i++) {
        uint8_t *row = facts->times + (size_t)(y0 + i) * (size_t)facts->width;

        for (int16_t x = runs[i].x0; x < runs[i].x1; x++) {
            row[x] = (uint8_t)(row[x] < UINT8_MAX ? row[x] + 1 : UINT8_MAX);
        }
    }
}
