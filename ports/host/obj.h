/* ports/host/obj.h: Wavefront OBJ files to meshes for the vertex stage.
 *
 * Read: v, vn, vt, f with v, v/vt, v//vn and v/vt/vn, negative indices, polygons (cut into a
 * fan from their first corner), comments, lines continued by a backslash, CR LF. g, o, s,
 * usemtl, mtllib, l and p are skipped; numbers after the third of a v and the second of a vt are
 * checked and dropped. Anything else is an error, `file:line: reason`.
 *
 * Positions are scaled by the greatest power of two, 2^scale, that keeps them within int16_t,
 * and rounded once; the mesh says so in its `bits` where 0 <= scale <= 15, and counts in units
 * of 2^(bits - scale) of the file's otherwise.
 * Normals become int8_t of length 127. A corner without one gets the average of all faces that
 * share its v, weighted by their area.
 * Where every corner has a vt, the mesh has texture coordinates: the least of 15 and the greatest
 * number of fraction bits that keeps all within int16_t, rounded; t counts downwards, 1 minus the
 * file's.
 * A mesh holds at most 65535 triangles and as many different corners (v, vt, vn). */
#ifndef ETCH_HOST_OBJ_H
#define ETCH_HOST_OBJ_H

#include "../../core/vertex/mesh.h"
#include "text.h"

struct etch_obj {
    struct etch_mesh mesh; /* points into the memory below */
    int scale;             /* positions are the file's numbers * 2^scale, rounded; -31 .. 31 */
    int16_t *positions;    /* from malloc */
    int16_t *coordinates;  /* s, t per vertex; NULL if a corner has none */
    uint8_t coordinate_bits;
    int8_t *normals;
    uint16_t *indices;
};

/* Reads a mesh from an open text, and closes that. False, with the reason in *text->error, if
 * the file is wrong or memory ran out; there is nothing to close then. */
bool etch_obj_read(struct etch_obj *obj, struct etch_text *text);

/* The same from a file. */
bool etch_obj_open(struct etch_obj *obj, const char *path, struct etch_error *error);

/* Gives the memory back. */
void etch_obj_close(struct etch_obj *obj);

#endif
