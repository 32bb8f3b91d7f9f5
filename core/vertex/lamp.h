/* vertex/lamp.h: lights of several kinds, materials, and what comes of them.
 *
 *      C = emission + color (ambient Ma + sum of F D Md max(0, N . L))
 *                   + sum of F S Ms max(0, R . V)^shininess, where N . L > 0
 *
 * a channel, 255 is 1, at most 255. color is the surface's own, D and S the lamp's diffuse and
 * specular colour, M.. the material's. N is the normal, L the unit vector to the lamp, R is L
 * mirrored at N, V the unit vector to the eye. F is 1, or for a lamp with attenuation
 * 1 / (constant + linear d + quadratic d^2) at distance d. Blinn's variant has N . H in the place
 * of R . V, H half way between L and V. All of it is in world space.
 *
 *      sum up with                   reads
 *      etch_shade_diffuse            no specular light, no eye
 *      etch_shade_phong              R . V
 *      etch_shade_blinn              N . H
 *
 *      lamps of kind                 place is
 *      etch_lamp_directional         the unit vector towards it in 2.14 (etch_lamp_aim)
 *      etch_lamp_point               its position, 16.16
 *      etch_lamp_attenuated          its position, with F
 *
 * Only what is named is linked; a kind of your own is a function of the same type. etch_vertex_lit
 * (draw/mesh.h) with light.h is the cheap choice: diffuse, directional, no eye.
 *
 * Precision. With the N, L, V and F that the functions below work out (N, L, V in 2.14, within 2
 * units; F within 2^-12 of it and 2^-15), a channel errs by at most 1/2 + 1/32 for its rounding and
 * 1/16 a lamp for its diffuse, 1/8 for its specular light. F above 4 counts as 4, sums of light
 * above 8 as 8. Source: B. T. Phong, "Illumination for computer generated pictures", 1975;
 * J. Blinn, "Models of light reflection for computer synthesized pictures", 1977.
 */
#ifndef ETCH_VERTEX_LAMP_H
#define ETCH_VERTEX_LAMP_H

#include "../base/shade.h"
#include "matrix.h"

/* What a lamp gives at a point. */
struct etch_incidence {
    int16_t towards[3];     /* unit, 2.14: L */
    uint32_t intensity_q16; /* F, at most 4.0 */
};

struct etch_lamp;
typedef void etch_lamp_function(const struct etch_lamp *lamp, const etch_q16 position[3],
                                struct etch_incidence *out);

struct etch_lamp {
    etch_lamp_function *kind;
    struct etch_vector place;             /* see above */
    uint8_t diffuse[3], specular[3];      /* r, g, b */
    etch_q16 constant, linear, quadratic; /* >= 0; read by etch_lamp_attenuated: for distances in
                                            world units */
};

etch_lamp_function etch_lamp_directional;
etch_lamp_function etch_lamp_point;
etch_lamp_function etch_lamp_attenuated;

/* Makes `lamp` directional, in the direction of `towards`, of any length but zero (ETCH_EINVAL, and
 * nothing changed). Colours are left. */
enum etch_status etch_lamp_aim(struct etch_lamp *lamp, const struct etch_vector *towards);

struct etch_material {
    uint8_t ambient[3], diffuse[3], specular[3], emission[3];
    uint8_t shininess; /* exponent, 0 .. 255 */
};

/* ambient = diffuse = white, specular = emission = black. */
void etch_material_init(struct etch_material *material);

/* The `lighting` of the shade functions. */
struct etch_lamps {
    uint8_t ambient[3]; /* light from everywhere */
    uint8_t count;      /* of lamps */
    const struct etch_lamp *lamp;
    const struct etch_material *material;
    struct etch_vector eye; /* where the eye is, 16.16; .. */
    bool eye_is_far;        /* .. or the unit vector towards it in 2.14, as in parallel views */
};

/* On Cortex-M0+ a point with etch_shade_phong, shininess 20, the eye near, costs 870 instructions
 * (1150 cycles) without a lamp, and for each lamp that it faces 375 (460) directional, 600 (760)
 * point, 1620 (2120) attenuated. */
etch_shade_function etch_shade_diffuse;
etch_shade_function etch_shade_phong;
etch_shade_function etch_shade_blinn;

#endif
