/* tests/unit: how the pieces of a transfer and its end go between the thread that waits and
 * interrupts (hal/transfer.h), with every order in which completions can come. */
#include "hal/transfer.h"
#include "tests/harness/harness.h"

void suite_bus(void);

/* Pieces of 1, 2, 3 .. bytes out of `bytes`; two of them may be alive. */
struct source {
    struct etch_pieces pieces; /* first */
    int made, count;
};

static uint8_t bytes[600];

static const uint8_t *next(struct etch_pieces *pieces, uint32_t *n)
{
    struct source *s = (struct source *)pieces;

    *n = (uint32_t)s->made + 1;
    return s->made < s->count ? &bytes[s->made++] : NULL;
}

/* What the interrupt does while the thread pauses: one step of a script a pause. */
struct script {
    struct etch_transfer *transfer;
    const char *at; /* d done, o done with the old number, e error, - nothing, t time out */
    uint8_t number, old;
    int accepted, pauses;
    int started, fails; /* pieces; number of the one whose start fails, from 1 */
};

static int start(void *context, uint8_t number, const uint8_t *piece, uint32_t n)
{
    struct script *s = context;

    CHECK(n == (uint32_t)s->started + 1 && piece == &bytes[s->started]);
    CHECK(etch_transfer_runs(s->transfer));
    s->number = number;
    return ++s->started == s->fails ? -44 : 0;
}

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

/* Sends `count` pieces while `script` happens; *played tells the rest. */
static int play(struct etch_transfer *t, const char *script, int count, struct script *played)
{
    const uint8_t old = played->number;
    const int fails = played->fails;
    struct source source = {{next}, 0, count};
    int status;

    *played = (struct script){.transfer = t, .at = script, .old = old, .fails = fails};
    t->start = start;
    t->context = played;
    status = etch_transfer_start(t, &source.pieces);
    if (status < 0)
        CHECK(!etch_transfer_runs(t));
    if (status == 0)
        status = etch_transfer_wait(t, pause, played);
    CHECK(!etch_transfer_runs(t));
    CHECK(source.made <= played->started + 1 + (played->started == 0));
    return status;
}

/* Each transfer ends with its last piece's completion, with an error, or with the time out. */
static void a_transfer_ends_once(void)
{
    struct etch_transfer t = {0};
    struct script s = {0};

    for (int i = 0; i < 600; i++) { /* numbers wrap more than twice */
        CHECK_EQ(play(&t, "d", 1, &s), 0);
        CHECK(s.accepted == 1 && s.pauses == 1);
        CHECK_EQ(play(&t, "---d", 1, &s), 0);
        CHECK_EQ(play(&t, "-e", 1, &s), -5);
        CHECK_EQ(play(&t, "--", 1, &s), -99);
        CHECK_EQ(s.accepted, 0);
        CHECK_EQ(play(&t, "d-d--d", 3, &s), 0);
        CHECK(s.started == 3 && s.pauses == 6);
        CHECK_EQ(play(&t, "dd-ed", 9, &s), -5); /* no piece after the error */
        CHECK_EQ(s.started, 3);
        CHECK_EQ(play(&t, "dd", 9, &s), -99);
        CHECK_EQ(s.started, 3);
    }
}

/* More pieces than there are numbers. */
static void a_transfer_may_be_long(void)
{
    static char script[sizeof bytes + 1];
    struct etch_transfer t = {0};
    struct script s = {0};

    for (size_t i = 0; i < sizeof bytes; i++)
        script[i] = 'd';
    CHECK_EQ(play(&t, script, sizeof bytes, &s), 0);
    CHECK(s.started == (int)sizeof bytes && s.accepted == (int)sizeof bytes);
}

/* A completion that is late or comes twice does not end the piece that runs by then, be it of the
 * same transfer or the next one. */
static void stray_completions_do_nothing(void)
{
    struct etch_transfer t = {0};
    struct script s = {0};

    for (int i = 0; i < 600; i++) {
        const int pieces = 1 + i % 3;

        CHECK_EQ(play(&t, "t", pieces, &s), -99);
        CHECK(!etch_transfer_done(&t, s.number, 0)); /* late, before the next one */
        CHECK_EQ(play(&t, "o-od", 1, &s), 0);
        CHECK_EQ(s.accepted, 1);
        CHECK(!etch_transfer_done(&t, s.number, -3)); /* twice */
        CHECK_EQ(play(&t, "dodod", 3, &s), 0);        /* and its error is forgotten */
        CHECK_EQ(s.accepted, 3);
        CHECK_EQ(s.started, 3);
    }
}

/* A piece that cannot be started ends the transfer, in the thread or in the interrupt. */
static void a_start_may_fail(void)
{
    struct etch_transfer t = {0};

    for (int fails = 1; fails <= 4; fails++) {
        struct script s = {.fails = fails};

        CHECK_EQ(play(&t, "ddddddd", 4, &s), -44);
        CHECK_EQ(s.started, fails);
        s.fails = 0;
        CHECK_EQ(play(&t, "dddd", 4, &s), 0);
    }
}

/* Ended before anybody waits: no pause. Without a transfer: no pause and no error. */
static void nothing_is_waited_for_in_vain(void)
{
    struct etch_transfer t = {0};
    struct script s = {.transfer = &t, .at = ""};
    struct source source = {{next}, 0, 1};

    t.start = start;
    t.context = &s;
    CHECK_EQ(etch_transfer_wait(&t, pause, &s), 0);
    CHECK_EQ(etch_transfer_start(&t, &source.pieces), 0);
    CHECK(etch_transfer_done(&t, s.number, -7));
    CHECK_EQ(etch_transfer_wait(&t, pause, &s), -7);
    CHECK_EQ(etch_transfer_wait(&t, pause, &s), 0); /* reported once */
    CHECK_EQ(s.pauses, 0);
}

void suite_bus(void)
{
    RUN(a_transfer_ends_once);
    RUN(a_transfer_may_be_long);
    RUN(stray_completions_do_nothing);
    RUN(a_start_may_fail);
    RUN(nothing_is_waited_for_in_vain);
}
