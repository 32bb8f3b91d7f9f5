/* vertex/material.c: the plain material. Called by the application. See lamp.h. */
#include "lamp.h"

void etch_material_init(struct etch_material *material)
{
    for (int k = 0; k < 3; k++) {
        material->ambient[k] = material->diffuse[k] = 255;
        material->specular[k] = material->emission[k] = 0;
    }
    material->shininess = 0;
}
