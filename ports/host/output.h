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
    char *part;  /* where it is written before it gets its name; NULL: written in place */
    bool placed; /* it has its name */
};

/* Writes all outputs: regular files under another name first (PATH.part), which take their own
 * names once all are complete; what is not a regular file (a pipe, a device) in place. False,
 * with the reason in *error, if one fails: none of the files is left then. */
bool etch_outputs_write(struct etch_output *output, size_t count, struct etch_error *error);

/* The writer for a picture file by its name, NULL unless that ends in .png or .ppm. */
etch_dump *etch_output_picture(const char *path);

#endif
