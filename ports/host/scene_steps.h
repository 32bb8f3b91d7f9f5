/* ports/host/scene_steps.h: what the parts of the scene reader share; no part of its API.
 *
 * A statement is a row of a table: its name, a function that reads the rest of the line, and
 * often one that draws. Reading appends steps to the scene, drawing walks them. Tables:
 *
 *      scene_frame.c     scene strip format frac clear cleardepth clearstencil
 *      scene_shapes.c    point line rect fillrect circle disc triangle filltriangle
 *      scene_toolkit.c   smooth solid
 *      scene_fill.c      fill draw;  scene_brush.c  brush opacity stipple;
 *                        scene_soft.c  soft
 *      scene_state.c     state
 *      scene_texture.c   texture
 *      scene_triangles.c tri ctri
 *      scene_view.c      camera perspective parallel canonical model
 *                        (model shadow in scene_shadow.c)
 *      scene_light.c     ambient light attenuation material
 *      scene_elements.c  list vertex index endlist primitive
 *      scene_answers.c   select feedback
 *      scene_text.c      font text textbox
 *      scene_image.c     image
 *      scene_images.c    blit stretch nine spin cursor xorrect copyrect scroll
 *      scene_lines.c     cline wideline cpoint (drawn by scene_line_paint.c)
 *      scene_lines_2d.c  ddaline halfspace gradient
 *      scene_lines_clip.c  clipline clippolygon cvline cvtri
 *      scene_mesh.c      mesh
 *      scene_shaders.c   shadertri
 *      scene_polygons.c  polygon fillpolygon (also scene_polygon_ways.c);  scene_paths.c  fillpath
 *      scene_implicit.c  bezier quadric implicit
 *      scene_sorted.c    sorted end
 *      scene_passes.c    antialias motionblur motion filter exchange */
#ifndef ETCH_HOST_SCENE_STEPS_H
#define ETCH_HOST_SCENE_STEPS_H

#include "../../core/draw/mesh.h"
#include "../../core/fragment/phong.h"
#include "../../core/vertex/lamp.h"
#include "../../core/vertex/varying.h"
#include "scene.h"
#include "scene_pipeline.h"
#include "scene_texture.h"

struct elements;
struct etch_font;
struct etch_scene_image;
struct etch_scene_step;
struct etch_scene_pass;
struct etch_scene_brush;

/* A scene while it is drawn on a surface. */
struct etch_scene_run {
    struct etch_surface surface; /* first: the counting kernel finds the run behind it */
    struct etch_rect clip;       /* the surface's, without scissor */
    const struct etch_scene *scene;
    struct etch_scene_stats *stats;                 /* NULL: nothing is counted */
    etch_kernel *kernel;                            /* what the counting kernel calls, or NULL */
    const struct etch_perspective_kernels *texture; /* what those of textures call */
    uint16_t *scratch;         /* a colour plane, all zero, to count outlines on */
    struct etch_sink *collect; /* in a sorted block what triangles are given to, else NULL */
    const struct etch_scene_pass *pass; /* of several drawings, or NULL; see scene_passes.h */
    int32_t motion_x_q8, motion_y_q8;   /* of what follows, in all moments of motionblur */
};

typedef void etch_scene_draw_function(struct etch_scene_run *run,
                                      const struct etch_scene_step *step);

struct etch_scene_step {
    const struct etch_scene_statement *statement; /* whose draw is called */
    const struct etch_scene_pipeline *pipeline;   /* of triangles and meshes, else NULL */
    const char *needs;                            /* beside the statement's, or NULL */
    union {
        struct {
            int16_t at[6];
            uint8_t rgb[3];
        } shape;
        uint8_t rgb[3];        /* clear */
        uint16_t depth;        /* cleardepth */
        uint8_t stencil;       /* clearstencil */
        struct etch_rect clip; /* state scissor */
        struct {
            enum etch_cull cull;
            struct etch_texture_vertex v[3];
            struct etch_texture texture; /* read if the pipeline has one */
        } triangle;
        struct {
            enum etch_cull cull;
            struct etch_clip_texture_vertex v[3];
            struct etch_texture texture;
        } clip_triangle;
        const struct etch_scene_mesh *mesh;
        const void *data; /* from etch_scene_data, for statements with more to keep */
    } of;
};

#define ETCH_SCENE_LIGHTS 8

/* What the statements of scene_view.c and scene_light.c set up for the next mesh. */
struct etch_scene_view {
    struct etch_matrix model;
    struct etch_vector eye, target, up;
    bool parallel, canonical, frustum;
    etch_q16 angle_of_view; /* degrees, up and down */
    etch_q16 height, near, far;
    struct etch_box box; /* of a frustum */
    uint8_t ambient[3], material[4];
    uint8_t light_count;
    struct etch_vector light_towards[ETCH_SCENE_LIGHTS];
    uint8_t light_color[ETCH_SCENE_LIGHTS][3];

    bool lamps; /* asked for more than diffuse light from far away */
    bool blinn;
    struct etch_lamp lamp[ETCH_SCENE_LIGHTS]; /* the same lights */
    struct etch_material surface;
};

/* The primitive function of the meshes and lists that follow; see scene_primitive.h. */
enum {
    ETCH_SCENE_NO_PRIMITIVE,
    ETCH_SCENE_SHRINK,
    ETCH_SCENE_WIREFRAME
};
struct etch_scene_primitive_choice {
    uint8_t kind, percent;
};

/* A scene while it is read. */
struct etch_scene_reader {
    struct etch_scene *scene;
    struct etch_text text;
    int frac;
    struct etch_scene_state state;
    struct etch_scene_view view;
    struct etch_scene_primitive_choice primitive;
    struct etch_scene_texture *texture;   /* the latest, or NULL */
    struct etch_scene_sorted *sorted;     /* the block that is open, or NULL */
    struct etch_scene_staged *staged;     /* the latest pipeline of stages, or NULL */
    const struct etch_phong *phong;       /* of the mesh in hand, else NULL */
    const struct etch_font *font;         /* the latest, or NULL; of text */
    const struct etch_scene_image *image; /* the latest, or NULL; of blit and its like */
    struct elements *elements;            /* the list between list and endlist, else NULL */

    const struct etch_scene_brush *brush; /* the latest, or NULL; of fill, draw, smooth and solid */
};

struct etch_scene_statement {
    const char *name;
    bool (*read)(struct etch_scene_reader *reader, const struct etch_scene_statement *statement);
    etch_scene_draw_function *draw;
    const char *needs;            /* functions of etch that it draws with, for --needs */
    const char *const *arguments; /* names of the integers that follow, NULL-terminated */
};

bool etch_scene_read_texture(struct etch_scene_reader *reader,
                             const struct etch_scene_statement *statement);

/* Describes the latest texture; false, with an error set, if there is none or it is not of a size
 * that etch draws. */
bool etch_scene_take_texture(struct etch_scene_reader *reader, struct etch_texture *texture);

/* Brings all textures to the scene's format, once all of it is read. */
void etch_scene_textures_finish(struct etch_scene *scene);

void etch_scene_textures_free(struct etch_scene *scene);

/* NULL-terminated by name. */
extern const struct etch_scene_statement etch_scene_frame_statements[];
extern const struct etch_scene_statement etch_scene_shape_statements[];
extern const struct etch_scene_statement etch_scene_toolkit_statements[];
extern const struct etch_scene_statement etch_scene_fill_statements[];
extern const struct etch_scene_statement etch_scene_brush_statements[];
extern const struct etch_scene_statement etch_scene_soft_statements[];
extern const struct etch_scene_statement etch_scene_state_statements[];
extern const struct etch_scene_statement etch_scene_triangle_statements[];
extern const struct etch_scene_statement etch_scene_view_statements[];
extern const struct etch_scene_statement etch_scene_light_statements[];
extern const struct etch_scene_statement etch_scene_elements_statements[];
extern const struct etch_scene_statement etch_scene_answer_statements[];
extern const struct etch_scene_statement etch_scene_text_statements[];
extern const struct etch_scene_statement etch_scene_image_statements[];
extern const struct etch_scene_statement etch_scene_images_statements[];
extern const struct etch_scene_statement etch_scene_mesh_statements[];
extern const struct etch_scene_statement etch_scene_polygon_statements[];
extern const struct etch_scene_statement etch_scene_path_statements[];
extern const struct etch_scene_statement etch_scene_implicit_statements[];
extern const struct etch_scene_statement etch_scene_sorted_statements[];
extern const struct etch_scene_statement etch_scene_pass_statements[];
extern const struct etch_scene_statement etch_scene_line_statements[];
extern const struct etch_scene_statement etch_scene_line_clip_statements[];
extern const struct etch_scene_statement etch_scene_line_2d_statements[];
extern const struct etch_scene_statement etch_scene_shader_statements[];

/* ---- for reading ------------------------------------------------------------------------ */

/* Appends an empty step; NULL, with an error set, without memory. */
struct etch_scene_step *etch_scene_append(struct etch_scene_reader *reader,
                                          const struct etch_scene_statement *statement);

/* `size` bytes of zeros that live as long as the scene; NULL, with an error set, without memory. */
void *etch_scene_data(struct etch_scene_reader *reader, size_t size);

/* Covers of a row for smooth shapes: as wide as the frame, and a column more for samples that
 * pixels share, and the one that the shapes ask for. */
int16_t *etch_scene_covers(struct etch_scene_reader *reader);

/* R G B, 0 .. 255 each. */
bool etch_scene_read_rgb(struct etch_scene_reader *reader, uint8_t rgb[3]);

/* The 16-bit integers that the statement names, then a colour, into a new step's of.shape. */
bool etch_scene_read_shape(struct etch_scene_reader *reader,
                           const struct etch_scene_statement *statement);

/* A coordinate in 2^-frac px to 1/256 px: to 16.16 exactly, then as every 16.16 is snapped. */
bool etch_scene_read_position(struct etch_scene_reader *reader, const char *name, int32_t *q8);

/* One 0 .. 255. */
bool etch_scene_read_byte(struct etch_scene_reader *reader, const char *name, uint8_t *value);

/* Takes the next word if it is `name`. */
bool etch_scene_take(struct etch_scene_reader *reader, const char *name);

/* Takes a file's name, which is relative to the scene's folder unless it begins with `/`. The path
 * stays the scene's, which keeps a list of its files; *name is the name as it was given. NULL,
 * with an error set, without a name or memory. */
const char *etch_scene_path(struct etch_scene_reader *reader, const char **name);

/* Reads the rest of `model shadow`: the matrix that flattens a model to its shadow on a plane. */
bool etch_scene_read_shadow(struct etch_scene_reader *reader, struct etch_matrix *m);

/* The model-to-clip matrix of the view; false, with an error set, if it has none. */
bool etch_scene_model_to_clip(struct etch_scene_reader *reader, struct etch_matrix *m);

/* The pipeline for the state as it stands, for primitives whose colours are linear on the screen;
 * NULL, with an error set, if etch has none. */
const struct etch_scene_pipeline *etch_scene_read_pipeline(struct etch_scene_reader *reader);

/* The same for lines and points, which have neither texture nor perspective; its staged lists are
 * those of lines and of triangles. */
const struct etch_scene_pipeline *etch_scene_read_line_pipeline(struct etch_scene_reader *reader);

/* The same for triangles: what their vertices differ in that concerns perspective. */
struct etch_scene_differs {
    bool w, color;
};
const struct etch_scene_pipeline *
etch_scene_read_triangle_pipeline(struct etch_scene_reader *reader,
                                  struct etch_scene_differs differs);

/* Reads what follows the name of a state of fragments: atest, stencil, blend, fog ..; *known says
 * whether the name is one. */
bool etch_scene_read_fragment_state(struct etch_scene_reader *reader, struct etch_word name,
                                    bool *known);

/* Which winding the state culls. */
enum etch_cull etch_scene_cull(const struct etch_scene_state *state);

/* Gives a mesh back. */
void etch_scene_mesh_free(struct etch_scene_mesh *mesh);

/* ---- for drawing ------------------------------------------------------------------------ */

uint16_t etch_scene_color(const struct etch_scene_run *run, const uint8_t rgb[3]);

/* The kernel of a pipeline in the scene's format, behind the counting one if there are stats. */
etch_kernel *etch_scene_kernel(struct etch_scene_run *run,
                               const struct etch_scene_pipeline *pipeline);

/* Paints one triangle of a pipeline with a texture, or of stages: then `texture` is not read. */
void etch_scene_paint_texture(struct etch_scene_run *run,
                              const struct etch_scene_pipeline *pipeline,
                              const struct etch_texture_vertex *const v[3],
                              const struct etch_texture *texture);
etch_triangle_painter *etch_scene_painter(const struct etch_scene_run *run,
                                          const struct etch_scene_pipeline *pipeline);

/* The sink of draw/mesh.h, which also counts triangles. */
struct etch_scene_sink {
    struct etch_raster_sink raster; /* first; give &raster.sink to etch_assembly */
    struct etch_scene_run *run;
    const struct etch_scene_pipeline *pipeline;
};
void etch_scene_sink_init(struct etch_scene_sink *sink, struct etch_scene_run *run,
                          const struct etch_scene_pipeline *pipeline);

/* Clears the planes of a run and makes its scratch; false without memory. */
bool etch_scene_run_open(struct etch_scene_run *run);
void etch_scene_run_close(struct etch_scene_run *run);

/* Draws the frame by the passes of scene->passes; see scene_passes.h. */
bool etch_scene_passes_draw(const struct etch_scene *scene, struct etch_surface *surface,
                            struct etch_scene_stats *stats);
void etch_scene_passes_free(struct etch_scene_passes *passes);

/* Paint one triangle as run->pass, which is not NULL, places it. */
void etch_scene_pass_triangle(struct etch_scene_run *run,
                              const struct etch_scene_pipeline *pipeline,
                              const struct etch_vertex *const v[3]);
void etch_scene_pass_texture(struct etch_scene_run *run, const struct etch_scene_pipeline *pipeline,
                             const struct etch_texture_vertex *const v[3],
                             const struct etch_texture *texture);

/* Counts runs and pixels into the run's stats, then calls run->kernel unless it is NULL. */
etch_kernel etch_scene_count;

#endif
