/* ports/host/scene_polygons.h: what scene_polygons.c and scene_paths.c share. */
#ifndef ETCH_HOST_SCENE_POLYGONS_H
#define ETCH_HOST_SCENE_POLYGONS_H

#include "../../core/raster/polygon.h"
#include "scene_steps.h"

/* A polygon as it was read: its vertices, and the edges that are walked when it is filled. */
struct etch_scene_polygon {
    uint8_t rgb[3];
    uint16_t contours;
    uint16_t *size;          /* of each contour */
    struct etch_point *v;    /* of all contours, one after the other */
    struct etch_polygon *of; /* that is filled */
};

/* evenodd|nonzero: a step that fills the polygon in its data; NULL, with an error set. */
struct etch_scene_step *etch_scene_read_rule(struct etch_scene_reader *reader);

/* Makes p->of, with room for so many edges; false, with an error set, without memory. */
bool etch_scene_open_edges(struct etch_scene_reader *reader, struct etch_scene_polygon *p,
                           size_t n);

#endif
