/* ports/host/scene_primitive.c: the statement primitive, and the functions between assembly and
 * clipping that it names. scene_elements.c has it in its table; meshes and lists install what it
 * chose. */
#include "scene_primitive.h"

/* c + (v - c) percent / 100, c the centre of the three: linear, so it may be done in clip space. */
static etch_q16 towards(etch_q16 v, int64_t sum, uint8_t percent)
{
    return (etch_q16)((3 * (int64_t)v * percent + sum * (100 - percent)) / 300);
}

/* A smaller triangle about the same centre. */
static void shrink(const struct etch_mesh_primitive *primitive, const struct etch_clip_vertex *v)
{
    const uint8_t percent = ((const struct etch_scene_primitive *)(const void *)primitive)->percent;
    struct etch_clip_vertex out[3];
    const int64_t x = (int64_t)v[0].x + v[1].x + v[2].x, y = (int64_t)v[0].y + v[1].y + v[2].y;
    const int64_t z = (int64_t)v[0].z + v[1].z + v[2].z, w = (int64_t)v[0].w + v[1].w + v[2].w;

    for (int i = 0; i < 3; i++) {
        out[i] = v[i];
        out[i].x = towards(v[i].x, x, percent);
        out[i].y = towards(v[i].y, y, percent);
        out[i].z = towards(v[i].z, z, percent);
        out[i].w = towards(v[i].w, w, percent);
    }
    etch_assemble_triangle(primitive->assembly, out);
}

/* The three edges as lines. */
static void wireframe(const struct etch_mesh_primitive *primitive, const struct etch_clip_vertex *v)
{
    for (int i = 0; i < 3; i++) {
        const struct etch_clip_vertex ends[2] = {v[i], v[(i + 1) % 3]};

        etch_assemble_line(primitive->assembly, ends);
    }
}

void etch_scene_primitive_init(struct etch_scene_primitive *primitive,
                               const struct etch_scene_primitive_choice *choice,
                               const struct etch_mesh_stage *stage,
                               const struct etch_assembly *assembly)
{
    primitive->percent = choice->percent;
    etch_mesh_primitive_init(&primitive->primitive,
                             choice->kind == ETCH_SCENE_SHRINK ? shrink : wireframe, 3, stage,
                             assembly);
}

/* none|wireframe|shrink PERCENT */
bool etch_scene_read_primitive(struct etch_scene_reader *reader,
                               const struct etch_scene_statement *statement)
{
    static const char *const words[] = {"none", "shrink", "wireframe", NULL};
    int64_t percent = 0;
    int kind;

    (void)statement;
    if (!etch_text_choice(&reader->text, "primitive", words, &kind) ||
        (kind == ETCH_SCENE_SHRINK &&
         !etch_text_integer(&reader->text, "percent", 1, 100, &percent))) {
        return false;
    }
    reader->primitive = (struct etch_scene_primitive_choice){(uint8_t)kind, (uint8_t)percent};
    return true;
}
