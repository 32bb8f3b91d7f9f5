/* tests/unit: hal/guarded.h with a monitor in one thread, whose wait lets an interrupt come, or
 * time pass. Real threads are in tests/threads. */
#include "hal/guarded.h"
#include "tests/harness/harness.h"

void suite_guarded(void);

enum {
    LIMIT = 70, /* ms */
    MOST = 9    /* pieces */
};

static struct etch_guarded guarded;
static struct etch_turn turn;
static int inside, signals, waits;
static uint16_t limit;
static void (*while_waiting)(void); /* NULL: nothing happens, the limit passes */

static void enter(const struct etch_monitor *m)
{
    (void)m;
    CHECK_EQ(inside++, 0);
}

static void leave(const struct etch_monitor *m)
{
    (void)m;
    CHECK_EQ(--inside, 0);
}

static int wait(const struct etch_monitor *m, uint16_t limit_ms)
{
    const int before = signals;

    waits++;
    limit = limit_ms;
    leave(m);
    if (while_waiting != NULL)
        while_waiting();
    enter(m);
    return signals != before ? 0 : ETCH_EIO;
}

static void signal(const struct etch_monitor *m)
{
    (void)m;
    CHECK_EQ(inside, 1);
    signals++;
}

static const struct etch_monitor monitor = {
    .enter = enter, .leave = leave, .wait = wait, .signal = signal};

/* ---- a transfer ------------------------------------------------------------------------------ */

static struct {
    struct etch_pieces pieces; /* first */
    uint32_t made;
} source;
static uint8_t bytes[MOST];
static uint32_t pieces_there, started;
static uint8_t number, fails_at; /* fails_at: the piece that does not start, from 1 */

static const uint8_t *next(struct etch_pieces *pieces, uint32_t *n)
{
    (void)pieces;
    CHECK_EQ(inside, 1);
    *n = 1;
    return source.made < pieces_there ? &bytes[source.made++] : NULL;
}

static int start(void *context, uint8_t piece, const uint8_t *at, uint32_t n)
{
    (void)context;
    CHECK_EQ(inside, 1);
    CHECK(at == &bytes[started] && n == 1);
    number = piece;
    return ++started == fails_at ? -55 : 0;
}

static void open_transfer(uint32_t pieces)
{
    guarded = (struct etch_guarded){
        .transfer = {.start = start}, .monitor = &monitor, .limit_ms = LIMIT};
    source.pieces.next = next;
    source.made = started = fails_at = 0;
    pieces_there = pieces;
    signals = waits = 0;
}

/* The interrupt of the piece that runs, and again, late. */
static void complete(void)
{
    const uint8_t was = number;

    CHECK(etch_guarded_done(&guarded, was, 0));
    if (etch_transfer_runs(&guarded.transfer))
        CHECK(!etch_guarded_done(&guarded, was, 0));
}

static void pieces_one_after_the_other(void)
{
    for (uint32_t n = 1; n <= MOST; n++) {
        open_transfer(n);
        CHECK_EQ(etch_guarded_start(&guarded, &source.pieces), 0);
        while_waiting = complete;
        CHECK_EQ(etch_guarded_wait(&guarded), 0);
        CHECK_EQ(started, n);
        CHECK_EQ(waits, n); /* each piece has the limit for itself */
        CHECK_EQ(limit, LIMIT);
        CHECK_EQ(etch_guarded_wait(&guarded), 0); /* none runs */
        CHECK_EQ(waits, n);
        CHECK(!etch_guarded_done(&guarded, number, 0));
    }
}

static void fail(void)
{
    CHECK(etch_guarded_done(&guarded, number, -66));
}

static void errors_of_a_transfer(void)
{
    open_transfer(3);
    fails_at = 1;
    CHECK_EQ(etch_guarded_start(&guarded, &source.pieces), -55);
    CHECK_EQ(etch_guarded_wait(&guarded), 0);
    open_transfer(3);
    fails_at = 2;
    while_waiting = complete;
    CHECK_EQ(etch_guarded_start(&guarded, &source.pieces), 0);
    CHECK_EQ(etch_guarded_wait(&guarded), -55);
    CHECK_EQ(etch_guarded_wait(&guarded), 0); /* told once */
    open_transfer(3);
    while_waiting = fail;
    CHECK_EQ(etch_guarded_start(&guarded, &source.pieces), 0);
    CHECK_EQ(etch_guarded_wait(&guarded), -66);
    CHECK_EQ(started, 1);
    open_transfer(3);
    while_waiting = NULL;
    CHECK_EQ(etch_guarded_start(&guarded, &source.pieces), 0);
    CHECK_EQ(etch_guarded_wait(&guarded), ETCH_EIO); /* nothing came */
    CHECK(!etch_guarded_done(&guarded, number, 0));  /* now it does, too late */
    CHECK_EQ(started, 1);
}

/* ---- a turn ---------------------------------------------------------------------------------- */

static void give(void)
{
    etch_turn_give(&turn);
}

static void something_else(void)
{
    enter(&monitor);
    signal(&monitor);
    leave(&monitor);
    while_waiting = give;
}

static void one_has_the_turn(void)
{
    turn = (struct etch_turn){.monitor = &monitor};
    waits = 0;
    while_waiting = NULL;
    CHECK_EQ(etch_turn_take(&turn, 5), 0);
    CHECK_EQ(waits, 0);
    CHECK_EQ(etch_turn_take(&turn, 5), ETCH_EIO); /* nobody gives it */
    CHECK_EQ(limit, 5);
    while_waiting = something_else; /* a signal that is not meant, then the turn */
    waits = 0;
    CHECK_EQ(etch_turn_take(&turn, 0), 0);
    CHECK_EQ(waits, 2);
    CHECK(turn.taken);
    etch_turn_give(&turn);
    CHECK(!turn.taken);
}

void suite_guarded(void)
{
    RUN(pieces_one_after_the_other);
    RUN(errors_of_a_transfer);
    RUN(one_has_the_turn);
}
