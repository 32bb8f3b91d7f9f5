/* ports/host/scene_sorted.c: blocks of triangles drawn from far to near, `sorted .. end`. scene.c
 * finds them by name, scene_draw.c calls what they append. Between the two, triangles and meshes
 * go to run->collect. */
#include "../../core/draw/ordering.h"
#include "../../core/draw/painter.h"
#include "scene_steps.h"

/* A block, and the memory that it is sorted in. */
struct etch_scene_sorted {
    struct etch_sink sink; /* first: what triangles are given to; hands them on */
    bool flat;             /* in the colour of vertex 0 */
    bool table;            /* which of the two */
    struct etch_ordering ordering;
    struct etch_painter painter;
    uint16_t room, buckets;
    struct etch_ordered *ordered;
    uint16_t *bucket;
    struct etch_painter_triangle *triangle;
    struct etch_scene_sorted *self; /* so that a step may draw, which changes it */
};

static void collect(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    struct etch_scene_sorted *s = (struct etch_scene_sorted *)(void *)sink;
    struct etch_sink *to = s->table ? &s->ordering.sink : &s->painter.sink;
    struct etch_vertex vertex[3] = {*v[0], *v[1], *v[2]};
    const struct etch_vertex *const corner[3] = {&vertex[0], &vertex[1], &vertex[2]};

    for (int i = 1; s->flat && i < 3; i++) { /* a cut gives a piece another vertex 0 */
        vertex[i].r = vertex[0].r, vertex[i].g = vertex[0].g;
        vertex[i].b = vertex[0].b, vertex[i].a = vertex[0].a;
    }
    to->triangle(to, corner);
}

static void draw_begin(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    struct etch_scene_sorted *s = ((const struct etch_scene_sorted *)step->of.data)->self;

    if (s->table) {
        etch_ordering_init(&s->ordering, s->ordered, s->room, s->bucket, s->buckets);
    } else {
        etch_painter_init(&s->painter, s->triangle, s->room);
    }
    s->sink.triangle = collect;
    run->collect = &s->sink;
}

static void draw_end(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    struct etch_scene_sorted *s = ((const struct etch_scene_sorted *)step->of.data)->self;
    struct etch_scene_sink sink;

    run->collect = NULL;
    etch_scene_sink_init(&sink, run, step->pipeline);
    if (s->table) {
        etch_ordering_draw(&s->ordering, &sink.raster.sink);
    } else {
        (void)etch_painter_sort(&s->painter); /* what finds no room is not drawn or not cut */
        etch_painter_draw(&s->painter, &sink.raster.sink);
    }
}

static const struct etch_scene_statement begin_table = {
    "sorted", NULL, draw_begin, "etch_ordering_init etch_ordering_draw", NULL};
static const struct etch_scene_statement begin_newell = {
    "sorted", NULL, draw_begin, "etch_painter_init etch_painter_sort etch_painter_draw", NULL};

/* The memory of a block; false, with an error set, if there is none. */
static bool make_room(struct etch_scene_reader *reader, struct etch_scene_sorted *s)
{
    s->self = s;
    if (s->table) {
        s->ordered = etch_scene_data(reader, s->room * sizeof *s->ordered);
        s->bucket = etch_scene_data(reader, s->buckets * sizeof *s->bucket);
        return s->ordered != NULL && s->bucket != NULL;
    }
    s->triangle = etch_scene_data(reader, s->room * sizeof *s->triangle);
    return s->triangle != NULL;
}

/* table BUCKETS | newell, both with an optional ROOM */
static bool read_sorted(struct etch_scene_reader *reader,
                        const struct etch_scene_statement *statement)
{
    static const char *const kinds[] = {"table", "newell", NULL};
    struct etch_scene_sorted *s = etch_scene_data(reader, sizeof *s);
    struct etch_scene_step *step;
    int64_t buckets = 0, room = 4096;
    int kind;

    (void)statement;
    if (s == NULL || !etch_text_choice(&reader->text, "sorted", kinds, &kind) ||
        (kind == 0 && !etch_text_integer(&reader->text, "buckets", 1, UINT16_MAX, &buckets)) ||
        (etch_text_more(&reader->text) &&
         !etch_text_integer(&reader->text, "room", 1, UINT16_MAX - 1, &room))) {
        return false;
    }
    if (reader->sorted != NULL) {
        return etch_text_fail(&reader->text, "\"sorted\" within \"sorted\"");
    }
    s->table = kind == 0;
    s->buckets = (uint16_t)buckets;
    s->room = (uint16_t)room;
    s->flat = reader->state.shade != 0;
    step = make_room(reader, s) ? etch_scene_append(reader, s->table ? &begin_table : &begin_newell)
                                : NULL;
    if (step == NULL) {
        return false;
    }
    step->of.data = reader->sorted = s;
    return true;
}

static bool read_end(struct etch_scene_reader *reader, const struct etch_scene_statement *statement)
{
    struct etch_scene_step *step = etch_scene_append(reader, statement);

    if (step == NULL) {
        return false;
    }
    if (reader->sorted == NULL) {
        return etch_text_fail(&reader->text, "\"end\" without \"sorted\"");
    }
    step->of.data = reader->sorted;
    step->pipeline = etch_scene_read_pipeline(reader);
    if (step->pipeline != NULL &&
        (step->pipeline->texture != NULL || step->pipeline->staged != NULL)) {
        return etch_text_fail(&reader->text, "\"sorted\" draws colours and depth only");
    }
    reader->sorted = NULL;
    return step->pipeline != NULL;
}

const struct etch_scene_statement etch_scene_sorted_statements[] = {
    {"sorted", read_sorted, NULL, NULL, NULL},
    {"end", read_end, draw_end, NULL, NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
