/* tests/product: show SCREEN TICK FRAME: runs a screen as firmware does, through the frame loop
 * in two strips of 16 rows and the driver of an ILI9341, to a simulated panel that decodes the
 * bytes of the bus, and writes what its glass shows to FRAME.png, and as big-endian RGB565 to
 * FRAME.565.
 *      show all: every screen at many ticks.
 * Fails if the panel refuses a byte, or if the frame drawn whole, or in strips of other heights,
 * is another one. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "hal/frame.h"
#include "ports/host/dump.h"
#include "ports/host/panel_port.h"
#include "product.h"

enum {
    PIXELS = PRODUCT_WIDTH * PRODUCT_HEIGHT
};

static const struct product_screen *const screens[] = {&product_cluster, &product_chart,
                                                       &product_menu};
static uint16_t strips[2][PIXELS], glass[PIXELS], whole[PIXELS];
static struct etch_panel_port port;

/* Through the frame loop, `rows` rows at a time. */
static int draw_strips(const struct product_screen *screen, uint32_t rows)
{
    struct etch_frame frame;
    const struct etch_frame_memory memory = {.pixels = {strips[0], strips[1]},
                                             .size = PRODUCT_WIDTH * rows};
    const int status = etch_frame_init(&frame, &port.lcd.display, memory);

    if (status != 0)
        return status;
    for (struct etch_surface *s = etch_frame_begin(&frame); s != NULL; s = etch_frame_next(&frame))
        screen->draw(s);
    return etch_frame_end(&frame);
}

/* The frame in one piece, as plain RGB565; false if the screen's window is refused. */
static bool draw_whole(const struct product_screen *screen)
{
    const struct etch_rect window = {0, 0, PRODUCT_WIDTH, PRODUCT_HEIGHT};
    struct etch_surface s;

    if (etch_surface_init(&s, whole, window, PRODUCT_WIDTH) != ETCH_OK)
        return false;
    screen->draw(&s);
    for (int i = 0; i < PIXELS; i++)
        if (ETCH_FORMAT_HIGH_BYTE_FIRST == ETCH_FORMAT_RGB565_SWAPPED)
            whole[i] = etch_rgb565_swap(whole[i]);
    return true;
}

static bool is_whole(const struct product_screen *screen, uint32_t rows)
{
    memset(strips, 0x5A, sizeof strips);
    if (draw_strips(screen, rows) != 0 || port.panel.error[0] != '\0') {
        fprintf(stderr, "%s: the panel refuses: %s\n", screen->name, port.panel.error);
        return false;
    }
    etch_panel_port_shown(&port, glass);
    if (memcmp(glass, whole, sizeof glass) == 0)
        return true;
    fprintf(stderr, "%s: strips of %u rows differ from the frame drawn whole\n", screen->name,
            (unsigned)rows);
    return false;
}

/* At one tick, in three heights of strips; `glass` is the frame afterwards. */
static bool agree(const struct product_screen *screen, uint32_t tick)
{
    screen->prepare(tick);
    return draw_whole(screen) && is_whole(screen, 1 + tick % 40) &&
           is_whole(screen, PRODUCT_HEIGHT) && is_whole(screen, PRODUCT_STRIP);
}

static bool write_png(FILE *file)
{
    const struct etch_plane16 plane = {glass, PRODUCT_WIDTH, PRODUCT_HEIGHT, PRODUCT_WIDTH, false};

    return etch_dump_png(file, &plane);
}

static bool write_565(FILE *file)
{
    for (int i = 0; i < PIXELS; i++) {
        putc(glass[i] >> 8, file);
        putc(glass[i] & 0xFF, file);
    }
    return ferror(file) == 0;
}

static bool save(const char *name, const char *suffix, bool write(FILE *))
{
    char path[512];
    FILE *file;
    bool ok;

    snprintf(path, sizeof path, "%s.%s", name, suffix);
    file = fopen(path, "wb");
    ok = file != NULL && write(file);
    if (file != NULL && fclose(file) != 0)
        ok = false;
    if (!ok)
        perror(path);
    return ok;
}

static int show_all(void)
{
    int passed = 0, failed = 0;

    for (size_t i = 0; i < sizeof screens / sizeof screens[0]; i++)
        for (uint32_t tick = 0; tick < 256; tick += 5) {
            const bool ok = agree(screens[i], tick);

            passed += ok;
            failed += !ok;
        }
    printf("%d passed, %d failed\n", passed, failed);
    return failed != 0;
}

int main(int argc, char **argv)
{
    const bool all = argc == 2 && strcmp(argv[1], "all") == 0;
    int status = 2;

    if ((argc == 4 || all) && etch_panel_port_open(&port, "ili9341", 0) == 0) {
        if (all)
            status = show_all();
        for (size_t i = 0; !all && i < sizeof screens / sizeof screens[0]; i++)
            if (strcmp(argv[1], screens[i]->name) == 0)
                status = !agree(screens[i], (uint32_t)strtoul(argv[2], NULL, 10)) ||
                         !save(argv[3], "png", write_png) || !save(argv[3], "565", write_565);
        etch_panel_port_close(&port);
    }
    if (status == 2)
        fputs("usage: show cluster|chart|menu TICK FRAME, or show all\n", stderr);
    return status;
}
