/* bench/growth.c: the firmware behind `make growth`: one drawing whose cost is counted between the
 * markers of plugin.c. Which one, and how large, growth.py writes into memory before the start. It
 * draws what the point says, and writes out the frame and how many pixels it has. */
#include "bench.h"

#include "../../core/draw/mesh.h"
#include "../../core/draw/retained.h"
#include "../../core/draw/retained_rows.h"
#include "../../core/fragment/gouraud.h"
#include "workloads_mesh.c" /* the torus and its matrices */

enum series {
    TRIANGLE_SIZE,   /* x: sides of 8 triangles, in 1/16 px */
    TRIANGLE_COUNT,  /* x: cells of a grid over the screen, each way; two triangles each */
    NEAR_FIRST,      /* x: layers over the screen, front to back */
    FAR_FIRST,       /* .. back to front */
    STRIPS_REDRAWN,  /* W15, x: rows of a strip; everything again for each strip */
    STRIPS_VERTICES, /* .. vertices kept */
    STRIPS_ROWS,     /* .. and the rows of visible triangles */
    STRIPS_SETUP     /* .. and their set-up */
};

static const volatile struct {
    uint32_t series, x;
} *const point = (const volatile void *)(uintptr_t)0x20380000;

#define CELLS 159

static uint32_t color[WL_W * WL_H / 2], depth[WL_W * WL_H / 2];
static struct etch_mesh_vertex kept_vertices[WL_TORUS_NV];
static struct etch_retained_triangle kept_triangles[1024];
static struct etch_mesh_row_range kept_rows[1024];
static int16_t grid_position[(CELLS + 1) * (CELLS + 1) * 3];
static uint8_t grid_color[(CELLS + 1) * (CELLS + 1) * 3];
static uint16_t grid_index[CELLS * CELLS * 6];
static struct etch_mesh_vertex grid_buffer[(CELLS + 1) * (CELLS + 1)];
static struct etch_mesh grid;
static uint32_t pixels;

int main(void);
void bench_counted(const struct etch_surface *s, uint32_t series, uint32_t x);
void bench_done(void);

__attribute__((noinline)) void bench_done(void)
{
    __asm__ volatile("");
}

/* ---- triangles of a size ------------------------------------------------------------------- */

static void triangle_size(const struct etch_surface *s, uint32_t x, uint32_t i, uint32_t end)
{
    for (; i < end; i++) {
        const int32_t at = (int32_t)(i * 37), side = (int32_t)x * 16;
        const uint32_t z = (9 - i) << 24;
        const struct etch_vertex a = {at, at, z, 255, 0, (uint8_t)at, 255};
        const struct etch_vertex b = {at + side, at + side / 8, z, 0, 255, 0, 255};
        const struct etch_vertex c = {at + side / 8, at + side, z - 65536, 0, 0, 255, 255};
        const struct etch_vertex *const v[3] = {&a, &b, &c};

        etch_triangle_gouraud_depth(s, v, etch_kernel_gouraud_less);
    }
}

/* ---- a grid of triangles over the screen ---------------------------------------------------- */

static void make_grid(uint32_t cells)
{
    uint16_t *index = grid_index;

    for (uint32_t i = 0; i <= cells; i++)
        for (uint32_t j = 0; j <= cells; j++) {
            const uint32_t at = (i * (cells + 1) + j) * 3;

            grid_position[at] = (int16_t)((int32_t)(j * 16000 / cells) - 8000);
            grid_position[at + 1] = (int16_t)(8000 - (int32_t)(i * 16000 / cells));
            grid_position[at + 2] = (int16_t)((i ^ j) & 1 ? 400 : -400);
            grid_color[at] = (uint8_t)(255 * i / cells);
            grid_color[at + 1] = (uint8_t)(255 * j / cells);
        }
    for (uint32_t i = 0; i < cells; i++)
        for (uint32_t j = 0; j < cells; j++) {
            const uint16_t a = (uint16_t)(i * (cells + 1) + j);
            const uint16_t b = (uint16_t)(a + cells + 1);

            *index++ = a, *index++ = b, *index++ = (uint16_t)(b + 1);
            *index++ = a, *index++ = (uint16_t)(b + 1), *index++ = (uint16_t)(a + 1);
        }
    grid.positions = grid_position;
    grid.colors = grid_color;
    grid.indices = grid_index;
    grid.vertex_count = (uint16_t)((cells + 1) * (cells + 1));
    grid.triangle_count = (uint16_t)(cells * cells * 2);
    grid.extent = 8000;
    grid.bits = 13;
}

/* Parallel projection of the grid, a layer at the depth z (in -1 .. 1 of 16.16). */
static void draw_grid(const struct etch_surface *s, etch_q16 z)
{
    struct etch_assembly assembly = {.cull = ETCH_CULL_CLOCKWISE};
    struct etch_raster_sink raster;
    struct etch_mesh_stage stage;
    struct etch_matrix clip;

    etch_raster_sink_init(&raster, s, etch_triangle_gouraud_depth, etch_kernel_gouraud_less);
    assembly.sink = &raster.sink;
    (void)etch_viewport_init(&assembly.viewport, s->clip);
    etch_matrix_translate(&clip, 0, 0, z);
    clip.m[2][2] = 1024;
    clip.m[0][0] = clip.m[1][1] = ETCH_Q16(11, 10);
    etch_mesh_stage_init(&stage, &grid, &clip, etch_vertex_plain, NULL);
    (void)etch_mesh_draw(&stage, &assembly, grid_buffer, (CELLS + 1) * (CELLS + 1));
}

static void layers(const struct etch_surface *s, uint32_t n, bool near_first)
{
    for (uint32_t i = 0; i < n; i++)
        draw_grid(s, (etch_q16)((near_first ? i : n - 1 - i) * 3000) - 30000);
}

/* ---- W15 in strips -------------------------------------------------------------------------- */

/* What all strips share: the torus of frame 0, in its own stage. */
static void torus_stage(struct etch_mesh_stage *stage, struct etch_assembly *assembly)
{
    const struct etch_rect screen = {0, 0, WL_W, WL_H};
    struct etch_matrix eye, clip;

    assembly->cull = ETCH_CULL_CLOCKWISE;
    assembly->flat = false;
    (void)etch_viewport_init(&assembly->viewport, screen);
    model_to_eye(&eye, 0);
    (void)etch_matrix_perspective_focal(&clip, ETCH_Q16(2 * WL_FOCAL, WL_H), ETCH_Q16(WL_W, WL_H),
                                        WL_NEAR * ETCH_Q16_ONE, WL_FAR * ETCH_Q16_ONE);
    clip.m[0][2] = -(ETCH_Q16(2, WL_W) + 1) / 2;
    clip.m[1][2] = (ETCH_Q16(2, WL_H) + 1) / 2;
    (void)etch_matrix_multiply(&clip, &clip, &eye);
    etch_mesh_stage_init(stage, &torus, &clip, etch_vertex_plain, NULL);
}

static void strips(const struct etch_surface *frame, uint32_t series, uint32_t rows)
{
    struct etch_surface s = *frame;
    struct etch_assembly assembly;
    struct etch_mesh_stage stage;
    struct etch_raster_sink raster;
    struct etch_retained retained;
    uint16_t visible = 0;

    etch_raster_sink_init(&raster, &s, etch_triangle_gouraud_depth, etch_kernel_gouraud_less);
    etch_retained_init(&retained, frame->clip, etch_kernel_gouraud_less, kept_triangles, 1024);
    assembly.sink = series == STRIPS_SETUP ? &retained.sink : &raster.sink;
    if (series != STRIPS_REDRAWN) {
        torus_stage(&stage, &assembly);
        etch_mesh_transform(&stage, &assembly.viewport, kept_vertices);
    }
    if (series == STRIPS_ROWS)
        visible = etch_mesh_rows(&stage, &assembly, kept_vertices, kept_rows, 1024);
    if (series == STRIPS_SETUP)
        etch_mesh_assemble(&stage, &assembly, kept_vertices);
    for (uint32_t y = 0; y < WL_H; y += rows) {
        const uint32_t y1 = y + rows < WL_H ? y + rows : WL_H;

        s.clip.y0 = s.window.y0 = (int16_t)y;
        s.clip.y1 = s.window.y1 = (int16_t)y1;
        s.pixels = frame->pixels + y * WL_W; /* a strip of its own as far as drawing knows */
        s.depth = frame->depth + y * WL_W;
        if (series == STRIPS_REDRAWN)
            bench_torus_draw(0, &raster.sink);
        else if (series == STRIPS_VERTICES)
            etch_mesh_assemble(&stage, &assembly, kept_vertices);
        else if (series == STRIPS_ROWS)
            etch_mesh_assemble_rows(&stage, &assembly, kept_vertices, kept_rows, visible, s.clip.y0,
                                    s.clip.y1);
        else
            etch_retained_draw(&retained, &s);
    }
}

/* ---- one point --------------------------------------------------------------------------------
 */

__attribute__((noinline)) void bench_counted(const struct etch_surface *s, uint32_t series,
                                             uint32_t x)
{
    switch (series) {
    case TRIANGLE_SIZE: triangle_size(s, x, 0, 8); break;
    case TRIANGLE_COUNT: draw_grid(s, 0); break;
    case NEAR_FIRST: layers(s, x, true); break;
    case FAR_FIRST: layers(s, x, false); break;
    default: strips(s, series, x); break;
    }
    bench_done();
}

static void clear_depth(void)
{
    for (int i = 0; i < WL_W * WL_H / 2; i++)
        depth[i] = 0xFFFFFFFF;
}

static void count_pixels(const struct etch_surface *s)
{
    for (int i = 0; i < WL_W * WL_H; i++)
        pixels += s->depth[i] != 0xFFFF;
}

int main(void)
{
    const struct etch_rect window = {0, 0, WL_W, WL_H};
    const uint32_t series = point->series, x = point->x;
    struct etch_surface s;

    if (etch_surface_init(&s, (uint16_t *)color, window, WL_W) != ETCH_OK)
        return 1;
    s.depth = (uint16_t *)depth;
    prepare();
    make_grid(series == TRIANGLE_COUNT ? x : 2);
    clear_depth();
    bench_counted(&s, series, x);
    bench_write("frame.565", color, sizeof color);
    if (series != TRIANGLE_SIZE)
        count_pixels(&s);
    else
        for (uint32_t i = 0; i < 8; i++) { /* they overlap: one at a time */
            clear_depth();
            triangle_size(&s, x, i, i + 1);
            count_pixels(&s);
        }
    bench_write("pixels", &pixels, sizeof pixels);
    return 0;
}
