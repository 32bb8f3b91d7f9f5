/* bench/workloads_mesh.c: W15, the torus through the vertex stage, Gouraud with depth. Counted
 * are the matrices, the vertices, assembly, culling and the triangles of one frame; not the two
 * clears. See bench.h. */
#include "bench.h"

#include "../../core/draw/mesh.h"
#include "../../core/fragment/gouraud.h"

static wl_vert vertices[WL_TORUS_NV];
static wl_face faces[WL_TORUS_NT];
static int16_t positions[WL_TORUS_NV * 3];
static uint8_t colors[WL_TORUS_NV * 3];
static struct etch_mesh_vertex buffer[WL_TORUS_NV];

static const struct etch_mesh torus = {.positions = positions,
                                       .colors = colors,
                                       .indices = faces[0].v,
                                       .vertex_count = WL_TORUS_NV,
                                       .triangle_count = WL_TORUS_NT,
                                       .extent = WL_TORUS_R + WL_TORUS_r,
                                       .bits = 0};

static void prepare(void)
{
    wl_make_torus(vertices, faces);
    for (int i = 0; i < WL_TORUS_NV; i++) {
        positions[3 * i] = vertices[i].x;
        positions[3 * i + 1] = vertices[i].y;
        positions[3 * i + 2] = vertices[i].z;
        colors[3 * i] = (uint8_t)wl_r8(vertices[i].c);
        colors[3 * i + 1] = (uint8_t)wl_g8(vertices[i].c);
        colors[3 * i + 2] = (uint8_t)wl_b8(vertices[i].c);
    }
}

/* Rotation of the frame, then the object's centre moved before the camera. */
static void model_to_eye(struct etch_matrix *m, uint8_t frame)
{
    int32_t rotation_q14[9];

    wl_frame_matrix(frame, rotation_q14);
    etch_matrix_translate(m, 0, 0, -WL_CAM_DIST * ETCH_Q16_ONE);
    for (int i = 0; i < 9; i++)
        m->m[i / 3][i % 3] = rotation_q14[i] * 4;
}

void bench_torus_draw(uint8_t frame, struct etch_sink *sink)
{
    const struct etch_rect screen = {0, 0, WL_W, WL_H};
    struct etch_assembly assembly = {.cull = ETCH_CULL_CLOCKWISE, .sink = sink};
    struct etch_matrix eye, clip;
    struct etch_mesh_stage stage;

    (void)etch_viewport_init(&assembly.viewport, screen);
    model_to_eye(&eye, frame);
    (void)etch_matrix_perspective_focal(&clip, ETCH_Q16(2 * WL_FOCAL, WL_H), ETCH_Q16(WL_W, WL_H),
                                        WL_NEAR * ETCH_Q16_ONE, WL_FAR * ETCH_Q16_ONE);
    /* The workload has pixel centres on the integers: half a pixel right and down, times
     * w = -z, rounded. */
    clip.m[0][2] = -(ETCH_Q16(2, WL_W) + 1) / 2;
    clip.m[1][2] = (ETCH_Q16(2, WL_H) + 1) / 2;
    (void)etch_matrix_multiply(&clip, &clip, &eye);
    etch_mesh_stage_init(&stage, &torus, &clip, etch_vertex_plain, NULL);
    (void)etch_mesh_draw(&stage, &assembly, buffer, WL_TORUS_NV);
}

static void draw(const struct etch_surface *s, uint8_t frame)
{
    struct etch_raster_sink raster;

    etch_raster_sink_init(&raster, s, etch_triangle_gouraud_depth, etch_kernel_gouraud_less);
    bench_torus_draw(frame, &raster.sink);
}

const struct bench_workload bench_w15 = {WL_NFRAME, true, prepare, draw};
