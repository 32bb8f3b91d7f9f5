/* ports/host/scene_elements.h: primitives from lists of vertices; no part of the API. */
#ifndef ETCH_HOST_SCENE_ELEMENTS_H
#define ETCH_HOST_SCENE_ELEMENTS_H

#include "scene_steps.h"

/* Hands the primitives of a step of `list` to a sink: points, lines or triangles. */
void etch_scene_elements_assemble(const struct etch_scene_step *step, struct etch_sink *sink);

#endif
