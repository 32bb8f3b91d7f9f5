/* ports/host/output.c: writes the files that etch-sim was asked for, all or none. */
#define _POSIX_C_SOURCE 200809L
#include "output.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

etch_dump *etch_output_picture(const char *path)
{
    const size_t size = strlen(path);
    const char *end = size > 4 ? path + size - 4 : "";

    return strcmp(end, ".png") == 0   ? etch_dump_png
           : strcmp(end, ".ppm") == 0 ? etch_dump_ppm
                                      : NULL;
}

/* True for what a rename must not replace: a device, a pipe, a folder, a link to something. */
static bool is_special(const char *path)
{
    struct stat status;
    return lstat(path, &status) == 0 && !S_ISREG(status.st_mode);
}

/* Sets output->part; false without memory. */
static bool choose_part(struct etch_output *o)
{
    static const char suffix[] = ".part";
    const size_t size = strlen(o->path);

    if (is_special(o->path)) {
        return true;
    }
    o->part = malloc(size + sizeof suffix);
    if (o->part == NULL) {
        return false;
    }
    memcpy(o->part, o->path, size);
    memcpy(o->part + size, suffix, sizeof suffix);
    return true;
}

static bool write_one(struct etch_output *o)
{
    FILE *file;
    bool ok;

    errno = 0;
    if (!choose_part(o)) {
        return false;
    }
    file = fopen(o->part != NULL ? o->part : o->path, "wb");
    if (file == NULL) {
        free(o->part);
        o->part = NULL; /* nothing to remove */
        return false;
    }
    ok = o->dump(file, o->plane);
    return (fclose(file) == 0) & ok;
}

static bool place(struct etch_output *o)
{
    if (o->part != NULL && rename(o->part, o->path) != 0) {
        return false;
    }
    o->placed = o->part != NULL;
    return true;
}

/* Removes the files that were begun and forgets their other names. */
static void clean_up(struct etch_output *output, size_t count, bool ok)
{
    for (size_t i = 0; i < count; i++) {
        if (!ok && output[i].part != NULL) {
            (void)remove(output[i].placed ? output[i].path : output[i].part);
        }
        free(output[i].part);
        output[i].part = NULL;
    }
}

bool etch_outputs_write(struct etch_output *output, size_t count, struct etch_error *error)
{
    bool (*const passes[])(struct etch_output *) = {write_one, place};
    bool ok = true;

    for (size_t pass = 0; pass < 2; pass++) {
        for (size_t i = 0; ok && i < count; i++) {
            if (output[i].path != NULL && !passes[pass](&output[i])) {
                ok = etch_error_set(error, output[i].path, 0, "cannot write: %s",
                                    strerror(errno != 0 ? errno : ENOMEM));
            }
        }
    }
    clean_up(output, count, ok);
    return ok;
}
