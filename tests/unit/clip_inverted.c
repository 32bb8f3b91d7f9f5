/* tests/unit: a clip that the caller set by hand, empty or turned inside out, draws nothing. The
 * planes stand in one array, in both orders, with a border that must stay as it was. */
#include "core/etch.h"
#include "tests/harness/harness.h"

enum {
    W = 40,
    H = 3,
    BORDER = 64,
    CELLS = W * H,
    MARK = 0x1234
};

static uint16_t memory[2 * CELLS + 3 * BORDER];

static void draw_everything(const struct etch_surface *s)
{
    const struct etch_vertex v[3] = {{-2560, -2560, 0, 255, 0, 0, 0},
                                     {25600, 256, 0, 0, 255, 0, 0},
                                     {256, 25600, 0, 0, 0, 255, 0}};
    const struct etch_vertex *const p[3] = {&v[0], &v[1], &v[2]};
    const struct etch_point line[3] = {{-5, -5}, {50, 20}, {-5, 20}};

    etch_surface_clear(s, 0);
    etch_depth_clear(s, 0);
    etch_rect_fill(s, -100, -100, 300, 300, 0);
    etch_rect_draw(s, 2, 4, 30, 4, 0);
    etch_circle_fill(s, 20, 6, 100, 0);
    etch_circle_draw(s, 20, 6, 12, 0);
    etch_line_draw(s, -50, 0, 90, 12, 0);
    etch_polyline_draw(s, line, 3, 0);
    etch_hline_draw(s, -10, 6, 200, 0);
    etch_vline_draw(s, 20, -10, 200, 0);
    etch_point_draw(s, 20, 6, 0);
    etch_triangle_fill(s, -10, -10, 100, 1, 1, 100, 0);
    etch_triangle_draw(s, -10, -10, 100, 1, 1, 100, 0);
    etch_triangle_flat(s, p, etch_kernel_flat);
    etch_triangle_flat_depth(s, p, etch_kernel_flat_lequal);
    etch_triangle_gouraud(s, p, etch_kernel_gouraud);
    etch_triangle_gouraud_depth(s, p, etch_kernel_gouraud_lequal);
}

/* How many elements of memory drawing through `clip` changed. */
static int32_t changed(struct etch_rect clip, bool depth_first)
{
    const struct etch_rect window = {3, 5, 3 + W, 5 + H};
    uint16_t *const low = memory + BORDER, *const high = low + CELLS + BORDER;
    struct etch_surface s;
    int32_t n = 0;

    for (uint32_t i = 0; i < sizeof memory / sizeof *memory; i++)
        memory[i] = MARK;
    CHECK_EQ(etch_surface_init(&s, depth_first ? high : low, window, W), ETCH_OK);
    s.depth = depth_first ? low : high;
    s.clip = clip;
    draw_everything(&s);
    for (uint32_t i = 0; i < sizeof memory / sizeof *memory; i++)
        n += memory[i] != MARK;
    return n;
}

static void inverted_clips_draw_nothing(void)
{
    static const struct etch_rect clips[] = {{30, 5, 10, 8}, {10, 8, 30, 5}, {30, 8, 10, 5},
                                             {20, 5, 20, 8}, {3, 6, 43, 6},  {43, 5, 3, 8}};

    for (uint32_t i = 0; i < sizeof clips / sizeof *clips; i++) {
        CHECK_EQ(changed(clips[i], false), 0);
        CHECK_EQ(changed(clips[i], true), 0);
    }
}

static void the_order_of_the_planes_changes_nothing(void)
{
    const struct etch_rect window = {3, 5, 3 + W, 5 + H};

    CHECK_EQ(changed(window, false), 2 * CELLS);
    CHECK_EQ(changed(window, true), 2 * CELLS);
}

void suite_clip_inverted(void);

void suite_clip_inverted(void)
{
    RUN(inverted_clips_draw_nothing);
    RUN(the_order_of_the_planes_changes_nothing);
}
