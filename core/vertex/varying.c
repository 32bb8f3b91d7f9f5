/* vertex/varying.c: triangles with varyings to the sink. Called by draw/mesh_varying and by
 * applications. See varying.h; clipping is corner_clip.c's, as for plain triangles. */
#include "varying.h"
#include "corner.h"
#include "fan.h"

enum {
    W_BITS = 31 /* fraction bits of a new corner's w before the unit is known */
};

/* A vertex on the screen; its first members are those of etch_texture_vertex. */
struct screen_vertex {
    struct etch_vertex at;
    int32_t first[2];
    uint32_t w;
    int32_t more[ETCH_VARYINGS - 2];
};

static const int32_t *varyings(const struct etch_clip_vertex *v)
{
    return (const int32_t *)(const void *)(v + 1);
}

static int32_t *place(struct screen_vertex *v, uint8_t i)
{
    return i < 2 ? &v->first[i] : &v->more[i - 2];
}

/* At most 62 bits to at most 32: as 63 bits with W_BITS, the largest's leading one to bit 31. */
static void common_unit(struct screen_vertex *out, const uint64_t *w, uint8_t n)
{
    uint64_t most = 0;
    uint8_t down = 0;

    for (uint8_t i = 0; i < n; i++)
        most |= w[i];
    while (most >> down > UINT32_MAX)
        down++;
    for (uint8_t i = 0; i < n; i++) {
        const uint64_t shifted = w[i] >> down;

        out[i].w = shifted == 0 ? 1 : (uint32_t)shifted;
    }
}

/* Sets one corner of a clipped triangle but for its w, which it returns with W_BITS more bits.
 * False if the corner is the eye itself: the triangle is seen edge-on. */
static bool set_corner(const struct etch_assembly *assembly, const struct corner_triangle *t,
                       const struct corner *corner, uint8_t count, struct screen_vertex *out,
                       uint64_t *w)
{
    const struct etch_clip_vertex *const a = t->v[0], *const b = t->v[1], *const c = t->v[2];
    const int32_t w3[3] = {a->w, b->w, c->w};
    struct corner_weights weights;
    struct etch_clip_vertex at;

    etch_corner_take(&at, t, corner);
    if (at.w <= 0)
        return false;
    if (assembly->flat)
        at.r = a->r, at.g = a->g, at.b = a->b, at.a = a->a;
    etch_viewport_project(&assembly->viewport, &at, &out->at);
    etch_corner_weights(&weights, t, corner);
    *w = (uint64_t)etch_corner_value(&weights, w3, W_BITS);
    for (uint8_t i = 0; i < count; i++) {
        const int32_t value[3] = {varyings(a)[i], varyings(b)[i], varyings(c)[i]};

        *place(out, i) = (int32_t)etch_corner_value(&weights, value, 0);
    }
    return true;
}

static ETCH_COLD void assemble_clipped(const struct etch_assembly *assembly,
                                       const struct etch_clip_vertex *const v[3], uint8_t count)
{
    const struct corner_triangle t = {
        {v[0], v[1], v[2]}, assembly->viewport.guard_x, assembly->viewport.guard_y};
    struct corner corner[ETCH_CLIP_MAX];
    struct screen_vertex out[ETCH_CLIP_MAX];
    uint64_t w[ETCH_CLIP_MAX];
    const struct etch_vertex *ring[ETCH_CLIP_MAX];
    const uint8_t n = etch_corner_clip(&t, corner);

    for (uint8_t i = 0; i < n; i++) {
        if (!set_corner(assembly, &t, &corner[i], count, &out[i], &w[i]))
            return;
        ring[i] = &out[i].at;
    }
    common_unit(out, w, n);
    etch_fan_emit(assembly, ring, n);
}

static ETCH_APART void assemble_whole(const struct etch_assembly *assembly,
                                      const struct etch_clip_vertex *const v[3], uint8_t count)
{
    struct screen_vertex out[3];
    const struct etch_vertex *const ring[3] = {&out[0].at, &out[1].at, &out[2].at};

    for (uint8_t i = 0; i < 3; i++)
        etch_varying_project(&assembly->viewport, v[i], count, &out[i].at);
    if (!etch_cull_keeps(assembly->cull, ring))
        return;
    for (uint8_t i = 1; assembly->flat && i < 3; i++) {
        out[i].at.r = out[0].at.r;
        out[i].at.g = out[0].at.g;
        out[i].at.b = out[0].at.b;
        out[i].at.a = out[0].at.a;
    }
    assembly->sink->triangle(assembly->sink, ring);
}

void etch_assemble_varying(const struct etch_assembly *assembly,
                           const struct etch_clip_vertex *const v[3], uint8_t count)
{
    const uint8_t n = count < 2 ? 2 : count > ETCH_VARYINGS ? ETCH_VARYINGS : count;
    uint8_t all = ETCH_OUT_REJECT, any = 0;

    for (uint8_t i = 0; i < 3; i++) {
        const uint8_t out = etch_viewport_outcode(&assembly->viewport, v[i]);

        all &= out;
        any |= out;
    }
    if (all != 0)
        return;
    if ((any & ETCH_OUT_CLIP) != 0)
        assemble_clipped(assembly, v, n);
    else
        assemble_whole(assembly, v, n);
}

void etch_assemble_textured(const struct etch_assembly *assembly,
                            const struct etch_clip_texture_vertex v[3])
{
    const struct etch_clip_vertex *const wide[3] = {&v[0].at, &v[1].at, &v[2].at};

    etch_assemble_varying(assembly, wide, 2);
}
