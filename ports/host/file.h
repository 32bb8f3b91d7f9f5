/* ports/host/file.h: files as a whole, and which file a name means. */
#ifndef ETCH_HOST_FILE_H
#define ETCH_HOST_FILE_H

#include <stdbool.h>
#include <stddef.h>

/* Reads a file of at most 1 GiB into memory from malloc. NULL if that fails: errno says why. */
char *etch_file_read(const char *path, size_t *size);

/* True if both names lead to one file, by whatever spelling or link. Files that do not exist yet
 * are compared by folder and name. */
bool etch_file_same(const char *a, const char *b);

/* True for an existing regular file: one whose content can be lost. */
bool etch_file_regular(const char *path);

/* Where a name leads when its links are followed, from malloc; the file need not exist. Links
 * of /proc, as /dev/stdout is one, are not followed: they are open files, not names. NULL, with
 * errno set, without memory or where a link cannot be read. */
char *etch_file_target(const char *path);

#endif
