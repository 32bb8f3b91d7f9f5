/* tradeoff/flash.c: a program that draws with one mode, -DMODE=name: what that weighs. See
 * tradeoff.mk. */
#include "tradeoff.h"

#define DRAW_OF(name) draw_##name
#define DRAW(name) DRAW_OF(name)

struct tradeoff_scene *volatile scene;
const struct etch_surface *volatile surface;
uint16_t tradeoff_texels[TRADEOFF_TEXTURE * TRADEOFF_TEXTURE];

int main(void);

int main(void)
{
    DRAW(MODE)(surface, scene);
    return 0;
}
