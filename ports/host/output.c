/* ports/host/output.c: writes the files that etch-sim was asked for, all or none. */
#define _POSIX_C_SOURCE 200809L
#include "output.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "file.h"

/* The outputs of one call. */
struct outputs {
    struct etch_output *output;
    size_t count;
};

etch_dump *etch_output_picture(const char *path)
{
    const size_t size = strlen(path);
    const char *end = size > 4 ? path + size - 4 : "";

    return strcmp(end, ".png") == 0   ? etch_dump_png
           : strcmp(end, ".ppm") == 0 ? etch_dump_ppm
                                      : NULL;
}

/* True for what a rename must not replace: a device, a pipe, a folder, an open file of /proc. */
static bool is_special(const char *target)
{
    struct stat status;
    return lstat(target, &status) == 0 && !S_ISREG(status.st_mode);
}

static bool is_place(const struct outputs *all, const char *name)
{
    for (size_t i = 0; i < all->count; i++) {
        if (all->output[i].path != NULL && etch_file_same(all->output[i].path, name)) {
            return true;
        }
    }
    return false;
}

/* How much of a target's path its part begins with: all but what would make a name too long. */
static int stem_size(const char *target)
{
    const char *slash = strrchr(target, '/');
    const size_t folder = slash != NULL ? (size_t)(slash + 1 - target) : 0;
    const size_t name = strlen(target + folder);

    return (int)(folder + (name < 200 ? name : 200));
}

/* Creates a file of a new name beside the target, which is nobody's and will be no output's. */
static int create_part(struct etch_output *o, const struct outputs *all)
{
    const size_t size = strlen(o->target) + sizeof ".99.part";
    int file = -1;

    o->part = malloc(size);
    errno = o->part != NULL ? EEXIST : ENOMEM;
    for (int i = 0; file < 0 && errno == EEXIST && i < 100; i++) {
        (void)snprintf(o->part, size, "%.*s.%d.part", stem_size(o->target), o->target, i);
        if (is_place(all, o->part)) {
            errno = EEXIST;
        } else {
            file = open(o->part, O_WRONLY | O_CREAT | O_EXCL, 0666);
        }
    }
    if (file < 0) {
        free(o->part); /* nothing to remove */
        o->part = NULL;
    }
    return file;
}

/* A file that may not be written is not replaced either. */
static bool may_replace(const char *target)
{
    return access(target, F_OK) != 0 || access(target, W_OK) == 0;
}

static bool dump_to(const struct etch_output *o, FILE *file)
{
    bool ok;

    if (file == NULL) {
        return false;
    }
    ok = o->dump(file, o->plane);
    return (fclose(file) == 0) & ok;
}

/* The passes: regular files to their parts, the others in place, then all parts to their names. */

static bool write_part(struct etch_output *o, const struct outputs *all)
{
    int file;

    o->target = etch_file_target(o->path);
    if (o->target == NULL) {
        return false;
    }
    if (is_special(o->target)) {
        return true;
    }
    file = may_replace(o->target) ? create_part(o, all) : -1;
    return file >= 0 && dump_to(o, fdopen(file, "wb"));
}

static bool write_in_place(struct etch_output *o, const struct outputs *all)
{
    (void)all;
    return o->part != NULL || dump_to(o, fopen(o->path, "wb"));
}

static bool place(struct etch_output *o, const struct outputs *all)
{
    (void)all;
    o->placed = o->part != NULL && rename(o->part, o->target) == 0;
    return o->placed || o->part == NULL;
}

/* Removes the parts that have not become files and forgets their names. */
static void clean_up(const struct outputs *all)
{
    for (size_t i = 0; i < all->count; i++) {
        struct etch_output *o = &all->output[i];

        if (o->part != NULL && !o->placed) {
            (void)remove(o->part);
        }
        free(o->part);
        free(o->target);
        o->part = o->target = NULL;
    }
}

bool etch_outputs_write(struct etch_output *output, size_t count, struct etch_error *error)
{
    static bool (*const passes[])(struct etch_output *,
                                  const struct outputs *) = {write_part, write_in_place, place};
    const struct outputs all = {output, count};
    bool ok = true;

    for (size_t pass = 0; pass < sizeof passes / sizeof passes[0]; pass++) {
        for (size_t i = 0; ok && i < count; i++) {
            errno = 0;
            if (output[i].path != NULL && !passes[pass](&output[i], &all)) {
                ok = etch_error_set(error, output[i].path, 0, "cannot write: %s",
                                    strerror(errno != 0 ? errno : ENOMEM));
            }
        }
    }
    clean_up(&all);
    return ok;
}
