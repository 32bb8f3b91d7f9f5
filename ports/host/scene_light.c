/* ports/host/scene_light.c: the statements that say how the next mesh is lit. scene.c finds them by
 * name, scene_mesh.c reads what they set. */
#include "scene_steps.h"

static bool read_vector(struct etch_scene_reader *reader, struct etch_vector *v)
{
    return etch_text_q16(&reader->text, "x", &v->x) && etch_text_q16(&reader->text, "y", &v->y) &&
           etch_text_q16(&reader->text, "z", &v->z);
}

static bool read_ambient(struct etch_scene_reader *reader,
                         const struct etch_scene_statement *statement)
{
    (void)statement;
    return etch_scene_read_rgb(reader, reader->view.ambient);
}

/* off; or [point] x y z, the way towards it or its place, r g b: one more light */
static bool read_light(struct etch_scene_reader *reader,
                       const struct etch_scene_statement *statement)
{
    struct etch_scene_view *view = &reader->view;
    struct etch_vector *place = &view->light_towards[view->light_count];
    struct etch_lamp *lamp = &view->lamp[view->light_count];

    (void)statement;
    if (etch_scene_take(reader, "off")) {
        view->light_count = 0;
        return true;
    }
    if (view->light_count == ETCH_SCENE_LIGHTS) {
        return etch_text_fail(&reader->text, "more than %d lights", ETCH_SCENE_LIGHTS);
    }
    *lamp = (struct etch_lamp){.constant = ETCH_Q16_ONE};
    lamp->kind = etch_scene_take(reader, "point") ? etch_lamp_point : etch_lamp_directional;
    if (!read_vector(reader, place) ||
        !etch_scene_read_rgb(reader, view->light_color[view->light_count])) {
        return false;
    }
    lamp->place = *place;
    if (lamp->kind == etch_lamp_directional && etch_lamp_aim(lamp, place) != ETCH_OK) {
        return etch_text_fail(&reader->text, "a light needs a direction");
    }
    view->lamps |= lamp->kind == etch_lamp_point;
    for (int k = 0; k < 3; k++) {
        lamp->diffuse[k] = lamp->specular[k] = view->light_color[view->light_count][k];
    }
    view->light_count++;
    return true;
}

/* constant linear quadratic, of the latest light */
static bool read_attenuation(struct etch_scene_reader *reader,
                             const struct etch_scene_statement *statement)
{
    struct etch_scene_view *view = &reader->view;
    struct etch_lamp *lamp = view->light_count != 0 ? &view->lamp[view->light_count - 1] : NULL;

    (void)statement;
    if (lamp == NULL || lamp->kind == etch_lamp_directional) {
        return etch_text_fail(&reader->text, "attenuation follows a \"light point\"");
    }
    lamp->kind = etch_lamp_attenuated;
    if (!etch_text_q16(&reader->text, "constant", &lamp->constant) ||
        !etch_text_q16(&reader->text, "linear", &lamp->linear) ||
        !etch_text_q16(&reader->text, "quadratic", &lamp->quadratic)) {
        return false;
    }
    return (lamp->constant >= 0 && lamp->linear >= 0 && lamp->quadratic >= 0) ||
           etch_text_fail(&reader->text, "attenuation must not be negative");
}

/* r g b shininess [phong|blinn] */
static bool read_specular(struct etch_scene_reader *reader)
{
    struct etch_scene_view *view = &reader->view;

    if (!etch_scene_read_rgb(reader, view->surface.specular) ||
        !etch_scene_read_byte(reader, "shininess", &view->surface.shininess)) {
        return false;
    }
    view->blinn = etch_scene_take(reader, "blinn");
    return view->blinn || !etch_text_more(&reader->text) || etch_scene_take(reader, "phong") ||
           etch_text_fail(&reader->text, "specular light is phong or blinn");
}

/* ambient|diffuse|emission r g b, specular .., or r g b [a]: the mesh's colour */
static bool read_material(struct etch_scene_reader *reader,
                          const struct etch_scene_statement *statement)
{
    struct etch_scene_view *view = &reader->view;
    const struct {
        const char *name;
        uint8_t *rgb;
    } part[] = {{"ambient", view->surface.ambient},
                {"diffuse", view->surface.diffuse},
                {"emission", view->surface.emission}};

    (void)statement;
    for (size_t i = 0; i < sizeof part / sizeof part[0]; i++) {
        if (etch_scene_take(reader, part[i].name)) {
            view->lamps = true;
            return etch_scene_read_rgb(reader, part[i].rgb);
        }
    }
    if (etch_scene_take(reader, "specular")) {
        view->lamps = true;
        return read_specular(reader);
    }
    view->material[3] = 255;
    return etch_scene_read_rgb(reader, view->material) &&
           (!etch_text_more(&reader->text) ||
            etch_scene_read_byte(reader, "a", &view->material[3]));
}

const struct etch_scene_statement etch_scene_light_statements[] = {
    {"ambient", read_ambient, NULL, NULL, NULL},
    {"light", read_light, NULL, NULL, NULL},
    {"attenuation", read_attenuation, NULL, NULL, NULL},
    {"material", read_material, NULL, NULL, NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
