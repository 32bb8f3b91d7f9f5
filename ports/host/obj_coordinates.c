/* ports/host/obj_coordinates.c: texture coordinates of OBJ files as int16. obj_mesh.c calls it. */
#include <stdlib.h>

#include "obj_parts.h"

enum {
    MOST_BITS = 15
};

/* One coordinate with `bits` fraction bits, t turned downwards; false if it leaves int16_t. */
static bool scaled(const struct obj_vector *vt, int axis, int bits, int16_t *out)
{
    int32_t value;

    if (!etch_decimal_scale(&vt->c[axis], bits, &value) || value > INT16_MAX ||
        value < -INT16_MAX) {
        return false;
    }
    value = axis == 0 ? value : (INT32_C(1) << bits) - value;
    *out = (int16_t)value;
    return value <= INT16_MAX;
}

static bool scale_all(struct etch_obj *obj, const struct obj_file *file,
                      const struct obj_corner *corner, int bits)
{
    for (size_t i = 0; i < obj->mesh.vertex_count; i++) {
        const struct obj_vector *vt = &file->vt[corner[i].vt];

        if (!scaled(vt, 0, bits, &obj->coordinates[i * 2]) ||
            !scaled(vt, 1, bits, &obj->coordinates[i * 2 + 1])) {
            return false;
        }
    }
    return true;
}

bool obj_coordinates(struct etch_obj *obj, const struct obj_file *file,
                     const struct obj_corner *corner)
{
    int bits = MOST_BITS;

    for (size_t i = 0; i < obj->mesh.vertex_count; i++) {
        if (corner[i].vt == OBJ_NONE) {
            return true;
        }
    }
    obj->coordinates = calloc(obj->mesh.vertex_count, 2 * sizeof *obj->coordinates);
    if (obj->coordinates == NULL) {
        return etch_error_set(file->text.error, file->text.path, 0, "out of memory");
    }
    while (!scale_all(obj, file, corner, bits)) {
        if (--bits < 0) {
            return etch_error_set(file->text.error, file->text.path, 0,
                                  "a texture coordinate is too large");
        }
    }
    obj->coordinate_bits = (uint8_t)bits;
    return true;
}
