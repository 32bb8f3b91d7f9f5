/* tests/readme: the bus behind the README's program. Takes the window and the pixels as a panel
 * would, then compares what arrived with the same picture drawn into linear memory. Its exit
 * status is the README program's own main, run from here, and the comparison. */
#include <stdio.h>
#include <stdlib.h>

#include "core/etch.h"

void lcd_window(int x0, int y0, int x1, int y1);
void lcd_write(const uint16_t *pixels, int32_t count);
int readme_main(void);

static uint16_t glass[320][240];
static int left, right, x, y, bottom;

void lcd_window(int x0, int y0, int x1, int y1)
{
    if (x0 < 0 || y0 < 0 || x1 > 239 || y1 > 319 || x0 > x1 || y0 > y1) {
        puts("FAIL readme: window outside the panel");
        exit(1);
    }
    left = x = x0, right = x1, y = y0, bottom = y1;
}

void lcd_write(const uint16_t *pixels, int32_t count)
{
    for (; count > 0; count--, pixels++) {
        if (y > bottom) {
            puts("FAIL readme: more pixels than the window holds");
            exit(1);
        }
        glass[y][x] = etch_rgb565_swap(*pixels); /* the panel takes the high byte first */
        if (++x > right)
            x = left, y++;
    }
}

int main(void)
{
    static uint16_t expected[320][240];
    struct etch_surface s;
    const struct etch_rect window = {0, 0, 240, 320};
    int wrong = 0;

    if (readme_main() != 0 || etch_surface_init(&s, expected[0], window, 240) != ETCH_OK) {
        puts("FAIL readme: the program failed");
        return 1;
    }
    etch_surface_clear(&s, etch_rgb565(20, 24, 40));
    etch_circle_fill(&s, 120, 160, 100, etch_rgb565(250, 180, 40));
    etch_line_draw(&s, -50, 0, 300, 319, etch_rgb565(255, 255, 255));
    for (int j = 0; j < 320; j++)
        for (int i = 0; i < 240; i++)
            wrong += glass[j][i] != expected[j][i];
    printf("README program: %d pixels on the panel are wrong\n%d passed, %d failed\n", wrong,
           wrong == 0, wrong != 0);
    return wrong != 0;
}
