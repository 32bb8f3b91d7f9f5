/* tests/threads: tasks that draw, and the interrupts of their transfers. */
#include "tests/harness/harness.h"
#include "threads.h"

static struct station station[2];
static struct wire wire[2];

/* A task: frame after frame on its station, each of another scene. */
struct task {
    struct station *station;
    int first; /* scene */
};

static const char *scene_of(int i)
{
    return scene_paths[i % scene_count];
}

static void *draw_frames(void *context)
{
    const struct task *t = context;

    for (int i = 0; i < scene_count && (i == 0 || t->station->status == 0); i++)
        station_draw(t->station, scene_of(t->first + i));
    return NULL;
}

/* One task, whose strips go out while it draws the next. */
static void one_task_and_an_interrupt(void)
{
    CHECK(wire_open(&wire[0], 20000));
    station_open(&station[0], &wire[0]);
    for (int i = 0; i < scene_count; i++) {
        station_draw(&station[0], scene_of(i));
        station_check(&station[0], scene_of(i));
    }
    station_close(&station[0]);
    wire_close(&wire[0]);
}

/* Two tasks draw all scenes, the second one scene ahead, on panels of `wires` wires. */
static void draw_two(int wires)
{
    const struct task task[2] = {{&station[0], 0}, {&station[1], 1}};
    pthread_t thread[2];

    for (int i = 0; i < wires; i++)
        CHECK(wire_open(&wire[i], 20000));
    for (int i = 0; i < 2; i++)
        station_open(&station[i], &wire[wires == 2 ? i : 0]);
    for (int i = 0; i < 2; i++)
        CHECK_EQ(pthread_create(&thread[i], NULL, draw_frames, (void *)&task[i]), 0);
    for (int i = 0; i < 2; i++)
        CHECK_EQ(pthread_join(thread[i], NULL), 0);
    for (int i = 0; i < 2; i++) {
        station_check(&station[i], scene_of(task[i].first + scene_count - 1));
        station_close(&station[i]);
    }
    for (int i = 0; i < wires; i++)
        wire_close(&wire[i]);
}

static void two_tasks_on_two_surfaces(void)
{
    draw_two(2);
}

static void two_panels_on_one_wire(void)
{
    draw_two(1);
}

/* A transfer that never ends is given up and told once; the next frame is whole. */
static void a_stalled_transfer(void)
{
    CHECK(wire_open(&wire[0], 600));
    station_open(&station[0], &wire[0]);
    for (int at = 1; at <= 40; at += 13) {
        wire[0].stalls = at; /* no thread touches it: nothing is sent */
        station_draw(&station[0], scene_of(0));
        CHECK_EQ(station[0].status, ETCH_EIO);
        station_draw(&station[0], scene_of(at));
        station_check(&station[0], scene_of(at));
    }
    station_close(&station[0]);
    wire_close(&wire[0]);
}

void suite_tasks(void)
{
    RUN(one_task_and_an_interrupt);
    RUN(two_tasks_on_two_surfaces);
    RUN(two_panels_on_one_wire);
    RUN(a_stalled_transfer);
}
