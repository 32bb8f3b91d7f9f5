/* tests/unit: tiles that are skipped because their hash did not change, by what a panel shows. */
#include "hal/tiles.h"
#include "panel_parts.h"

void suite_dirty_tiles(void);

static struct etch_panel_port port;
static struct etch_tiles tiles;
static uint32_t hash[20 * 8];
static uint16_t dots[64]; /* pixels of the scene that differ from picture 1: y << 8 | x */
static int dot_count;

/* A frame of the scene through the tiles. */
static int tile_frame(int rows, int buffers)
{
    static uint16_t buffer[2][160 * 32];
    const struct etch_frame_memory memory = {.pixels = {buffer[0], buffers == 2 ? buffer[1] : NULL},
                                             .size = (uint32_t)rows *
                                                     (uint32_t)tiles.display.width};
    struct etch_frame frame;

    CHECK_EQ(etch_frame_init(&frame, &tiles.display, memory), 0);
    for (struct etch_surface *s = etch_frame_begin(&frame); s != NULL;
         s = etch_frame_next(&frame)) {
        panel_picture(s, tiles.display.format, 1);
        for (int i = 0; i < dot_count; i++)
            etch_point_draw(s, dots[i] & 255, (int16_t)(dots[i] >> 8), (uint16_t)(0x5AA5 + i));
    }
    return etch_frame_end(&frame);
}

/* The glass shows the scene. */
static void check_scene(void)
{
    static uint16_t picture[160 * 160];
    const struct etch_display *d = &tiles.display;
    struct etch_surface s;

    CHECK_EQ(etch_surface_init(&s, picture, (struct etch_rect){0, 0, d->width, d->height},
                               (uint16_t)d->width),
             0);
    panel_picture(&s, ETCH_FORMAT_RGB565, 1);
    for (int i = 0; i < dot_count; i++) {
        const uint16_t c = (uint16_t)(0x5AA5 + i);

        etch_point_draw(&s, dots[i] & 255, (int16_t)(dots[i] >> 8),
                        d->format == ETCH_FORMAT_RGB565 ? c : etch_rgb565_swap(c));
    }
    for (int i = 0; i < d->width * d->height && !test_failed(); i++)
        CHECK_EQ(etch_panel_view(&port.panel, port.turn, i % d->width, i / d->width),
                 panel_expected(port.panel.type, picture[i], i % d->width, i / d->width));
    CHECK(port.panel.error[0] == 0);
}

static bool open_tiles(uint16_t refresh)
{
    const struct etch_tiles_setup setup = {hash, 20 * 8, 16, 20, refresh};

    dot_count = 0;
    return CHECK_EQ(etch_panel_port_open(&port, "st7735-red", 0), 0) &&
           CHECK_EQ(etch_tiles_init(&tiles, &port.lcd.display, setup), 0);
}

/* Dots come and go at random: exactly the tiles that they touch are sent, and the glass is right
 * after every frame. */
static void only_changed_tiles_are_sent(void)
{
    uint32_t seed = 0x711E5;

    for (int buffers = 1; buffers <= 2; buffers++) {
        if (!open_tiles(0))
            return;
        CHECK_EQ(tile_frame(20, buffers), 0);
        CHECK_EQ(tiles.sent, 8 * 8);
        for (int n = 0; n < TEST_COUNT(100) && !test_failed(); n++) {
            bool touched[8][8] = {{false}};
            uint32_t expected = 0, before = tiles.sent;

            for (int i = 0; i < dot_count; i++)
                touched[(dots[i] >> 8) / 20][(dots[i] & 255) / 16] = true;
            dot_count = (int)test_range(&seed, 0, 12);
            for (int i = 0; i < dot_count; i++) {
                dots[i] = (uint16_t)((uint32_t)test_range(&seed, 0, 159) << 8 |
                                     (uint32_t)test_range(&seed, 0, 127));
                touched[(dots[i] >> 8) / 20][(dots[i] & 255) / 16] = true;
            }
            for (int i = 0; i < 64; i++)
                expected += touched[i / 8][i % 8];
            CHECK_EQ(tile_frame(20, buffers), 0);
            check_scene();
            CHECK(tiles.sent - before <= expected);
            before = tiles.sent;
            CHECK_EQ(tile_frame(20, buffers), 0);
            CHECK_EQ(tiles.sent, before);
        }
        etch_panel_port_close(&port);
    }
}

/* Every tile is sent once in `refresh` frames, whatever its hash says. */
static void refresh_heals(void)
{
    if (!open_tiles(10))
        return;
    CHECK_EQ(tile_frame(20, 1), 0);
    for (int row = 0; row < 160; row++) /* noise on the glass that no hash knows of */
        for (int x = 0; x < 128; x++)
            port.panel.memory[row * 128 + x] ^= 0xFFFFFF;
    for (int n = 0; n < 10; n++) {
        const uint32_t before = tiles.sent;

        CHECK_EQ(tile_frame(20, 1), 0);
        CHECK(tiles.sent - before >= 6 && tiles.sent - before <= 7);
    }
    check_scene();
    etch_panel_port_close(&port);
}

/* A fault at the k-th transfer: reported, and the next frame sends what it lost. */
static void lost_tiles_are_sent_again(void)
{
    static const enum etch_panel_fault faults[] = {
        ETCH_PANEL_START_FAILS, ETCH_PANEL_FAILS, ETCH_PANEL_COMMAND_FAILS, ETCH_PANEL_BEGIN_FAILS};

    for (uint32_t n = 0; n < 4 * 24; n++) {
        const int buffers = 1 + (n & 1);
        int status;

        if (!open_tiles(0))
            return;
        CHECK_EQ(tile_frame(20, buffers), 0);
        for (dot_count = 0; dot_count < 30; dot_count++)
            dots[dot_count] = (uint16_t)(dot_count * 5 * 256 + dot_count * 37 % 128);
        port.bus.fault = faults[n % 4];
        port.bus.fault_at = n / 4 + 1;
        status = tile_frame(20, buffers);
        CHECK_EQ(status, port.bus.fault_at == 0 ? ETCH_PANEL_FAULT_STATUS : 0);
        port.bus.fault_at = 0;
        CHECK_EQ(tile_frame(20, buffers), 0);
        check_scene();
        etch_panel_port_close(&port);
    }
}

/* Each of the bits of each pixel of a tile changes the hash: single flips are never missed. */
static void single_changes_are_never_missed(void)
{
    static uint16_t pixels[128 * 20];
    const struct etch_rect strip = {0, 0, 128, 20};
    uint32_t sent;

    if (!open_tiles(0))
        return;
    for (int n = 0; n < 2; n++) {
        CHECK_EQ(tiles.display.flush(&tiles.display, strip, pixels, 128), 0);
        CHECK_EQ(tiles.display.wait(&tiles.display), 0);
    }
    sent = tiles.sent;
    for (int i = 0; i < 20 * 16 * 16; i++) {
        pixels[i / 16 / 16 * 128 + i / 16 % 16] ^= (uint16_t)(1U << i % 16);
        CHECK_EQ(tiles.display.flush(&tiles.display, strip, pixels, 128), 0);
        CHECK_EQ(tiles.display.wait(&tiles.display), 0);
        CHECK_EQ(tiles.sent, ++sent);
    }
    etch_panel_port_close(&port);
}

static void wrong_setups_are_refused(void)
{
    struct etch_tiles_setup setup = {hash, 63, 16, 20, 0};
    static uint16_t pixels[128 * 40];

    if (!open_tiles(0))
        return;
    CHECK_EQ(etch_tiles_init(&tiles, &port.lcd.display, setup), ETCH_ENOMEM);
    setup.tile_width = 0;
    CHECK_EQ(etch_tiles_init(&tiles, &port.lcd.display, setup), ETCH_EINVAL);
    setup.tile_width = 16, setup.count = 64;
    CHECK_EQ(etch_tiles_init(&tiles, &port.lcd.display, setup), 0);
    CHECK_EQ(tile_frame(16, 1), ETCH_EINVAL);
    CHECK_EQ(tiles.display.flush(&tiles.display, (struct etch_rect){1, 0, 128, 20}, pixels, 128),
             ETCH_EINVAL);
    etch_panel_port_close(&port);
}

void suite_dirty_tiles(void)
{
    RUN(only_changed_tiles_are_sent);
    RUN(refresh_heals);
    RUN(lost_tiles_are_sent_again);
    RUN(single_changes_are_never_missed);
    RUN(wrong_setups_are_refused);
}
