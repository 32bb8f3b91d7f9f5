/* ports/host/text.h: text files as lines of words, with errors that name the line.
 *
 * Lines end with LF or CR LF, words are separated by blanks (space, tab, carriage return), `#`
 * starts a comment. Lines and files may be of any length; a NUL byte is an error. The first
 * error sticks: what follows fails without replacing it. */
#ifndef ETCH_HOST_TEXT_H
#define ETCH_HOST_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "decimal.h"

#if defined(__GNUC__)
#define ETCH_PRINTF(text, first) __attribute__((format(printf, text, first)))
#else
#define ETCH_PRINTF(text, first)
#endif

/* "file:line: what is wrong", without a newline; empty while nothing is. Line 0 is the file as
 * a whole. A text that does not fit is cut. */
struct etch_error {
    char text[4608];
};

/* Sets the error unless there is one. Returns false, for `return etch_error_set(..)`. */
bool etch_error_set(struct etch_error *error, const char *path, unsigned long line,
                    const char *format, ...) ETCH_PRINTF(4, 5);

struct etch_text {
    const char *path;         /* the caller's, for messages */
    struct etch_error *error; /* the caller's */
    char *data;               /* the whole file */
    size_t size;
    const char *next;     /* where the next line begins */
    const char *at, *end; /* what is left of this line */
    unsigned long line;   /* its number, from 1 */
    bool joins;           /* a backslash at the end of a line continues it on the next */
};

/* Reads a whole file into memory (at most 1 GiB). False if it cannot be read; there is nothing
 * to close then. */
bool etch_text_open(struct etch_text *text, const char *path, struct etch_error *error);

/* The same for a file that a line of another names, as `name`: if it cannot be read the error is
 * that line's. Errors go where those of `from` go. */
bool etch_text_open_named(struct etch_text *text, const char *path, const char *name,
                          struct etch_text *from);

/* Gives the memory back. */
void etch_text_close(struct etch_text *text);

/* Goes to the next line that has a word. False after the last, and on an error: error->text
 * is empty or not. */
bool etch_text_line(struct etch_text *text);

/* True if this line has another word; it is not taken. */
bool etch_text_more(struct etch_text *text);

/* Takes the next word of this line; `name` is for the message if there is none. */
bool etch_text_word(struct etch_text *text, const char *name, struct etch_word *word);

/* Takes an integer in least .. greatest. */
bool etch_text_integer(struct etch_text *text, const char *name, int64_t least, int64_t greatest,
                       int64_t *value);

/* Takes a decimal number as 16.16, rounded to the nearest. */
bool etch_text_q16(struct etch_text *text, const char *name, int32_t *value);

/* Takes one of the words of a NULL-terminated list; *index says which. */
bool etch_text_choice(struct etch_text *text, const char *name, const char *const *list,
                      int *index);

/* True if the line has no further word, an error if it has. */
bool etch_text_finished(struct etch_text *text);

/* An error on this line. Returns false. */
bool etch_text_fail(struct etch_text *text, const char *format, ...) ETCH_PRINTF(2, 3);

/* A word as it may stand in a message: at most 40 bytes, unprintable ones as `?`. Use as
 * "%s", etch_word_show(word).text. */
struct etch_shown {
    char text[48];
};
struct etch_shown etch_word_show(struct etch_word word);

/* True if the word is `text`. */
bool etch_word_is(struct etch_word word, const char *text);

#endif
