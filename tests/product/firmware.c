/* tests/product: the program of a board: one screen, SCREEN at TICK, in two strips of 16 rows. */
#include "hal/frame.h"
#include "ports/board.h"
#include "ports/spi_lcd/lcd.h"
#include "product.h"

int main(void);

static uint16_t strip[2][PRODUCT_WIDTH * PRODUCT_STRIP];

/* The board's panel, upright. */
static const struct etch_display *open_display(void)
{
    const struct etch_display *display = board_open();

    /* The display is the first member of the board's panel. */
    return display != NULL && etch_lcd_turn((struct etch_lcd *)(uintptr_t)display, 0) == 0 ? display
                                                                                           : NULL;
}

static int draw(const struct etch_display *display, const struct product_screen *screen)
{
    const struct etch_frame_memory memory = {.pixels = {strip[0], strip[1]},
                                             .size = PRODUCT_WIDTH * PRODUCT_STRIP};
    struct etch_frame frame;
    const int status = etch_frame_init(&frame, display, memory);

    if (status != 0)
        return status;
    screen->prepare(TICK);
    for (struct etch_surface *s = etch_frame_begin(&frame); s != NULL; s = etch_frame_next(&frame))
        screen->draw(s);
    return etch_frame_end(&frame);
}

int main(void)
{
    const struct etch_display *display = open_display();
    const int status = display == NULL ? ETCH_EIO : draw(display, &SCREEN);

    board_print(status == 0 ? "drawn\n" : "FAIL\n");
    return status == 0 ? 0 : 1;
}
