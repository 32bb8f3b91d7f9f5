/* ports/host/obj_parts.h: what obj.c reads and obj_mesh.c builds from; no part of the API. */
#ifndef ETCH_HOST_OBJ_PARTS_H
#define ETCH_HOST_OBJ_PARTS_H

#include "obj.h"

#define OBJ_MAX_TRIANGLES 65535
#define OBJ_NONE UINT32_MAX

/* A position or normal as it was written. */
struct obj_vector {
    struct etch_decimal c[3];
};

/* A corner of a triangle: places in the lists below, from 0. */
struct obj_corner {
    uint32_t v, vt, vn; /* vt and vn may be OBJ_NONE */
};

/* What the file says. */
struct obj_file {
    struct etch_text text;
    struct obj_vector *v, *vn, *vt; /* of a vt the first two numbers */
    struct obj_corner *corner;      /* three per triangle */
    size_t v_count, v_capacity, vn_count, vn_capacity, vt_count, vt_capacity;
    size_t corner_count, corner_capacity;
};

/* Builds the mesh. False, with an error set, if it does not fit its types or memory ran out;
 * obj may then hold some of its memory, for etch_obj_close. */
bool obj_build(struct etch_obj *obj, const struct obj_file *file);

/* Adds texture coordinates, if every corner has them; corner[i] is where vertex i is from. False as
 * above. */
bool obj_coordinates(struct etch_obj *obj, const struct obj_file *file,
                     const struct obj_corner *corner);

/* A normal as it was written, as integers whose largest is 2^27 or more: moving the decimal
 * point of all three does not turn it. */
void obj_written_normal(const struct obj_vector *vn, int64_t n[3]);

/* Brings a vector to length 127, rounded; zero stays zero. |components| < 2^62. */
void obj_normalise(const int64_t n[3], int8_t out[3]);

#endif
