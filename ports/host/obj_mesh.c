/* ports/host/obj_mesh.c: from the lists of an OBJ file to an indexed mesh. obj.c calls it.
 *
 *      scale -> positions as int16 -> normals of v (averages) -> corners (v, vt, vn) -> mesh */
#include <stdlib.h>
#include <string.h>

#include "obj_parts.h"

#define MAX_VERTICES 65535

/* The tables while a mesh is built. */
struct builder {
    const struct obj_file *file;
    struct etch_obj *obj;
    int32_t *position;         /* x, y, z for each v, scaled; only those used by a face are right */
    int64_t *average;          /* x, y, z for each v: sum of face normals */
    uint32_t *first;           /* for each v: newest vertex of the mesh made from it, + 1, or 0 */
    uint32_t *next;            /* for each vertex of the mesh: the one before it, + 1, or 0 */
    struct obj_corner *vertex; /* for each vertex of the mesh: where it is from */
    size_t count;              /* of vertices of the mesh */
};

static bool fail(const struct obj_file *file, const char *reason)
{
    return etch_error_set(file->text.error, file->text.path, 0, "%s", reason);
}

/* The greatest scale that keeps every corner's position within int16_t, at most 31. */
static bool choose_scale(struct builder *b)
{
    int scale = 31;
    int32_t value;

    for (size_t i = 0; i < b->file->corner_count; i++) {
        const struct obj_vector *v = &b->file->v[b->file->corner[i].v];

        for (int axis = 0; axis < 3; axis++) {
            while (!etch_decimal_scale(&v->c[axis], scale, &value) || value > INT16_MAX ||
                   value < -INT16_MAX) {
                if (--scale < -31) {
                    return fail(b->file, "a coordinate is too large");
                }
            }
        }
    }
    b->obj->scale = scale;
    return true;
}

static void scale_positions(struct builder *b)
{
    for (size_t i = 0; i < b->file->corner_count; i++) {
        const uint32_t v = b->file->corner[i].v;

        for (int axis = 0; axis < 3; axis++) {
            (void)etch_decimal_scale(&b->file->v[v].c[axis], b->obj->scale,
                                     &b->position[(size_t)v * 3 + (size_t)axis]);
        }
    }
}

/* Adds each face's normal, whose length is twice its area, to its three positions. A component
 * is below 2 * 65534^2 < 2^34, a sum of 65535 * 3 of them below 2^52. */
static void average_normals(struct builder *b)
{
    for (size_t i = 0; i < b->file->corner_count; i += 3) {
        const struct obj_corner *corner = &b->file->corner[i];
        const int32_t *p = &b->position[(size_t)corner[0].v * 3];
        int64_t u[3], w[3];

        for (int axis = 0; axis < 3; axis++) {
            u[axis] = b->position[(size_t)corner[1].v * 3 + (size_t)axis] - p[axis];
            w[axis] = b->position[(size_t)corner[2].v * 3 + (size_t)axis] - p[axis];
        }
        for (int k = 0; k < 3; k++) {
            int64_t *sum = &b->average[(size_t)corner[k].v * 3];

            sum[0] += u[1] * w[2] - u[2] * w[1];
            sum[1] += u[2] * w[0] - u[0] * w[2];
            sum[2] += u[0] * w[1] - u[1] * w[0];
        }
    }
}

static int64_t magnitude(int64_t v)
{
    return v < 0 ? -v : v;
}

/* The mesh's vertex for a corner: one that was made, or a new one. False beyond 65535. */
static bool vertex_of(struct builder *b, struct obj_corner corner, uint16_t *index)
{
    uint32_t at = b->first[corner.v];

    while (at != 0 && (b->vertex[at - 1].vn != corner.vn || b->vertex[at - 1].vt != corner.vt)) {
        at = b->next[at - 1];
    }
    if (at == 0) {
        if (b->count == MAX_VERTICES) {
            return fail(b->file, "more than 65535 different corners");
        }
        b->vertex[b->count] = corner;
        b->next[b->count] = b->first[corner.v];
        at = b->first[corner.v] = (uint32_t)++b->count;
    }
    *index = (uint16_t)(at - 1);
    return true;
}

static bool index_corners(struct builder *b)
{
    for (size_t i = 0; i < b->file->corner_count; i++) {
        if (!vertex_of(b, b->file->corner[i], &b->obj->indices[i])) {
            return false;
        }
    }
    return true;
}

static void fill_vertices(struct builder *b)
{
    int64_t n[3];

    for (size_t i = 0; i < b->count; i++) {
        const struct obj_corner corner = b->vertex[i];

        for (size_t axis = 0; axis < 3; axis++) {
            b->obj->positions[i * 3 + axis] = (int16_t)b->position[(size_t)corner.v * 3 + axis];
        }
        if (corner.vn == OBJ_NONE) {
            memcpy(n, &b->average[(size_t)corner.v * 3], sizeof n);
        } else {
            obj_written_normal(&b->file->vn[corner.vn], n);
        }
        obj_normalise(n, &b->obj->normals[i * 3]);
    }
}

static void describe(struct builder *b)
{
    struct etch_mesh *mesh = &b->obj->mesh;
    const int scale = b->obj->scale;

    mesh->positions = b->obj->positions;
    mesh->normals = b->obj->normals;
    mesh->indices = b->obj->indices;
    mesh->vertex_count = (uint16_t)b->count;
    mesh->triangle_count = (uint16_t)(b->file->corner_count / 3);
    mesh->bits = (uint8_t)(scale < 0 ? 0 : scale > 15 ? 15 : scale);
    for (size_t i = 0; i < b->count * 3; i++) {
        const int64_t extent = magnitude(b->obj->positions[i]);
        mesh->extent = (uint16_t)(extent > mesh->extent ? extent : mesh->extent);
    }
}

static bool get_tables(struct builder *b)
{
    const size_t v = b->file->v_count, corners = b->file->corner_count;
    struct etch_obj *obj = b->obj;

    b->position = calloc(v, 3 * sizeof *b->position);
    b->average = calloc(v, 3 * sizeof *b->average);
    b->first = calloc(v, sizeof *b->first);
    b->next = calloc(corners, sizeof *b->next);
    b->vertex = calloc(corners, sizeof *b->vertex);
    obj->positions = calloc(corners, 3 * sizeof *obj->positions);
    obj->normals = calloc(corners, 3 * sizeof *obj->normals);
    obj->indices = calloc(corners, sizeof *obj->indices);
    return (b->position && b->average && b->first && b->next && b->vertex && obj->positions &&
            obj->normals && obj->indices) ||
           fail(b->file, "out of memory");
}

bool obj_build(struct etch_obj *obj, const struct obj_file *file)
{
    struct builder b = {.file = file, .obj = obj};
    bool ok;

    if (file->corner_count == 0) {
        return fail(file, "no face");
    }
    ok = get_tables(&b) && choose_scale(&b);
    if (ok) {
        scale_positions(&b);
        average_normals(&b);
        ok = index_corners(&b);
    }
    if (ok) {
        fill_vertices(&b);
        describe(&b);
        ok = obj_coordinates(obj, file, b.vertex);
    }
    free(b.position);
    free(b.average);
    free(b.first);
    free(b.next);
    free(b.vertex);
    return ok;
}
