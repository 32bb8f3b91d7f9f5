/* ports/host/report.c: prints --stats; report_needs.c prints --needs. etch-sim calls it. */
#include "report.h"

#include <inttypes.h>
#include <stdio.h>

/* What was sent, and how long that takes. */
static void report_bus(const struct etch_simulation *s)
{
    const struct etch_screen *screen = &s->screen;
    const struct etch_panel_port *port = screen->panel;

    (void)printf("flushed    %" PRIu64 " bytes in %" PRIu64 " %s\n", screen->bytes, screen->flushes,
                 port != NULL ? "transactions" : "transfers");
    if (port == NULL) {
        (void)printf("bus        none: this port has no bus to time\n");
        return;
    }
    const uint64_t other = port->panel.commands + port->panel.parameters;
    const uint64_t us = (port->panel.now_ns - screen->opened_ns) / 1000;

    (void)printf("commands   %" PRIu64 " bytes beside %" PRIu64 " of pixels\n", other,
                 screen->bytes - other);
    (void)printf("bus        %" PRIu64 ".%03" PRIu64 " ms at %" PRIu32 " Hz, %d bit%s wide\n",
                 us / 1000, us % 1000, s->panel.clock, s->panel.lanes,
                 s->panel.lanes == 1 ? "" : "s");
}

void etch_report_stats(const struct etch_simulation *s)
{
    const struct etch_screen *screen = &s->screen;

    (void)printf("size       %d x %d\n", s->scene->width, s->scene->height);
    (void)printf("port       %s, ", s->port);
    if (screen->panel != NULL) {
        (void)printf("turn %d, ", screen->panel->turn & 3);
    }
    (void)printf("%s\n", screen->buffers == 0   ? "drawn into directly"
                         : screen->buffers == 1 ? "strips from one buffer"
                                                : "strips from two buffers");
    (void)printf("triangles  %" PRIu64 "\n", s->stats.triangles);
    (void)printf("runs       %" PRIu64 "\n", s->stats.runs);
    (void)printf("pixels     %" PRIu64 "\n", s->stats.pixels);
    report_bus(s);
    (void)printf("ram        %" PRIu64 " bytes: colour %" PRIu64 ", depth %" PRIu64,
                 s->color_bytes + s->depth_bytes + s->stencil_bytes + s->scene->vertex_bytes,
                 s->color_bytes, s->depth_bytes);
    if (s->stencil_bytes != 0) {
        (void)printf(", stencil %" PRIu64, s->stencil_bytes);
    }
    (void)printf(", vertices %zu\n", s->scene->vertex_bytes);
}
