/* ports/host/options.h: etch-sim's command line, read and checked. */
#ifndef ETCH_HOST_OPTIONS_H
#define ETCH_HOST_OPTIONS_H

#include "screen.h"

struct etch_options {
    /* As given; NULL: not. */
    const char *scene, *picture, *raw, *depth, *stencil, *port, *strip;
    const char *turn, *mirror, *buffers, *clock, *lanes;
    bool stats, needs, help;

    /* Read from them. */
    int32_t rows; /* of a strip; 0: as the scene or the port has it */
    struct etch_screen_panel panel;
};

/* 0, or the exit status of a wrong command line, about which stderr has been told. */
int etch_options_read(struct etch_options *options, int count, char **words);

/* Tells stderr what is wrong about the command line, and its usage; the exit status. */
int etch_options_wrong(const char *what, const char *word);

/* The usage, with the ports there are. */
void etch_options_print(void);

#endif
