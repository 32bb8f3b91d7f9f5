/* tests/unit: what changed: dirty rectangles and areas of a frame, by marking pixels one by
 * one. */
#include "hal/dirty.h"
#include "panel_parts.h"

void suite_dirty(void);

enum {
    SIDE = 64
};

/* How often each pixel of a field is in the areas. */
static uint8_t field[SIDE][SIDE];

static void mark(const struct etch_rect *areas, int count)
{
    for (int i = 0; i < SIDE * SIDE; i++)
        field[i / SIDE][i % SIDE] = 0;
    for (int i = 0; i < count; i++)
        for (int y = areas[i].y0; y < areas[i].y1; y++)
            for (int x = areas[i].x0; x < areas[i].x1; x++)
                field[y][x]++;
}

static struct etch_rect random_rect(uint32_t *seed, int most)
{
    const int16_t x = (int16_t)test_range(seed, 0, SIDE - 1);
    const int16_t y = (int16_t)test_range(seed, 0, SIDE - 1);
    const int16_t w = (int16_t)test_range(seed, 0, most), h = (int16_t)test_range(seed, 0, most);
    const struct etch_rect r = {x, y, (int16_t)(x + w < SIDE ? x + w : SIDE),
                                (int16_t)(y + h < SIDE ? y + h : SIDE)};
    return r;
}

/* All that was added is covered, no pixel twice, whatever was added in what order. */
static void areas_cover_all_and_never_overlap(void)
{
    uint32_t seed = 0xD1127;

    for (int32_t n = 0; n < TEST_COUNT(20000) && !test_failed(); n++) {
        struct etch_dirty dirty = {.slack = (uint16_t)test_range(&seed, 0, 100)};
        struct etch_rect added[24];
        const int count = (int)test_range(&seed, 0, 24);
        const int most = (int)test_range(&seed, 1, 30);

        for (int i = 0; i < count; i++) {
            added[i] = random_rect(&seed, most);
            etch_dirty_add(&dirty, added[i]);
        }
        CHECK(dirty.count <= ETCH_DIRTY_MOST);
        mark(dirty.area, dirty.count);
        for (int i = 0; i < SIDE * SIDE; i++)
            CHECK(field[i / SIDE][i % SIDE] <= 1);
        for (int i = 0; i < count; i++)
            for (int y = added[i].y0; y < added[i].y1; y++)
                for (int x = added[i].x0; x < added[i].x1; x++)
                    CHECK_EQ(field[y][x], 1);
    }
}

/* Near ones join, far ones do not, the largest there can be do not overflow. */
static void areas_join_where_it_pays(void)
{
    struct etch_dirty dirty = {.slack = 16};
    const struct etch_rect all = {-32768, -32768, 32767, 32767};

    etch_dirty_add(&dirty, (struct etch_rect){0, 0, 8, 8});
    etch_dirty_add(&dirty, (struct etch_rect){9, 0, 17, 8}); /* a column of 8 between */
    CHECK_EQ(dirty.count, 1);
    etch_dirty_add(&dirty, (struct etch_rect){40, 0, 48, 8});
    CHECK_EQ(dirty.count, 2);
    etch_dirty_add(&dirty, (struct etch_rect){5, 5, 5, 50}); /* empty */
    CHECK_EQ(dirty.count, 2);
    etch_dirty_add(&dirty, (struct etch_rect){16, 4, 42, 6}); /* touches both */
    CHECK(dirty.count == 1 && dirty.area[0].x0 == 0 && dirty.area[0].x1 == 48);
    etch_dirty_add(&dirty, all);
    CHECK(dirty.count == 1 && dirty.area[0].x0 == -32768 && dirty.area[0].y1 == 32767);
}

static struct etch_panel_port port;

/* Draws picture `number` in the areas only. */
static int draw_areas(const struct etch_rect *areas, uint16_t count, int number, int size,
                      int buffers)
{
    static uint16_t buffer[2][480 * 24];
    const struct etch_display *d = &port.lcd.display;
    const struct etch_frame_memory memory = {.pixels = {buffer[0], buffers == 2 ? buffer[1] : NULL},
                                             .size = (uint32_t)size};
    struct etch_frame frame;

    CHECK_EQ(etch_frame_init(&frame, d, memory), 0);
    for (struct etch_surface *s = etch_frame_begin_areas(&frame, areas, count); s != NULL;
         s = etch_frame_next(&frame))
        panel_picture(s, d->format, number);
    return etch_frame_end(&frame);
}

/* On panels with any and with 2- and 8-pixel borders, turned or not: areas of picture 2 over
 * picture 1 show picture 2 inside; what is outside shows picture 1 but for what borders add. */
static void areas_change_what_they_cover(void)
{
    static const char *const names[] = {"st7789-135x240", "ssd0323", "ssd1306"};
    uint32_t seed = 0xA2EA5;

    for (int n = 0; n < TEST_COUNT(60) && !test_failed(); n++) {
        const struct etch_display *d = &port.lcd.display;
        const int align = n % 3 == 0 ? 1 : n % 3 == 1 ? 2 : 8;
        struct etch_rect areas[3];
        uint64_t before;
        uint32_t most = 0;

        if (!CHECK_EQ(etch_panel_port_open(&port, names[n % 3], (uint8_t)(n / 3 % 4)), 0))
            return;
        CHECK_EQ(panel_frame(&port, 1, 16, 1), 0);
        for (int i = 0; i < 3; i++) {
            areas[i] = random_rect(&seed, 40);
            most += etch_rect_is_empty(areas[i])
                        ? 0
                        : (uint32_t)(areas[i].x1 - areas[i].x0 + 2 * align) *
                              (uint32_t)(areas[i].y1 - areas[i].y0 + 2 * align);
        }
        before = port.panel.pixels;
        CHECK_EQ(draw_areas(areas, 3, 2, d->width * 8, 1 + n % 2), 0);
        CHECK(port.panel.error[0] == 0 && port.panel.pixels - before <= most);
        mark(areas, 3);
        for (int16_t y = 0; y < d->height && !test_failed(); y++) {
            for (int16_t x = 0; x < d->width; x++) {
                const bool in = x < SIDE && y < SIDE && field[y][x] != 0;
                const uint32_t seen = etch_panel_view(&port.panel, port.turn, x, y);
                uint16_t one[2];

                for (int k = 0; k < 2; k++) {
                    struct etch_surface s;

                    CHECK_EQ(etch_surface_init(
                                 &s, &one[k],
                                 (struct etch_rect){x, y, (int16_t)(x + 1), (int16_t)(y + 1)}, 1),
                             0);
                    panel_picture(&s, ETCH_FORMAT_RGB565, k + 1);
                }
                CHECK(seen == panel_expected(port.panel.type, one[1], x, y) ||
                      (!in && seen == panel_expected(port.panel.type, one[0], x, y)));
            }
        }
        etch_panel_port_close(&port);
    }
}

/* ---- memory that is drawn into directly --------------------------------------------------------
 */

static uint16_t memory_pixels[SIDE * (SIDE + 3)];
static int told;

static uint16_t *get_memory(const struct etch_display *d, uint16_t *stride)
{
    (void)d;
    *stride = SIDE + 3;
    return memory_pixels;
}

static int tell(const struct etch_display *d, struct etch_rect area, const uint16_t *pixels,
                uint16_t stride)
{
    told += area.x0 == 0 && area.y0 == 0 && area.x1 == d->width && area.y1 == d->height &&
            pixels == memory_pixels && stride == SIDE + 3;
    return 0;
}

static int rest(const struct etch_display *d)
{
    (void)d;
    return 0;
}

/* In memory, areas are windows at their own place, with and without a depth plane that holds only
 * some rows; the display is told once, also if the last area is empty. */
static void areas_are_drawn_in_place(void)
{
    static uint16_t depth[(SIDE + 3) * 5];
    const struct etch_display d = {
        .width = SIDE, .height = SIDE, .flush = tell, .wait = rest, .memory = get_memory};
    uint32_t seed = 0xD12EC7;

    for (int32_t n = 0; n < TEST_COUNT(300) && !test_failed(); n++) {
        const struct etch_frame_memory m = {.depth = n % 2 != 0 ? depth : NULL,
                                            .size = n % 2 != 0 ? (SIDE + 3) * 5 : 0};
        const struct etch_rect areas[3] = {
            random_rect(&seed, 40), random_rect(&seed, 40), {9, 9, 9, 20}};
        const bool any = !etch_rect_is_empty(areas[0]) || !etch_rect_is_empty(areas[1]);
        struct etch_frame frame;

        for (int i = 0; i < SIDE * (SIDE + 3); i++)
            memory_pixels[i] = 7;
        told = 0;
        CHECK_EQ(etch_frame_init(&frame, &d, m), 0);
        for (struct etch_surface *s = etch_frame_begin_areas(&frame, areas, 3); s != NULL;
             s = etch_frame_next(&frame))
            etch_surface_clear(s, 9);
        CHECK_EQ(etch_frame_end(&frame), 0);
        CHECK_EQ(told, any);
        mark(areas, 3);
        for (int y = 0; y < SIDE; y++)
            for (int x = 0; x < SIDE + 3; x++)
                CHECK_EQ(memory_pixels[y * (SIDE + 3) + x], x < SIDE && field[y][x] ? 9 : 7);
    }
}

void suite_dirty(void)
{
    RUN(areas_cover_all_and_never_overlap);
    RUN(areas_join_where_it_pays);
    RUN(areas_change_what_they_cover);
    RUN(areas_are_drawn_in_place);
}
