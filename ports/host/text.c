/* ports/host/text.c: lines and words of a text file. The scene and OBJ readers call it. */
#include "text.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "file.h"

static bool set_error(struct etch_error *error, const char *path, unsigned long line,
                      const char *format, va_list arguments)
{
    if (error->text[0] == '\0') {
        const size_t size = sizeof error->text;
        const int used = snprintf(error->text, size, "%.4000s:%lu: ", path, line);

        (void)vsnprintf(error->text + used, size - (size_t)used, format, arguments);
    }
    return false;
}

bool etch_error_set(struct etch_error *error, const char *path, unsigned long line,
                    const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    (void)set_error(error, path, line, format, arguments);
    va_end(arguments);
    return false;
}

bool etch_text_fail(struct etch_text *text, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    (void)set_error(text->error, text->path, text->line, format, arguments);
    va_end(arguments);
    return false;
}

/* Takes the file; false if there is none, with errno set. */
static bool load(struct etch_text *text, const char *path, struct etch_error *error)
{
    *text = (struct etch_text){.path = path, .error = error};
    text->data = etch_file_read(path, &text->size);
    text->next = text->at = text->end = text->data;
    return text->data != NULL;
}

bool etch_text_open(struct etch_text *text, const char *path, struct etch_error *error)
{
    return load(text, path, error) ||
           etch_error_set(error, path, 0, "cannot open: %s", strerror(errno));
}

bool etch_text_open_named(struct etch_text *text, const char *path, const char *name,
                          struct etch_text *from)
{
    return load(text, path, from->error) ||
           etch_text_fail(from, "cannot open %s: %s", name, strerror(errno));
}

void etch_text_close(struct etch_text *text)
{
    free(text->data);
    text->data = NULL;
}

static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

/* The end of the line that starts at `from`: its LF or the end of the file. */
static char *line_end(const struct etch_text *text, const char *from)
{
    char *start = text->data + (from - text->data);
    const size_t left = text->size - (size_t)(from - text->data);
    char *end = memchr(start, '\n', left);

    return end != NULL ? end : start + left;
}

/* Makes one line of this one and those that a backslash at its end continues it with. */
static char *join_lines(struct etch_text *text, char *end)
{
    const char *last = text->data + text->size;

    while (text->joins && end != last) {
        char *back = end;

        while (back != text->next && is_blank(back[-1])) {
            back--;
        }
        if (back == text->next || back[-1] != '\\') {
            break;
        }
        back[-1] = ' ';
        *end = ' ';
        end = line_end(text, end);
        text->line++;
    }
    return end;
}

bool etch_text_line(struct etch_text *text)
{
    const char *last = text->data + text->size;

    while (text->next != last && text->error->text[0] == '\0') {
        char *end = line_end(text, text->next);
        const char *comment;

        text->line++;
        end = join_lines(text, end);
        if (memchr(text->next, '\0', (size_t)(end - text->next)) != NULL) {
            return etch_text_fail(text, "a NUL byte: this is not a text file");
        }
        comment = memchr(text->next, '#', (size_t)(end - text->next));
        text->at = text->next;
        text->end = comment != NULL ? comment : end;
        text->next = end == last ? last : end + 1;
        if (etch_text_more(text)) {
            return true;
        }
    }
    return false;
}

bool etch_text_more(struct etch_text *text)
{
    while (text->at != text->end && is_blank(*text->at)) {
        text->at++;
    }
    return text->at != text->end;
}

bool etch_text_word(struct etch_text *text, const char *name, struct etch_word *word)
{
    if (!etch_text_more(text)) {
        return etch_text_fail(text, "%s is missing", name);
    }
    word->text = text->at;
    while (text->at != text->end && !is_blank(*text->at)) {
        text->at++;
    }
    word->size = (size_t)(text->at - word->text);
    return true;
}

bool etch_text_finished(struct etch_text *text)
{
    struct etch_word word;

    if (!etch_text_more(text)) {
        return true;
    }
    return etch_text_word(text, "", &word) &&
           etch_text_fail(text, "unexpected \"%s\"", etch_word_show(word).text);
}

bool etch_text_integer(struct etch_text *text, const char *name, int64_t least, int64_t greatest,
                       int64_t *value)
{
    struct etch_word word;

    if (!etch_text_word(text, name, &word)) {
        return false;
    }
    if (!etch_integer_read(word, value) || *value < least || *value > greatest) {
        return etch_text_fail(text, "%s: \"%s\" is not an integer in %lld .. %lld", name,
                              etch_word_show(word).text, (long long)least, (long long)greatest);
    }
    return true;
}

bool etch_text_q16(struct etch_text *text, const char *name, int32_t *value)
{
    struct etch_word word;
    struct etch_decimal number;

    if (!etch_text_word(text, name, &word)) {
        return false;
    }
    if (!etch_decimal_read(word, &number)) {
        return etch_text_fail(text, "%s: \"%s\" is not a decimal number", name,
                              etch_word_show(word).text);
    }
    if (!etch_decimal_scale(&number, 16, value)) {
        return etch_text_fail(text, "%s: %s does not fit 16.16 (-32768 .. 32767.99998)", name,
                              etch_word_show(word).text);
    }
    return true;
}

bool etch_text_choice(struct etch_text *text, const char *name, const char *const *list, int *index)
{
    struct etch_word word;

    if (!etch_text_word(text, name, &word)) {
        return false;
    }
    for (*index = 0; list[*index] != NULL; ++*index) {
        if (etch_word_is(word, list[*index])) {
            return true;
        }
    }
    return etch_text_fail(text, "%s: \"%s\" is unknown", name, etch_word_show(word).text);
}

struct etch_shown etch_word_show(struct etch_word word)
{
    struct etch_shown shown;
    const size_t size = word.size < 40 ? word.size : 40;

    for (size_t i = 0; i < size; i++) {
        const unsigned char c = (unsigned char)word.text[i];
        shown.text[i] = c >= 0x20 && c < 0x7F ? (char)c : '?';
    }
    strcpy(shown.text + size, size < word.size ? ".." : "");
    return shown;
}

bool etch_word_is(struct etch_word word, const char *text)
{
    return word.size == strlen(text) && memcmp(word.text, text, word.size) == 0;
}
