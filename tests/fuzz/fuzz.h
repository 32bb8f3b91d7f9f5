/* tests/fuzz/fuzz.h: what the fuzz targets, their mutators and the replay have in common. See
 * README.md. */
#ifndef TESTS_FUZZ_FUZZ_H
#define TESTS_FUZZ_FUZZ_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* One run of a target (scene.c, calls.c) on any bytes. Returns 0; ends the program by fuzz_fail. */
int fuzz_one(const uint8_t *data, size_t size);

/* What the target wants to have been done once all inputs of a replay are through: NULL, or what is
 * missing. */
const char *fuzz_missing(void);

/* Ends the program with a report. */
_Noreturn void fuzz_fail(const char *why);

/* Planes of exactly `elements`, so that ASan sees what leaves them. */
struct fuzz_planes {
    uint16_t *pixels, *depth;
    uint8_t *stencil;
};
struct fuzz_planes fuzz_planes_open(size_t elements);
void fuzz_planes_close(struct fuzz_planes *planes);

#endif
