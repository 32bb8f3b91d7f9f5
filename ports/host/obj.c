/* ports/host/obj.c: the lines of an OBJ file. The scene reader calls it; obj_mesh.c builds the
 * mesh from what is collected here. Format: Wavefront Technologies, Object Files, appendix B1
 * of the Advanced Visualizer manual. */
#include "obj.h"

#include <stdlib.h>
#include <string.h>

#include "array.h"
#include "obj_parts.h"

static bool no_memory(struct obj_file *file)
{
    return etch_text_fail(&file->text, "out of memory");
}

static bool read_number(struct obj_file *file, const char *name, struct etch_decimal *number)
{
    struct etch_word word;

    if (!etch_text_word(&file->text, name, &word)) {
        return false;
    }
    return etch_decimal_read(word, number) ||
           etch_text_fail(&file->text, "%s: \"%s\" is not a number", name,
                          etch_word_show(word).text);
}

/* Three numbers, appended to a list; what follows them must be numbers, at most `extra`. */
static bool read_vector(struct obj_file *file, struct obj_vector **list, size_t *capacity,
                        size_t *count, int extra)
{
    static const char *const names[] = {"x", "y", "z"};
    struct etch_decimal dropped;
    void *data = *list;

    if (*count >= OBJ_NONE - 1 || !etch_array_grow(&data, capacity, *count, sizeof **list)) {
        return no_memory(file);
    }
    *list = data;
    for (int i = 0; i < 3; i++) {
        if (!read_number(file, names[i], &(*list)[*count].c[i])) {
            return false;
        }
    }
    ++*count;
    for (; extra > 0 && etch_text_more(&file->text); extra--) {
        if (!read_number(file, "number", &dropped)) {
            return false;
        }
    }
    return true;
}

/* u [v [w]]; v is 0 where it is not given */
static bool read_texture_vertex(struct obj_file *file)
{
    static const struct obj_vector zero;
    void *data = file->vt;
    int n = 0;

    if (file->vt_count >= OBJ_NONE - 1 ||
        !etch_array_grow(&data, &file->vt_capacity, file->vt_count, sizeof *file->vt)) {
        return no_memory(file);
    }
    file->vt = data;
    file->vt[file->vt_count] = zero;
    do {
        if (!read_number(file, "u", &file->vt[file->vt_count].c[n])) {
            return false;
        }
    } while (++n < 3 && etch_text_more(&file->text));
    file->vt_count++;
    return true;
}

/* An index of a corner to a place from 0: 1 is the first, -1 the latest of `count`. */
static bool take_index(struct obj_file *file, const char *name, struct etch_word word, size_t count,
                       uint32_t *place)
{
    int64_t index;

    if (!etch_integer_read(word, &index)) {
        return etch_text_fail(&file->text, "%s: \"%s\" is not an index", name,
                              etch_word_show(word).text);
    }
    if (index == 0 || index > (int64_t)count || index < -(int64_t)count) {
        return etch_text_fail(&file->text, "%s: there is no %s of %zu so far", name,
                              etch_word_show(word).text, count);
    }
    *place = (uint32_t)(index > 0 ? index - 1 : (int64_t)count + index);
    return true;
}

/* v, v/vt, v//vn or v/vt/vn */
static bool read_corner(struct obj_file *file, struct obj_corner *corner)
{
    struct etch_word word, part[3] = {{NULL, 0}, {NULL, 0}, {NULL, 0}};
    int n = 0;

    if (!etch_text_word(&file->text, "corner", &word)) {
        return false;
    }
    part[0].text = word.text;
    for (size_t i = 0; i < word.size; i++) {
        if (word.text[i] != '/') {
            part[n].size++;
        } else if (++n < 3) {
            part[n].text = word.text + i + 1;
        } else {
            return etch_text_fail(&file->text, "\"%s\" is not v/vt/vn", etch_word_show(word).text);
        }
    }
    if ((n == 1 && part[1].size == 0) || (n == 2 && part[2].size == 0)) {
        return etch_text_fail(&file->text, "\"%s\" ends early", etch_word_show(word).text);
    }
    corner->vt = corner->vn = OBJ_NONE;
    return take_index(file, "v", part[0], file->v_count, &corner->v) &&
           (part[1].size == 0 || take_index(file, "vt", part[1], file->vt_count, &corner->vt)) &&
           (part[2].size == 0 || take_index(file, "vn", part[2], file->vn_count, &corner->vn));
}

static bool append_triangle(struct obj_file *file, const struct obj_corner corner[3])
{
    void *data = file->corner;

    if (file->corner_count >= (size_t)OBJ_MAX_TRIANGLES * 3) {
        return etch_text_fail(&file->text, "more than %d triangles", OBJ_MAX_TRIANGLES);
    }
    for (int i = 0; i < 3; i++) {
        if (!etch_array_grow(&data, &file->corner_capacity, file->corner_count,
                             sizeof *file->corner)) {
            return no_memory(file);
        }
        file->corner = data;
        file->corner[file->corner_count++] = corner[i];
    }
    return true;
}

/* A polygon, as a fan from its first corner. */
static bool read_face(struct obj_file *file)
{
    struct obj_corner corner[3];

    for (int i = 0; i < 3; i++) {
        if (!read_corner(file, &corner[i])) {
            return false;
        }
    }
    while (append_triangle(file, corner)) {
        if (!etch_text_more(&file->text)) {
            return true;
        }
        corner[1] = corner[2];
        if (!read_corner(file, &corner[2])) {
            return false;
        }
    }
    return false;
}

/* The rest of a statement that says nothing about shape. */
static bool skip(struct obj_file *file, struct etch_word word)
{
    static const char *const skipped[] = {"g", "o", "s", "usemtl", "mtllib", "l", "p", NULL};

    for (int i = 0; skipped[i] != NULL; i++) {
        if (etch_word_is(word, skipped[i])) {
            file->text.at = file->text.end;
            return true;
        }
    }
    return etch_text_fail(&file->text, "unknown statement \"%s\"", etch_word_show(word).text);
}

static bool read_line(struct obj_file *file)
{
    struct etch_word word;
    bool ok;

    if (!etch_text_word(&file->text, "statement", &word)) {
        return false;
    }
    if (etch_word_is(word, "v")) { /* w, or a colour, may follow */
        ok = read_vector(file, &file->v, &file->v_capacity, &file->v_count, 4);
    } else if (etch_word_is(word, "vn")) {
        ok = read_vector(file, &file->vn, &file->vn_capacity, &file->vn_count, 0);
    } else if (etch_word_is(word, "vt")) {
        ok = read_texture_vertex(file);
    } else if (etch_word_is(word, "f")) {
        ok = read_face(file);
    } else {
        ok = skip(file, word);
    }
    return ok && etch_text_finished(&file->text);
}

bool etch_obj_read(struct etch_obj *obj, struct etch_text *text)
{
    struct obj_file file = {.text = *text};
    bool ok = true;

    *obj = (struct etch_obj){.scale = 0};
    file.text.joins = true;
    while (ok && etch_text_line(&file.text)) {
        ok = read_line(&file);
    }
    ok = ok && text->error->text[0] == '\0' && obj_build(obj, &file);
    etch_text_close(&file.text);
    text->data = NULL;
    free(file.v);
    free(file.vn);
    free(file.vt);
    free(file.corner);
    if (!ok) {
        etch_obj_close(obj);
    }
    return ok;
}

bool etch_obj_open(struct etch_obj *obj, const char *path, struct etch_error *error)
{
    struct etch_text text;

    *obj = (struct etch_obj){.scale = 0};
    error->text[0] = '\0';
    return etch_text_open(&text, path, error) && etch_obj_read(obj, &text);
}

void etch_obj_close(struct etch_obj *obj)
{
    free(obj->positions);
    free(obj->normals);
    free(obj->coordinates);
    free(obj->indices);
    *obj = (struct etch_obj){.scale = 0};
}
