/* tests/unit: how the end of a transfer reaches the thread that waits (hal/transfer.h), with
 * every order in which completions can come. */
#include "hal/transfer.h"
#include "tests/harness/harness.h"

void suite_bus(void);

/* What the interrupt does while the thread pauses: one step of a script a pause. */
struct script {
    struct etch_transfer *transfer;
    const char *at; /* d done, o done with the old number, e error, - nothing, t time out */
    uint8_t number, old;
    int accepted, pauses;
};

static int pause(void *context)
{
    struct script *s = context;
    const char c = *s->at != 0 ? *s->at++ : 't';

    s->pauses++;
    if (c == 't')
        return -99;
    if (c == 'd' || c == 'o')
        s->accepted += etch_transfer_done(s->transfer, c == 'd' ? s->number : s->old, 0);
    if (c == 'e')
        s->accepted += etch_transfer_done(s->transfer, s->number, -5);
    return 0;
}

static int play(struct etch_transfer *t, const char *script, uint8_t old, int *accepted)
{
    struct script s = {.transfer = t, .at = script, .old = old};
    int status;

    s.number = etch_transfer_start(t);
    CHECK(etch_transfer_runs(t));
    status = etch_transfer_wait(t, pause, &s);
    CHECK(!etch_transfer_runs(t));
    *accepted = s.accepted;
    return status;
}

/* Each transfer ends with its own completion, with its error, or with the time out. */
static void a_transfer_ends_once(void)
{
    struct etch_transfer t = {0};
    int accepted;

    for (int i = 0; i < 600; i++) { /* numbers wrap twice */
        CHECK_EQ(play(&t, "d", 0, &accepted), 0);
        CHECK_EQ(accepted, 1);
        CHECK_EQ(play(&t, "---d", 0, &accepted), 0);
        CHECK_EQ(play(&t, "-e", 0, &accepted), -5);
        CHECK_EQ(play(&t, "--", 0, &accepted), -99);
        CHECK_EQ(accepted, 0);
    }
}

/* A completion that is late or comes twice does not end the transfer that runs by then. */
static void stray_completions_do_nothing(void)
{
    struct etch_transfer t = {0};

    for (int i = 0; i < 600; i++) {
        struct script s = {.transfer = &t, .at = "t"};
        int accepted;

        s.number = etch_transfer_start(&t);
        CHECK_EQ(etch_transfer_wait(&t, pause, &s), -99);
        CHECK(!etch_transfer_done(&t, s.number, 0)); /* late, before the next one */
        CHECK_EQ(play(&t, "o-od", s.number, &accepted), 0);
        CHECK_EQ(accepted, 1);
        CHECK(!etch_transfer_done(&t, t.started, -3)); /* twice */
        CHECK_EQ(play(&t, "d", 0, &accepted), 0);      /* and its error is forgotten */
    }
}

/* Ended before anybody waits: no pause. Without a transfer: no pause and no error. */
static void nothing_is_waited_for_in_vain(void)
{
    struct etch_transfer t = {0};
    struct script s = {.transfer = &t, .at = ""};

    CHECK_EQ(etch_transfer_wait(&t, pause, &s), 0);
    CHECK(etch_transfer_done(&t, etch_transfer_start(&t), -7));
    CHECK_EQ(etch_transfer_wait(&t, pause, &s), -7);
    CHECK_EQ(etch_transfer_wait(&t, pause, &s), 0); /* reported once */
    CHECK_EQ(s.pauses, 0);
}

void suite_bus(void)
{
    RUN(a_transfer_ends_once);
    RUN(stray_completions_do_nothing);
    RUN(nothing_is_waited_for_in_vain);
}
