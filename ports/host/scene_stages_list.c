/* ports/host/scene_stages_list.c: lists of stages as they grow. scene_stages.c and the files of its
 * parts append to them. */
#include "scene_stages.h"

#include <stdio.h>
#include <string.h>

void etch_scene_add_varying(struct etch_scene_builder *b, etch_varying *varying)
{
    b->staged->varyings[b->varyings++] = varying;
}

void etch_scene_add_varyings(struct etch_scene_builder *b, etch_varying *varying,
                             etch_line_varying *of_line)
{
    etch_scene_add_varying(b, varying);
    b->staged->line_varyings[b->line_varyings++] = of_line;
}

static void append(char *names, size_t size, const char *name)
{
    const size_t used = strlen(names);

    (void)snprintf(names + used, size - used, "%s%s", used != 0 ? " " : "", name);
}

void etch_scene_add_name(struct etch_scene_builder *b, const char *name)
{
    for (int order = 0; order < 2; order++) {
        append(b->staged->names[order], sizeof b->staged->names[order], name);
    }
}

void etch_scene_add_stage(struct etch_scene_builder *b, struct etch_scene_stage_name stage,
                          const void *data)
{
    struct etch_scene_staged *s = b->staged;

    if (stage.run != NULL) {
        s->stages[0][b->stages] = (struct etch_stage){stage.run, data};
        s->stages[1][b->stages++] = (struct etch_stage){stage.run, data};
        etch_scene_add_name(b, stage.name);
    }
}

void etch_scene_add_order(struct etch_scene_builder *b, struct etch_scene_stage_name stage,
                          struct etch_scene_stage_name swapped)
{
    struct etch_scene_staged *s = b->staged;

    s->stages[0][b->stages] = (struct etch_stage){stage.run, NULL};
    s->stages[1][b->stages++] = (struct etch_stage){swapped.run, NULL};
    append(s->names[0], sizeof s->names[0], stage.name);
    append(s->names[1], sizeof s->names[1], swapped.name);
}
