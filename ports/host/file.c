/* ports/host/file.c: files as a whole, and which file a name means. The readers, output.c and
 * etch-sim call it. See file.h. */
#define _POSIX_C_SOURCE 200809L
#include "file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define MAX_SIZE ((size_t)1 << 30)

/* ---- content --------------------------------------------------------------------------------- */

/* Reads to the end of the stream; NULL with errno set if that fails. */
static char *read_all(FILE *file, size_t *size)
{
    size_t capacity = 65536, used = 0;
    char *data = malloc(capacity);

    while (data != NULL) {
        char *more;

        used += fread(data + used, 1, capacity - used, file);
        if (used < capacity || capacity >= MAX_SIZE) {
            break;
        }
        capacity *= 2;
        more = realloc(data, capacity);
        if (more == NULL) {
            free(data);
        }
        data = more;
    }
    if (data == NULL || ferror(file) || used >= MAX_SIZE) {
        errno = data == NULL ? ENOMEM : ferror(file) ? errno : EFBIG;
        free(data);
        return NULL;
    }
    *size = used;
    return data;
}

char *etch_file_read(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    char *data;
    int reason;

    if (file == NULL) {
        return NULL;
    }
    errno = EIO;
    data = read_all(file, size);
    reason = errno;
    (void)fclose(file);
    errno = reason;
    return data;
}

/* ---- names ----------------------------------------------------------------------------------- */

bool etch_file_regular(const char *path)
{
    struct stat status;
    return stat(path, &status) == 0 && S_ISREG(status.st_mode);
}

/* The length of the folder in front of a name, its slash included; 0: the current one. */
static size_t folder_size(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash != NULL ? (size_t)(slash + 1 - path) : 0;
}

/* The first `size` bytes of a, then b. */
static char *join(const char *a, size_t size, const char *b)
{
    char *path = malloc(size + strlen(b) + 1);

    if (path != NULL) {
        memcpy(path, a, size);
        strcpy(path + size, b);
    }
    return path;
}

/* What a link says, as a path from where we are. */
static char *read_link(const char *path)
{
    char text[4096];
    const ssize_t size = readlink(path, text, sizeof text - 1);

    if (size < 0) {
        return NULL;
    }
    text[size] = '\0';
    return join(path, text[0] == '/' ? 0 : folder_size(path), text);
}

static bool is_link(const char *path)
{
    struct stat status;
    return lstat(path, &status) == 0 && S_ISLNK(status.st_mode);
}

char *etch_file_target(const char *path)
{
    char *target = join(path, strlen(path), "");

    for (int i = 0; i < 40 && target != NULL && is_link(target); i++) {
        char *next;

        if (strncmp(target, "/proc/", 6) == 0) {
            break;
        }
        next = read_link(target);
        free(target);
        target = next;
    }
    return target;
}

static bool same_node(const struct stat *a, const struct stat *b)
{
    return a->st_dev == b->st_dev && a->st_ino == b->st_ino;
}

/* True if two names of files that do not exist are the same name in the same folder. */
static bool same_place(const char *a, const char *b)
{
    const size_t size_a = folder_size(a), size_b = folder_size(b);
    char *folder_a = join(a, size_a, "."), *folder_b = join(b, size_b, ".");
    struct stat node_a, node_b;
    const bool same = strcmp(a + size_a, b + size_b) == 0 && folder_a != NULL && folder_b != NULL &&
                      stat(folder_a, &node_a) == 0 && stat(folder_b, &node_b) == 0 &&
                      same_node(&node_a, &node_b);

    free(folder_a);
    free(folder_b);
    return same || strcmp(a, b) == 0;
}

bool etch_file_same(const char *a, const char *b)
{
    struct stat node_a, node_b;
    const bool has_a = stat(a, &node_a) == 0, has_b = stat(b, &node_b) == 0;
    char *target_a, *target_b;
    bool same;

    if (has_a || has_b) {
        return has_a && has_b && same_node(&node_a, &node_b);
    }
    target_a = etch_file_target(a);
    target_b = etch_file_target(b);
    same = same_place(target_a != NULL ? target_a : a, target_b != NULL ? target_b : b);
    free(target_a);
    free(target_b);
    return same;
}
