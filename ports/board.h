/* ports/board.h: what a board's folder gives to a program.
 *
 *      main()  ->  board_open: clocks, pins, the panel  ->  a display for hal/frame.h
 *
 * A board is a folder here with start-up and bus, a script in linker/ and a few lines for make in
 * its board.mk; README.md says how to add one. main is the program's. */
#ifndef ETCH_PORTS_BOARD_H
#define ETCH_PORTS_BOARD_H

#include "../hal/display.h"

/* Brings up the board's display, cleared. NULL if it failed. Called once, from main. */
const struct etch_display *board_open(void);

/* Text to whoever runs the program: semihosting, or a serial line. */
void board_print(const char *text);

/* Called when main returns: 0 is success. Under emulation the machine stops, or waits for its
 * screen to be read; a real board idles. */
void board_exit(int status);

#endif
