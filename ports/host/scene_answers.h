/* ports/host/scene_answers.h: what feedback and select share; no part of the API. */
#ifndef ETCH_HOST_SCENE_ANSWERS_H
#define ETCH_HOST_SCENE_ANSWERS_H

#include "../../core/draw/feedback.h"
#include "../../core/draw/select.h"
#include "scene_steps.h"

/* Gives the scene's objects to the sink with names from 1; the kind of object that has the name
 * `*wanted` when all are drawn, "nothing" if none. */
const char *etch_scene_name_objects(const struct etch_scene *scene, struct etch_name_sink *names,
                                    const uint16_t *wanted);

/* What is left of the line and a step: an edge in a colour round the object that has pixel x, y;
 * the primitives in two colours. */
bool etch_scene_read_selected(struct etch_scene_reader *reader, int16_t x, int16_t y);
bool etch_scene_read_fed_back(struct etch_scene_reader *reader, const struct etch_feedback *f);

#endif
