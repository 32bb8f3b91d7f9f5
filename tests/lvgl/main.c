/* tests/lvgl: the program of `make run-lvgl`: LVGL's widgets, a scene of etch's in an image and in
 * a canvas, on a simulated panel beneath LVGL and, to compare, in a buffer of LVGL's own. */
#include <stdio.h>
#include <string.h>

#include "core/etch.h"
#include "ports/host/panel_port.h"
#include "ports/lvgl/lvgl_display.h"
#include "ports/lvgl/lvgl_surface.h"
#include "tests/targets/scenes.h"

enum {
    WIDTH = 320,
    HEIGHT = 240,
    VIEW_W = 120,
    VIEW_H = 90,
    LEFT = 10, /* of the image; the canvas is RIGHT */
    RIGHT = 150,
    TOP = 100,
    STRIP_BYTES = WIDTH * 20 * 2
};

static uint16_t own[WIDTH * HEIGHT]; /* what LVGL draws for a display without etch */
static uint16_t shown[WIDTH * HEIGHT];
static uint16_t depth[VIEW_W * VIEW_H];
static uint8_t strip[2][STRIP_BYTES] __attribute__((aligned(64)));
static uint32_t now;
static int passed, failed;

static void check(bool ok, const char *what)
{
    printf("%s %s\n", ok ? "ok  " : "FAIL", what);
    passed += ok;
    failed += !ok;
}

static uint32_t tick(void)
{
    return now;
}

/* ---- a screen -------------------------------------------------------------------------------- */

LV_DRAW_BUF_DEFINE_STATIC(image_view, VIEW_W, VIEW_H, LV_COLOR_FORMAT_RGB565);
LV_DRAW_BUF_DEFINE_STATIC(canvas_view, VIEW_W, VIEW_H, LV_COLOR_FORMAT_RGB565);

/* A scene of the boards' into a draw buffer. */
static bool draw_scene(const struct target_scene *scene, const lv_draw_buf_t *view)
{
    struct etch_surface s;

    if (etch_lvgl_surface(&s, view) != ETCH_OK)
        return false;
    s.depth = depth;
    scene->prepare(VIEW_W, VIEW_H);
    scene->draw(&s, false);
    return true;
}

static void make_screen(lv_display_t *display, int32_t value)
{
    lv_obj_t *screen, *label, *bar, *button, *image, *canvas;

    lv_display_set_default(display);
    screen = lv_obj_create(NULL);
    label = lv_label_create(screen);
    lv_label_set_text(label, "etch and LVGL");
    lv_obj_set_pos(label, 10, 8);
    bar = lv_slider_create(screen);
    lv_slider_set_value(bar, value, LV_ANIM_OFF);
    lv_obj_set_pos(bar, 20, 50);
    lv_obj_set_size(bar, 200, 10);
    button = lv_button_create(screen);
    lv_obj_set_pos(button, 240, 20);
    lv_obj_set_size(button, 60, 40);
    image = lv_image_create(screen);
    lv_image_set_src(image, &image_view);
    lv_obj_set_pos(image, LEFT, TOP);
    canvas = lv_canvas_create(screen);
    lv_canvas_set_draw_buf(canvas, &canvas_view);
    lv_obj_set_pos(canvas, RIGHT, TOP);
    lv_screen_load(screen);
}

/* ---- a display of LVGL alone ----------------------------------------------------------------- */

static void keep(lv_display_t *lv, const lv_area_t *area, uint8_t *pixels)
{
    const size_t width = (size_t)lv_area_get_width(area) * sizeof *own;

    for (int32_t y = area->y1; y <= area->y2; y++, pixels += width)
        memcpy(own + y * WIDTH + area->x1, pixels, width);
    lv_display_flush_ready(lv);
}

static lv_display_t *open_own(void)
{
    static uint8_t buffer[WIDTH * HEIGHT * 2] __attribute__((aligned(64)));
    lv_display_t *lv = lv_display_create(WIDTH, HEIGHT);

    lv_display_set_color_format(lv, LV_COLOR_FORMAT_RGB565);
    lv_display_set_buffers(lv, buffer, NULL, sizeof buffer, LV_DISPLAY_RENDER_MODE_FULL);
    lv_display_set_flush_cb(lv, keep);
    return lv;
}

/* ---- what is on the glass -------------------------------------------------------------------- */

/* The view on the glass at (left, TOP), pixel for pixel. */
static bool shows(const lv_draw_buf_t *view, int left)
{
    for (int y = 0; y < VIEW_H; y++)
        if (memcmp(shown + (TOP + y) * WIDTH + left, view->data + (size_t)y * view->header.stride,
                   VIEW_W * sizeof *shown) != 0)
            return false;
    return true;
}

static int differences(void)
{
    int n = 0;

    for (int i = 0; i < WIDTH * HEIGHT; i++)
        n += shown[i] != own[i];
    return n;
}

static void refresh(lv_display_t *display)
{
    now += 100;
    lv_refr_now(display);
}

static void run(struct etch_panel_port *port, lv_display_t *panel, struct etch_lvgl *lvgl)
{
    lv_display_t *alone = open_own();

    for (int32_t value = 20; value <= 80; value += 30) {
        check(draw_scene(&target_torus, &image_view) &&
                  draw_scene(value == 50 ? &target_floor : &target_shapes, &canvas_view),
              "etch draws into two draw buffers");
        make_screen(panel, value);
        make_screen(alone, value);
        refresh(panel);
        refresh(alone);
        check(etch_lvgl_status(lvgl) == 0 && port->panel.error[0] == '\0', "the panel takes it");
        etch_panel_port_shown(port, shown);
        printf("     %d of %d pixels are not those of LVGL's own buffer\n", differences(),
               WIDTH * HEIGHT);
        check(differences() == 0, "the glass shows LVGL's own buffer");
        check(shows(&image_view, LEFT), "the image shows etch's scene");
        check(shows(&canvas_view, RIGHT), "the canvas shows etch's scene");
    }
}

/* A failed transfer is told, and what it lost comes back. */
static void fail(struct etch_panel_port *port, lv_display_t *panel, struct etch_lvgl *lvgl)
{
    port->bus.fault = ETCH_PANEL_FAILS;
    port->bus.fault_at = 30;
    lv_obj_invalidate(lv_display_get_screen_active(panel));
    refresh(panel);
    check(etch_lvgl_status(lvgl) == ETCH_PANEL_FAULT_STATUS, "a failed transfer is told");
    check(etch_lvgl_status(lvgl) == 0, "once");
    lv_obj_invalidate(lv_display_get_screen_active(panel));
    refresh(panel);
    etch_panel_port_shown(port, shown);
    check(etch_lvgl_status(lvgl) == 0 && differences() == 0, "and mended");
}

/* A panel of eight pixels a byte: small areas, at odd places, grow to its bytes; the glass shows
 * what it would if LVGL's own buffer were sent whole. */
static bool aligned(void)
{
    static struct etch_panel_port port, whole;
    static struct etch_lvgl lvgl;
    static uint16_t expected[128 * 64];
    const struct etch_display *display = &whole.lcd.display;
    lv_display_t *panel, *alone;
    lv_obj_t *dot[2];

    if (etch_panel_port_open(&port, "ssd1306", 0) != 0 ||
        etch_panel_port_open(&whole, "ssd1306", 0) != 0)
        return false;
    panel = etch_lvgl_open(&lvgl, &port.lcd.display, strip[0], strip[1], 128 * 16 * 2);
    alone = open_own();
    lv_display_set_resolution(alone, 128, 64);
    lv_display_set_color_format(alone, lv_display_get_color_format(panel));
    for (int i = 0; i < 2; i++) {
        lv_display_set_default(i == 0 ? panel : alone);
        lv_screen_load(lv_obj_create(NULL));
        dot[i] = lv_button_create(lv_screen_active());
        lv_obj_set_size(dot[i], 21, 13);
    }
    for (int32_t step = 0; step < 12; step++) {
        for (int i = 0; i < 2; i++) {
            lv_obj_set_pos(dot[i], 3 + 7 * step, 5 + 3 * step);
            refresh(i == 0 ? panel : alone);
        }
        (void)etch_lvgl_status(&lvgl);
        (void)display->flush(display, (struct etch_rect){0, 0, 128, 64}, own, WIDTH);
        (void)display->wait(display);
        etch_panel_port_shown(&port, shown);
        etch_panel_port_shown(&whole, expected);
        if (port.panel.error[0] != '\0' || memcmp(shown, expected, sizeof expected) != 0)
            return false;
    }
    etch_panel_port_close(&port);
    etch_panel_port_close(&whole);
    return true;
}

int main(void)
{
    static struct etch_panel_port port;
    static struct etch_lvgl lvgl;
    lv_display_t *panel;

    lv_init();
    lv_tick_set_cb(tick);
    LV_DRAW_BUF_INIT_STATIC(image_view);
    LV_DRAW_BUF_INIT_STATIC(canvas_view);
    if (etch_panel_port_open(&port, "ili9341", 1) != 0)
        return 1;
    panel = etch_lvgl_open(&lvgl, &port.lcd.display, strip[0], strip[1], STRIP_BYTES);
    check(panel != NULL, "an etch panel beneath LVGL");
    if (panel != NULL) {
        run(&port, panel, &lvgl);
        fail(&port, panel, &lvgl);
        check(aligned(), "areas grow to the bytes of a panel");
    }
    printf("%d passed, %d failed\n", passed, failed);
    return failed == 0 ? 0 : 1;
}
