/* hal/workers.h: a frame drawn by several workers: threads, tasks, or cores without a system.
 *
 * The frame loop (frame.h), whose strips go to whoever is free; each worker has a surface of its
 * own.
 *
 *      every worker                                        the one that owns the frames
 *
 *      draw(w):                                            etch_workers_begin(&workers)
 *          while (etch_worker_part(w, 8, &part))           etch_worker_begin(&own)
 *              vertices of this eighth of the mesh         draw(&own)
 *          while ((s = etch_worker_next(w)) != NULL)       status = etch_workers_end(&workers)
 *              draw_scene(s)
 *
 *      the others: while (etch_worker_begin(&w)) draw(&w);    until etch_workers_close(&workers)
 *
 * The pixels are those of one worker, in whatever order strips are done. What all strips need, such
 * as the vertices of a mesh, is not done by each: it is cut into parts, and no strip is handed out
 * before the last part is done.
 *
 * A worker that is done with a strip sends it, as soon as the display is free, and goes on: with
 * two buffers it draws while the transfer runs. Strips reach the display in the order in which they
 * are done; from the top if it wants that (in_order, or sync). It gets its calls from several
 * threads then, one call at a time, and what one has flushed another may wait for: a bus is locked
 * by something that another thread may unlock (etch_turn of guarded.h; not a mutex).
 *
 * Nobody waits by spinning: all waiting is the monitor's. It is entered once a strip or part, once
 * more to send.
 */
#ifndef ETCH_HAL_WORKERS_H
#define ETCH_HAL_WORKERS_H

#include "frame.h"
#include "monitor.h"

/* What workers share. Set up by etch_workers_init, then private. */
struct etch_workers {
    const struct etch_display *display;
    const struct etch_monitor *monitor;
    int16_t rows; /* most in a strip */

    struct etch_strips strips; /* to come */
    struct etch_rect whole;    /* the only area of a whole frame */
    uint16_t *direct;          /* memory of a direct display during a frame, */
    uint16_t stride;           /* whose rows are so far apart */
    uint16_t frame;            /* its number, modulo 2^16 */
    uint16_t strip;            /* number of the next strip, modulo 2^16, */
    uint16_t turn;             /* of the next to be sent where the order counts, */
    uint16_t in_hand;          /* and how many are being drawn or sent */
    uint16_t phase, part;      /* phase of shared work, its next part, */
    uint16_t parts_done;       /* and how many are done */
    bool open;                 /* begun, and not ended */
    bool closed;               /* no frame comes any more */
    bool exhausted;            /* no strip is left */
    bool busy;                 /* somebody calls the display */
    bool sending;              /* flush was called and wait not since; of whom `busy` is true */
    bool synced;               /* the display was asked when to begin */
    int status;                /* first error of this frame */
};

/* A worker. Set up by etch_worker_init, then private; used by one thread. */
struct etch_worker {
    struct etch_workers *workers;
    struct etch_frame_memory memory;
    struct etch_surface surface; /* the strip in hand; its window is empty if there is none */
    uint16_t frame;              /* that it takes part in, */
    uint16_t strip;              /* number of its strip */
    uint16_t phase;              /* of shared work that it is in */
    bool has_part;               /* that is not done yet */
    uint8_t index;               /* buffer of the strip in hand */
};

/* Prepares what workers share; both must stay valid. A strip has at most `rows` rows: three or more
 * strips a worker even out what is more to draw in one than in another. Calls nothing.
 * ETCH_EINVAL: a width or height outside 1 .. 32767, or rows less than 1 or than one unit of the
 * display's align_y. */
int etch_workers_init(struct etch_workers *workers, const struct etch_display *display,
                      const struct etch_monitor *monitor, int16_t rows);

/* Prepares a worker with memory of its own (frame.h; a direct display ignores `pixels`). Sizes may
 * differ. Calls nothing. ETCH_EINVAL: a flushed display without pixels[0], or both buffers the
 * same; ETCH_ENOMEM: not one row fits. */
int etch_worker_init(struct etch_worker *worker, struct etch_workers *workers,
                     struct etch_frame_memory memory);

/* Begins a frame, or parts of it (as etch_frame_begin_areas), and wakes the workers. The frame
 * before has ended. The scene may be changed from etch_workers_end until here. If the display
 * has no memory to give there are no strips, and etch_workers_end says why. */
void etch_workers_begin(struct etch_workers *workers);
void etch_workers_begin_areas(struct etch_workers *workers, const struct etch_rect *areas,
                              uint16_t count);

/* Returns when all strips are drawn and sent; by whom is the same. 0 or the first error of this
 * frame, told here and nowhere else; after it nothing more was sent. All memory is the caller's
 * again. */
int etch_workers_end(struct etch_workers *workers);

/* No more frames: every etch_worker_begin returns false. Between frames. */
void etch_workers_close(struct etch_workers *workers);

/* Joins the frame that is open if this worker has not yet had it, else waits for the next. A
 * worker that comes late gets what is left, perhaps nothing. False after etch_workers_close. */
bool etch_worker_begin(struct etch_worker *worker);

/* Shared work before the strips: true with *part in 0 .. count - 1, each to one worker; false when
 * all parts are done, by whomever: what was written for them can be read. Workers go through the
 * same phases, with the same counts (1 .. 65535), and through all of them. */
bool etch_worker_part(struct etch_worker *worker, uint16_t count, uint16_t *part);

/* Sends the strip in hand and returns the next one; NULL if there is none, and after an error. The
 * surface is the worker's until the next call. Once begun, go on until NULL. */
struct etch_surface *etch_worker_next(struct etch_worker *worker);

#endif
