/* tests/fuzz: the corpus through a target without libFuzzer, by any compiler.
 *
 *      replay PACK            runs every input of the packed corpus, and seeded noise
 *      replay PACK FOLDER     writes every input to a file of the folder
 *      replay PACK - FILE ..  packs the files
 *      replay FILE            an input that libFuzzer reported, if it is no pack
 *
 * A pack is "etchpack", then for each input its size in four bytes, low byte first, and the input.
 * */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"

#define MOST_INPUT 4096
#define NOISE                                                                                      \
    3000 /* seeded inputs, so that every row of calls.c is called whatever the corpus has */

static const char magic[8] = "etchpack";
static uint8_t input[MOST_INPUT];

static void stop(const char *why, const char *name)
{
    (void)fprintf(stderr, "replay: %s: %s\n", why, name);
    exit(2);
}

static FILE *open_file(const char *name, const char *mode)
{
    FILE *file = fopen(name, mode);

    if (file == NULL) {
        stop("cannot open", name);
    }
    return file;
}

/* The next input of a pack; false at its end. */
static bool next(FILE *pack, size_t *size)
{
    uint8_t head[4];

    if (fread(head, 1, 4, pack) != 4) {
        return false;
    }
    *size = head[0] | (size_t)head[1] << 8 | (size_t)head[2] << 16 | (size_t)head[3] << 24;
    if (*size > MOST_INPUT || fread(input, 1, *size, pack) != *size) {
        stop("broken", "pack");
    }
    return true;
}

static void write_file(const char *folder, long number, size_t size)
{
    char name[512];
    FILE *file;

    (void)snprintf(name, sizeof name, "%s/%05ld", folder, number);
    file = open_file(name, "wb");
    if (fwrite(input, 1, size, file) != size || fclose(file) != 0) {
        stop("cannot write", name);
    }
}

static void pack_files(const char *name, char **files)
{
    FILE *pack = open_file(name, "wb");

    (void)fwrite(magic, 1, sizeof magic, pack);
    for (; *files != NULL; files++) {
        FILE *file = open_file(*files, "rb");
        const size_t size = fread(input, 1, MOST_INPUT, file);
        const uint8_t head[4] = {(uint8_t)(size & 255), (uint8_t)(size >> 8 & 255), 0, 0};

        (void)fwrite(head, 1, 4, pack);
        (void)fwrite(input, 1, size, pack);
        (void)fclose(file);
    }
    if (fclose(pack) != 0) {
        stop("cannot write", name);
    }
}

/* Bytes of a xorshift. */
static void noise(void)
{
    uint64_t state = 88172645463325252U;

    for (int i = 0; i < NOISE; i++) {
        for (size_t k = 0; k < 640; k++) {
            state ^= state >> 7;
            state ^= (state & 0x7FFFFFFFFFFFFF) << 9;
            input[k] = (uint8_t)(state >> 24 & 255);
        }
        (void)fuzz_one(input, 640);
    }
}

static int replay(FILE *pack)
{
    const char *missing;
    size_t size;
    long n = 0;

    while (next(pack, &size)) {
        (void)fuzz_one(input, size);
        n++;
    }
    noise();
    missing = fuzz_missing();
    if (missing != NULL || n == 0) {
        (void)printf("FAIL nothing calls %s\n", missing != NULL ? missing : "the corpus");
        return 1;
    }
    (void)printf("%ld inputs and %d of noise\n", n, NOISE);
    return 0;
}

int main(int count, char **words)
{
    char head[sizeof magic];
    FILE *file;

    if (count < 2) {
        stop("what?", "replay PACK [FOLDER | - FILE ..]");
    }
    if (count > 2 && strcmp(words[2], "-") == 0) {
        pack_files(words[1], words + 3);
        return 0;
    }
    file = open_file(words[1], "rb");
    if (fread(head, 1, sizeof head, file) != sizeof head || memcmp(head, magic, sizeof head) != 0) {
        rewind(file);
        return fuzz_one(input, fread(input, 1, MOST_INPUT, file));
    }
    if (count == 2) {
        return replay(file);
    }
    for (size_t size, n = 0; next(file, &size); n++) {
        write_file(words[2], (long)n, size);
    }
    return 0;
}
