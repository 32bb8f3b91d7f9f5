/* ports/host/output.h: several files that are written all or none. */
#ifndef ETCH_HOST_OUTPUT_H
#define ETCH_HOST_OUTPUT_H

#include "dump.h"
#include "text.h"

struct etch_output {
    const char *path; /* NULL: not wanted */
    etch_dump *dump;
    const struct etch_plane16 *plane;

    /* Private. */
    char *target; /* where the path's links lead */
    char *part;   /* where it is written before it gets its name; NULL: written in place */
    bool placed;  /* it has its name */
};

/* Writes all outputs. Files are written beside their places first, as PATH.N.part with the first
 * N that is free, and get their names, from older files too, once all outputs are complete; links
 * lead to the file that is replaced. What is not a file (a pipe, a device) is written in place.
 * False, with the reason in *error, if one cannot be written: files that were there before are
 * then as they were, and there are no new ones. (Should a complete file not get its name, those
 * before it keep theirs.) */
bool etch_outputs_write(struct etch_output *output, size_t count, struct etch_error *error);

/* The writer for a picture file by its name, NULL unless that ends in .png or .ppm. */
etch_dump *etch_output_picture(const char *path);

#endif
