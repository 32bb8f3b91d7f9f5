/* ports/host/scene_texture.c: the texture statement. It is checked and dropped: nothing draws
 * with a texture yet. scene.c finds it by name. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene_steps.h"

static bool is_texel(struct etch_word word)
{
    for (size_t i = 0; i < word.size; i++) {
        const char c = word.text[i];

        if (!((c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'))) {
            return false;
        }
    }
    return word.size == 8;
}

/* W H RRGGBBAA .. */
static bool read_texels(struct etch_scene_reader *reader)
{
    struct etch_word word;
    int64_t width, height;

    if (!etch_text_integer(&reader->text, "width", 1, 32767, &width) ||
        !etch_text_integer(&reader->text, "height", 1, 32767, &height)) {
        return false;
    }
    for (int64_t i = 0; i < width * height; i++) {
        if (!etch_text_word(&reader->text, "texel", &word)) {
            return false;
        }
        if (!is_texel(word)) {
            return etch_text_fail(&reader->text, "texel %lld: \"%s\" is not RRGGBBAA", (long long)i,
                                  etch_word_show(word).text);
        }
    }
    return true;
}

/* ppm FILE, a binary PPM of 8 bits a channel. */
static bool read_ppm(struct etch_scene_reader *reader)
{
    const char *path, *name;
    FILE *file;
    int width, height, depth;
    bool ok;

    path = etch_scene_path(reader, &name);
    if (path == NULL) {
        return false;
    }
    file = fopen(path, "rb");
    if (file == NULL) {
        ok = etch_text_fail(&reader->text, "cannot open %s: %s", name, strerror(errno));
    } else {
        ok = fscanf(file, "P6 %5d %5d %5d", &width, &height, &depth) == 3 && width > 0 &&
             height > 0 && width <= 32767 && height <= 32767 && depth == 255;
        (void)(ok || etch_text_fail(&reader->text, "%s is not a P6 file of 8 bits", path));
        (void)fclose(file);
    }
    return ok;
}

bool etch_scene_read_texture(struct etch_scene_reader *reader,
                             const struct etch_scene_statement *statement)
{
    (void)statement;
    return etch_scene_take(reader, "ppm") ? read_ppm(reader) : read_texels(reader);
}
