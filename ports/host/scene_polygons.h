/* ports/host/scene_polygons.h: what scene_polygons.c and scene_paths.c share. */
#ifndef ETCH_HOST_SCENE_POLYGONS_H
#define ETCH_HOST_SCENE_POLYGONS_H

#include "../../core/fragment/flat.h"
#include "../../core/raster/polygon.h"
#include "scene_steps.h"

/* A polygon as it was read: its vertices, and the edges that are walked when it is filled. */
struct etch_scene_polygon {
    uint8_t rgb[3];
    uint16_t contours;
    uint16_t *size;          /* of each contour */
    struct etch_point *v;    /* of all contours, one after the other */
    struct etch_polygon *of; /* that is filled */
    uint8_t *bits;           /* of inversion, for the whole frame */
    uint16_t *corner;        /* of triangles, three vertices each */
    size_t triangles;
};

/* evenodd|nonzero: a step that fills the polygon in its data; NULL, with an error set. */
struct etch_scene_step *etch_scene_read_rule(struct etch_scene_reader *reader);

/* Flat runs in the polygon's colour, counted if there are stats. */
struct etch_flat_paint etch_scene_flat_paint(struct etch_scene_run *run,
                                             const struct etch_scene_polygon *p);

/* inversion|triangles: the same in another way; NULL, without an error, if neither follows. */
const struct etch_scene_statement *etch_scene_read_fill_way(struct etch_scene_reader *reader);

/* Fills in what those ways draw with; false, with an error set. */
bool etch_scene_open_inversion(struct etch_scene_reader *reader, struct etch_scene_polygon *p);
bool etch_scene_open_triangles(struct etch_scene_reader *reader, struct etch_scene_polygon *p);

/* What those steps are drawn by, and the outlines of triangles. */
extern const struct etch_scene_statement etch_scene_fill_inversion, etch_scene_fill_triangles,
    etch_scene_outline_triangles;

/* Makes p->of, with room for so many edges; false, with an error set, without memory. */
bool etch_scene_open_edges(struct etch_scene_reader *reader, struct etch_scene_polygon *p,
                           size_t n);

#endif
