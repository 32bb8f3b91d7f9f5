/* draw/texture_setup.h: what the painters of texture.h share; no part of the API. */
#ifndef ETCH_DRAW_TEXTURE_SETUP_H
#define ETCH_DRAW_TEXTURE_SETUP_H

#include "../fragment/texture.h"
#include "../raster/texture_plane.h"
#include "setup.h"
#include "texture.h"

ETCH_INLINE struct etch_texel_map setup_map(const struct etch_texture *t)
{
    const struct etch_texel_map map = {t->texels, ((UINT32_C(1) << t->width_bits) - 1) << 1,
                                       ((UINT32_C(1) << t->height_bits) - 1)
                                           << (t->width_bits + 1)};

    return map;
}

/* The plain vertices, which edges and depth are set up from. */
#define SETUP_PLAIN(v)                                                                             \
    {                                                                                              \
        &(v)[0]->at, &(v)[1]->at, &(v)[2]->at                                                      \
    }

#endif
