/* frame/multisample_setup.c: moved triangles and their runs. Called by the painters of samples.
 * See multisample_setup.h. */
#include "multisample_setup.h"

/* A kernel that keeps the runs instead of painting them. */
struct keep_paint {
    struct etch_paint paint;
    struct etch_run *runs; /* of row y */
    int16_t y;
};

static void keep(const struct etch_surface *surface, int16_t y0, const struct etch_run *runs,
                 uint8_t n, const struct etch_paint *paint)
{
    const struct keep_paint *p = (const struct keep_paint *)(const void *)paint;

    (void)surface;
    for (uint8_t i = 0; i < n; i++)
        p->runs[y0 - p->y + i] = runs[i];
}

bool etch_sample_setup(struct sample_shape *shape, const struct etch_rect *clip,
                       const struct etch_vertex *const v[3], const struct etch_offset_q8 *offset,
                       uint8_t points)
{
    int32_t y0 = INT32_MAX, y1 = INT32_MIN;
    bool visible = false;

    shape->points = points;
    for (uint8_t k = 0; k < points; k++) {
        struct etch_triangle *t = &shape->at[k];
        struct etch_point_q8 p[3];

        for (uint8_t i = 0; i < 3; i++) {
            p[i].x = v[i]->x_q8 - offset[k].x;
            p[i].y = v[i]->y_q8 - offset[k].y;
        }
        if (!etch_triangle_setup(t, p))
            return false;
        if (k < ETCH_SAMPLES) {
            visible = visible || etch_triangle_is_visible(t, clip);
            y0 = t->y0 < y0 ? t->y0 : y0;
            y1 = t->y1 > y1 ? t->y1 : y1;
        }
    }
    shape->y0 = y0 > clip->y0 ? (int16_t)y0 : clip->y0;
    shape->y1 = y1 < clip->y1 ? (int16_t)y1 : clip->y1;
    return visible;
}

void etch_sample_walk(const struct sample_shape *shape, const struct etch_surface *surface,
                      int16_t y, uint8_t n, struct sample_band *band)
{
    struct etch_surface rows = *surface;

    rows.clip.y0 = y;
    rows.clip.y1 = (int16_t)(y + n);
    for (uint8_t k = 0; k < ETCH_SAMPLES; k++) {
        const struct keep_paint paint = {{keep}, band->run[k], y};

        for (uint8_t i = 0; i < n; i++)
            band->run[k][i] = (struct etch_run){0, 0};
        etch_triangle_runs(&rows, &shape->at[k], &paint.paint);
    }
}
