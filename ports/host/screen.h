/* ports/host/screen.h: the displays of the simulator, by name.
 *
 *      memory   linear memory, drawn into directly (ports/framebuffer)
 *      strips   a panel with its own memory, fed by strips from two buffers; a transfer takes
 *               place when it is waited for, so a buffer that is drawn on too early shows
 *      strips1  the same with one buffer
 */
#ifndef ETCH_HOST_SCREEN_H
#define ETCH_HOST_SCREEN_H

#include "../framebuffer/framebuffer.h"

struct etch_screen {
    struct etch_display display;
    uint8_t buffers;               /* 0 direct, else how many the frame loop is given */
    struct etch_framebuffer shown; /* what is on the glass */
    uint64_t bytes, flushes;       /* sent so far */

    /* The transfer that has not taken place yet; pixels NULL: none. */
    const uint16_t *pixels;
    struct etch_rect area;
    uint16_t stride;
};

/* Makes a black screen. False if the name is unknown or there is no memory. */
enum etch_screen_status {
    ETCH_SCREEN_OK,
    ETCH_SCREEN_UNKNOWN,
    ETCH_SCREEN_NO_MEMORY
};
enum etch_screen_status etch_screen_open(struct etch_screen *screen, const char *name,
                                         int16_t width, int16_t height, uint8_t format);

/* Gives the memory back. The screen must stay where it was opened. */
void etch_screen_close(struct etch_screen *screen);

/* The names, with blanks between. */
extern const char etch_screen_names[];

#endif
