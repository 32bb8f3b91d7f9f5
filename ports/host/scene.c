/* ports/host/scene.c: opens and closes scenes; hands each line to its statement. etch-sim and
 * the tests call it. */
#include "scene.h"

#include <stdlib.h>
#include <string.h>

#include "array.h"
#include "scene_steps.h"

struct etch_scene_step *etch_scene_append(struct etch_scene_reader *reader,
                                          const struct etch_scene_statement *statement)
{
    struct etch_scene *scene = reader->scene;
    struct etch_scene_step *step;
    void *steps = scene->step;

    if (!etch_array_grow(&steps, &scene->capacity, scene->count, sizeof *step)) {
        (void)etch_text_fail(&reader->text, "out of memory");
        return NULL;
    }
    scene->step = steps;
    step = &scene->step[scene->count++];
    memset(step, 0, sizeof *step);
    step->statement = statement;
    return step;
}

void *etch_scene_data(struct etch_scene_reader *reader, size_t size)
{
    struct etch_scene *scene = reader->scene;
    void *list = scene->data;
    void *data = NULL;

    if (etch_array_grow(&list, &scene->data_capacity, scene->data_count, sizeof *scene->data)) {
        scene->data = list;
        data = calloc(1, size);
    }
    if (data == NULL) {
        (void)etch_text_fail(&reader->text, "out of memory");
        return NULL;
    }
    scene->data[scene->data_count++] = data;
    return data;
}

int16_t *etch_scene_covers(struct etch_scene_reader *reader)
{
    return etch_scene_data(reader, ((size_t)reader->scene->width + 2) * sizeof(int16_t));
}

bool etch_scene_read_byte(struct etch_scene_reader *reader, const char *name, uint8_t *value)
{
    int64_t number;

    if (!etch_text_integer(&reader->text, name, 0, 255, &number)) {
        return false;
    }
    *value = (uint8_t)number;
    return true;
}

bool etch_scene_read_rgb(struct etch_scene_reader *reader, uint8_t rgb[3])
{
    return etch_scene_read_byte(reader, "r", &rgb[0]) &&
           etch_scene_read_byte(reader, "g", &rgb[1]) && etch_scene_read_byte(reader, "b", &rgb[2]);
}

bool etch_scene_take(struct etch_scene_reader *reader, const char *name)
{
    struct etch_text ahead = reader->text;
    struct etch_word word;

    if (!etch_text_more(&ahead) || !etch_text_word(&ahead, name, &word) ||
        !etch_word_is(word, name)) {
        return false;
    }
    reader->text = ahead;
    return true;
}

/* Keeps the name of a file, from malloc, as the scene's. */
static bool add_file(struct etch_scene *scene, char *path)
{
    void *list = scene->file;

    if (path == NULL ||
        !etch_array_grow(&list, &scene->file_capacity, scene->file_count, sizeof *scene->file)) {
        free(path);
        return false;
    }
    scene->file = list;
    scene->file[scene->file_count++] = path;
    return true;
}

const char *etch_scene_path(struct etch_scene_reader *reader, const char **name)
{
    const char *scene = reader->text.path;
    const char *slash = strrchr(scene, '/');
    struct etch_word word;
    size_t folder;
    char *path;

    if (!etch_text_word(&reader->text, "file", &word)) {
        return NULL;
    }
    folder = slash != NULL && word.text[0] != '/' ? (size_t)(slash + 1 - scene) : 0;
    path = malloc(folder + word.size + 1);
    if (path != NULL) {
        memcpy(path, scene, folder);
        memcpy(path + folder, word.text, word.size);
        path[folder + word.size] = '\0';
    }
    if (!add_file(reader->scene, path)) {
        (void)etch_text_fail(&reader->text, "out of memory");
        return NULL;
    }
    *name = path + folder;
    return path;
}

static const struct etch_scene_statement *find_statement(struct etch_word word)
{
    static const struct etch_scene_statement *const tables[] = {
        etch_scene_frame_statements,    etch_scene_shape_statements,
        etch_scene_state_statements,    etch_scene_triangle_statements,
        etch_scene_view_statements,     etch_scene_mesh_statements,
        etch_scene_line_statements,     etch_scene_line_clip_statements,
        etch_scene_line_2d_statements,  etch_scene_pass_statements,
        etch_scene_polygon_statements,  etch_scene_path_statements,
        etch_scene_implicit_statements, etch_scene_sorted_statements,
        etch_scene_light_statements,    etch_scene_elements_statements,
        etch_scene_text_statements,     etch_scene_answer_statements,
        etch_scene_image_statements,    etch_scene_images_statements,
        etch_scene_toolkit_statements,  etch_scene_fill_statements,
        etch_scene_brush_statements,    etch_scene_shader_statements,
        etch_scene_soft_statements,
    };

    for (size_t i = 0; i < sizeof tables / sizeof tables[0]; i++) {
        for (const struct etch_scene_statement *s = tables[i]; s->name != NULL; s++) {
            if (etch_word_is(word, s->name)) {
                return s;
            }
        }
    }
    return NULL;
}

static bool read_line(struct etch_scene_reader *reader)
{
    const struct etch_scene_statement *statement;
    struct etch_word word;

    if (!etch_text_word(&reader->text, "statement", &word)) {
        return false;
    }
    statement = find_statement(word);
    if (statement == NULL) {
        return etch_text_fail(&reader->text, "unknown statement \"%s\"", etch_word_show(word).text);
    }
    if (reader->scene->width == 0 && strcmp(statement->name, "scene") != 0) {
        return etch_text_fail(&reader->text, "the first statement must be \"scene W H\"");
    }
    return statement->read(reader, statement) && etch_text_finished(&reader->text);
}

/* The state and view that README.md promises at the start of a scene. */
static void set_defaults(struct etch_scene_reader *reader)
{
    const struct etch_scene_view view = {
        .target = {0, 0, -ETCH_Q16_ONE},
        .up = {0, ETCH_Q16_ONE, 0},
        .angle_of_view = 45 * ETCH_Q16_ONE,
        .near = ETCH_Q16_ONE,
        .far = 100 * ETCH_Q16_ONE,
        .ambient = {51, 51, 51},
        .material = {255, 255, 255, 255},
    };

    reader->state = (struct etch_scene_state){
        .persp = 1, .zwrite = 1, .stencil_write = UINT8_MAX, .color_mask = UINT16_MAX};
    reader->view = view;
    etch_matrix_identity(&reader->view.model);
    etch_material_init(&reader->view.surface);
}

static bool open_as(struct etch_scene *scene, const char *path, int format,
                    const struct etch_scene_modes *modes, struct etch_error *error)
{
    struct etch_scene_reader *reader = calloc(1, sizeof *reader);
    bool ok;

    *scene = (struct etch_scene){.modes = modes};
    error->text[0] = '\0';
    if (reader == NULL) {
        return etch_error_set(error, path, 0, "out of memory");
    }
    reader->scene = scene;
    set_defaults(reader);
    ok = etch_text_open(&reader->text, path, error);
    while (ok && etch_text_line(&reader->text)) {
        ok = read_line(reader);
    }
    ok = ok && error->text[0] == '\0';
    if (ok && reader->sorted != NULL) {
        ok = etch_error_set(error, path, 0, "\"sorted\" without \"end\"");
    }
    if (ok && reader->elements != NULL) {
        ok = etch_error_set(error, path, 0, "\"list\" without \"endlist\"");
    }
    if (ok && scene->width == 0) {
        ok = etch_error_set(error, path, 0, "no statement: the first must be \"scene W H\"");
    }
    etch_text_close(&reader->text);
    free(reader);
    if (ok) {
        scene->format = format >= 0 ? (uint8_t)format : scene->format;
        if (scene->passes == NULL) { /* passes draw in rgb565 */
            etch_scene_textures_finish(scene);
        }
    } else {
        etch_scene_close(scene);
    }
    return ok;
}

bool etch_scene_open(struct etch_scene *scene, const char *path, struct etch_error *error)
{
    return etch_scene_open_in(scene, path, -1, error);
}

bool etch_scene_open_in(struct etch_scene *scene, const char *path, int format,
                        struct etch_error *error)
{
    return open_as(scene, path, format, NULL, error);
}

bool etch_scene_open_modes(struct etch_scene *scene, const char *path,
                           const struct etch_scene_modes *modes, struct etch_error *error)
{
    return open_as(scene, path, -1, modes, error);
}

void etch_scene_close(struct etch_scene *scene)
{
    for (size_t i = 0; i < scene->mesh_count; i++) {
        etch_scene_mesh_free(scene->mesh[i]);
    }
    free(scene->mesh);
    etch_scene_textures_free(scene);
    for (size_t i = 0; i < scene->file_count; i++) {
        free(scene->file[i]);
    }
    free(scene->file);
    etch_scene_passes_free(scene->passes);
    for (size_t i = 0; i < scene->data_count; i++) {
        free(scene->data[i]);
    }
    free(scene->data);
    free(scene->step);
    *scene = (struct etch_scene){0};
}
