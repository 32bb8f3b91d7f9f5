/* tests/readme: the bus behind the README's first program, and an audience for its second.
 *
 * Takes the window and the pixels as a panel would, then compares what arrived with the same
 * picture drawn into linear memory. The tetrahedron is drawn whole and in strips of 16 rows,
 * which must agree, and must show more than one face. */
#include <stdio.h>
#include <stdlib.h>

#include "core/etch.h"

void lcd_window(int x0, int y0, int x1, int y1);
void lcd_write(const uint16_t *pixels, int32_t count);
int readme_main(void);
enum etch_status draw_scene(struct etch_surface *s, uint16_t angle);

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

static int compare_panel(void)
{
    static uint16_t expected[320][240];
    struct etch_surface s;
    const struct etch_rect window = {0, 0, 240, 320};
    int wrong = 0;

    if (readme_main() != 0 || etch_surface_init(&s, expected[0], window, 240) != ETCH_OK)
        return -1;
    etch_surface_clear(&s, etch_rgb565(20, 24, 40));
    etch_circle_fill(&s, 120, 160, 100, etch_rgb565(250, 180, 40));
    etch_line_draw(&s, -50, 0, 300, 319, etch_rgb565(255, 255, 255));
    for (int j = 0; j < 320; j++)
        for (int i = 0; i < 240; i++)
            wrong += glass[j][i] != expected[j][i];
    return wrong;
}

static uint16_t whole[320 * 240], strips[320 * 240], depth[320 * 240];

/* Draws `rows` rows at a time; 0 if all went well. */
static int draw_tetrahedron(uint16_t *frame, int16_t rows)
{
    for (int16_t top = 0; top < 320; top = (int16_t)(top + rows)) {
        struct etch_surface s;
        const struct etch_rect window = {0, top, 240, (int16_t)(top + rows)};

        if (etch_surface_init(&s, frame + top * 240, window, 240) != ETCH_OK)
            return -1;
        s.depth = depth;
        etch_surface_clear(&s, 0);
        if (draw_scene(&s, 9000) != ETCH_OK)
            return -1;
    }
    return 0;
}

static int compare_tetrahedron(const char *ppm)
{
    int covered = 0, wrong = 0;
    FILE *f = fopen(ppm, "wb");

    if (f == NULL || draw_tetrahedron(whole, 320) != 0 || draw_tetrahedron(strips, 16) != 0)
        return -1;
    fprintf(f, "P6\n240 320\n255\n");
    for (int i = 0; i < 320 * 240; i++) {
        const uint16_t c = etch_rgb565_swap(whole[i]);

        wrong += whole[i] != strips[i];
        covered += c != 0;
        putc(etch_rgb565_red(c), f), putc(etch_rgb565_green(c), f), putc(etch_rgb565_blue(c), f);
    }
    return fclose(f) != 0 || covered < 5000 ? -1 : wrong;
}

static int report(const char *name, int wrong)
{
    if (wrong < 0)
        printf("FAIL readme: %s failed\n", name);
    else
        printf("README's %s: %d pixels are wrong\n", name, wrong);
    return wrong != 0;
}

int main(int argc, char **argv)
{
    const int failed = report("first program on the panel", compare_panel()) +
                       report("mesh in strips", argc == 2 ? compare_tetrahedron(argv[1]) : -1);

    printf("%d passed, %d failed\n", 2 - failed, failed);
    return failed != 0;
}
