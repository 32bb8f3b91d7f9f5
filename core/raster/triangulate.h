/* raster/triangulate.h: simple polygons, with holes, to triangles.
 *
 * The triangles together cover the pixels of the polygon (polygon.h), each once: they meet along
 * edges and diagonals between the polygon's own vertices. Use it where a polygon is to be drawn by
 * a triangle painter: shaded, textured, in three dimensions.
 *
 * Source: G. H. Meisters, "Polygons have ears", 1975; ears are kept up to date as in J. O'Rourke,
 * "Computational Geometry in C", 1994; bridges to holes: D. Eberly, "Triangulation by ear
 * clipping", 1998. All orientation tests are exact.
 */
#ifndef ETCH_RASTER_TRIANGULATE_H
#define ETCH_RASTER_TRIANGULATE_H

#include "triangle.h"

/* A corner of the ring that is cut: 8 bytes of the caller's memory. */
struct etch_ring_node {
    uint16_t vertex;         /* of the caller's list */
    uint16_t next, previous; /* nodes */
    bool is_ear;
};

/* Takes a triangle: three indices into the list of vertices, wound as the outer contour is. */
typedef void etch_triangulate_function(void *context, const uint16_t vertex[3]);

/* Cuts the polygon v[0] .. v[n - 1] into at most n - 2 triangles, none without area; straight
 * corners are corners of triangles too. Vertices within -2^23 .. 2^23, no edge crosses or touches
 * another but at the vertex they share, winding as it may be. `node` has room for n. Fewer than 3
 * vertices make no triangle. ETCH_EINVAL where no ear is left, as may be with polygons that are not
 * simple: triangles made until then have been handed over. n^2 steps; no recursion. */
enum etch_status etch_triangulate(const struct etch_point_q8 *v, uint16_t n,
                                  struct etch_ring_node *node, etch_triangulate_function *triangle,
                                  void *context);

/* The same for an outer contour of size[0] vertices, v[0] on, and contours - 1 holes in it, size[1]
 * vertices and so on, which lie inside and neither touch nor contain each other. Together n
 * vertices; `node` has room for n + 2 contours. Holes are first joined to the outside by bridges,
 * from the rightmost on, n^2 steps for each.
 * ETCH_ENOMEM if n + 2 contours is above `room` or 65534; ETCH_EINVAL as above, or where a hole has
 * no bridge. */
enum etch_status etch_triangulate_holes(const struct etch_point_q8 *v, const uint16_t *size,
                                        uint16_t contours, struct etch_ring_node *node,
                                        uint16_t room, etch_triangulate_function *triangle,
                                        void *context);

#endif
