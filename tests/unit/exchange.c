/* tests/unit: images exchanged by exclusive or, against copies. */
#include "core/frame/exchange.h"
#include "tests/harness/canvas.h"
#include "tests/unit/passes_parts.h"

void suite_exchange(void);

static struct test_canvas canvas, second;

static void images_are_exchanged_inside_both_clips(void)
{
    static uint16_t a[PIXELS], b[PIXELS];
    const struct etch_rect moved = {7, 5, 7 + WIDTH, 5 + HEIGHT};
    const int32_t count = TEST_COUNT(100);
    uint32_t seed = 7;
    int32_t n, x, y, wrong = 0;

    for (n = 0; n < count; n++) {
        const struct etch_rect ca = random_clip(frame, &seed), cb = random_clip(moved, &seed);

        test_canvas_open(&canvas, frame);
        test_canvas_open(&second, moved);
        fill_random(&canvas.surface, &seed);
        fill_random(&second.surface, &seed);
        for (y = 0; y < HEIGHT; y++) {
            for (x = 0; x < WIDTH; x++) {
                a[y * WIDTH + x] = test_canvas_at(&canvas, x, y);
                b[y * WIDTH + x] = test_canvas_at(&second, x + 7, y + 5);
            }
        }
        etch_surface_clip(&canvas.surface, ca);
        etch_surface_clip(&second.surface, cb);
        (n % 3 == 0   ? etch_surface_exchange
         : n % 3 == 1 ? etch_surface_xor
                      : etch_surface_copy)(&canvas.surface, &second.surface);
        for (y = 0; y < HEIGHT + 5; y++) {
            for (x = 0; x < WIDTH + 7; x++) {
                const bool both = x >= ca.x0 && x < ca.x1 && y >= ca.y0 && y < ca.y1 &&
                                  x >= cb.x0 && x < cb.x1 && y >= cb.y0 && y < cb.y1;
                const bool in_a = x < WIDTH && y < HEIGHT, in_b = x >= 7 && y >= 5;
                const uint16_t pa = in_a ? a[y * WIDTH + x] : 0;
                const uint16_t pb = in_b ? b[(y - 5) * WIDTH + x - 7] : 0;
                const uint16_t want = n % 3 == 1 ? (uint16_t)(pa ^ pb) : pb;

                if (in_a)
                    wrong += test_canvas_at(&canvas, x, y) != (both ? want : pa);
                if (in_b)
                    wrong += test_canvas_at(&second, x, y) != (both && n % 3 == 0 ? pa : pb);
            }
        }
    }
    CHECK_EQ(wrong, 0);
}

static void an_image_exchanged_with_itself_stays(void)
{
    uint32_t seed = 8, hash;

    test_canvas_open(&canvas, frame);
    fill_random(&canvas.surface, &seed);
    hash = test_canvas_hash(&canvas);
    etch_surface_exchange(&canvas.surface, &canvas.surface);
    etch_surface_copy(&canvas.surface, &canvas.surface);
    CHECK_EQ(test_canvas_hash(&canvas), hash);
}

void suite_exchange(void)
{
    RUN(images_are_exchanged_inside_both_clips);
    RUN(an_image_exchanged_with_itself_stays);
}
