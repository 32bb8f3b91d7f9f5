/* etch: an integer-only graphics pipeline for small screens. This header includes all of core;
 * a program may include the parts it uses instead, and links only what it names.
 *
 *      app --> vertex: transform, light, clip, cull --> sink --.
 *                                                              v
 *      app --> draw: triangles, shapes --> raster: edges, runs {x0,x1} --> paint->kernel
 *                                                                             |
 *                                           fragment: depth test, colour <----'
 *                                                  |
 *                                                  v
 *                                       base: surface = window on the frame, clip, planes
 *
 * CONVENTIONS
 *
 *   Frame      x right, y down, (0,0) top left. Pixel (i,j) is the square [i,i+1) x [j,j+1), its
 *              centre (i+1/2, j+1/2). Coordinates are always the frame's, also on a strip.
 *   2D calls   int16_t coordinates name pixels; every value is legal and every call is safe.
 *              Rectangles as arguments are (x, y, w, h), as structs half-open. A triangle's
 *              integer vertices are pixel centres.
 *   Subpixel   16.16 (etch_q16) or 1/256 px (names in _q8). 16.16 is snapped to 1/256 by
 *              round-half-up. 0 is a pixel's left or top edge, 128/256 its centre.
 *   Coverage   a pixel is drawn iff its centre is inside, or on a top or left edge, of the
 *              snapped triangle. Neighbours never overlap and leave no gap.
 *   Depth      0 near .. 65535 far, 16 bits; vertices carry 16 more.
 *   Colour     RGB565. Calls take colours in the surface's byte order: etch_rgb565, and
 *              etch_rgb565_swap where the panel wants the high byte first.
 *   3D         right-handed; the eye looks along -z, y up; visible is -w <= x,y,z <= w. Front
 *              faces are counter-clockwise as seen.
 *   Angles     uint16_t, 65536 to a turn.
 *   Memory     all of it is the caller's. No heap, no globals: surfaces are independent, and
 *              threads that use different ones need no lock.
 *   Errors     drawing returns void: what is off screen, empty or degenerate draws what it
 *              covers. Set-up returns 0 or a negative enum etch_status. A caller's bug trips
 *              ETCH_ASSERT, which is empty unless the build defines it.
 *
 * Where to go on: base/surface.h (the memory), draw/shapes.h, draw/round.h, draw/polygon.h and
 * raster/line.h (2D), draw/triangle.h and draw/texture.h (shaded and textured triangles, the fast
 * kernels), draw/staged.h and fragment/sampler.h (any state: stencil, fog, blending, any texture),
 * draw/mesh.h, vertex/lamp.h and vertex/elements.h (3D), draw/retained.h (geometry kept over the
 * strips of a frame), frame/multisample.h (anti-aliasing), base/paint.h, fragment/template.h and
 * fragment/stage.h (your own pixel work). README.md beside this file lists every function.
 * Functions called .._small do the same in less flash and more time; their headers, named
 * likewise, are included by name. The loops in leaf/ replace portable files of the same functions
 * on one architecture, with the same pixels. DESIGN.md says why things are as they are.
 */
#ifndef ETCH_H
#define ETCH_H

#include "base/clip_stack.h"
#include "base/cover.h"
#include "base/exact.h"
#include "base/fixed.h"
#include "base/font.h"
#include "base/map.h"
#include "base/paint.h"
#include "base/rect.h"
#include "base/rgb565.h"
#include "base/sink.h"
#include "base/shade.h"
#include "base/surface.h"
#include "base/texture.h"
#include "base/trig.h"
#include "base/unit.h"
#include "base/utf8.h"
#include "base/weights.h"
#include "draw/image.h"
#include "draw/image_rle.h"
#include "draw/line.h"
#include "draw/line_stipple.h"
#include "draw/line_staged.h"
#include "draw/blend.h"
#include "draw/dither.h"
#include "draw/exact.h"
#include "draw/inverse.h"
#include "draw/feedback.h"
#include "draw/mesh.h"
#include "draw/mesh_elements.h"
#include "draw/mesh_phong.h"
#include "draw/mesh_shaded.h"
#include "draw/mesh_sinks.h"
#include "draw/mesh_varying.h"
#include "draw/point.h"
#include "draw/ordering.h"
#include "draw/painter.h"
#include "draw/polygon.h"
#include "draw/retained.h"
#include "draw/round.h"
#include "draw/select.h"
#include "draw/shapes.h"
#include "draw/staged.h"
#include "draw/text.h"
#include "draw/texture.h"
#include "draw/triangle.h"
#include "fragment/barycentric.h"
#include "fragment/blend.h"
#include "fragment/blend_fused.h"
#include "fragment/blend_template.h"
#include "fragment/brush.h"
#include "fragment/cover.h"
#include "fragment/dither.h"
#include "fragment/exact.h"
#include "fragment/flat.h"
#include "fragment/fog.h"
#include "fragment/gouraud.h"
#include "fragment/inverse.h"
#include "fragment/gradient.h"
#include "fragment/logic.h"
#include "fragment/mipmap.h"
#include "fragment/pattern.h"
#include "fragment/phong.h"
#include "fragment/sampler.h"
#include "fragment/source.h"
#include "fragment/source_blocks.h"
#include "fragment/source_map.h"
#include "fragment/stage.h"
#include "fragment/stencil.h"
#include "fragment/template.h"
#include "fragment/test.h"
#include "fragment/texture.h"
#include "fragment/weights.h"
#include "fragment/write.h"
#include "frame/accumulation.h"
#include "frame/exchange.h"
#include "frame/filter.h"
#include "frame/jitter.h"
#include "frame/move.h"
#include "frame/multisample.h"
#include "frame/shared.h"
#include "frame/smooth.h"
#include "frame/supersample.h"
#include "raster/arc.h"
#include "raster/basis.h"
#include "raster/circle.h"
#include "raster/clip_polygon.h"
#include "raster/curve.h"
#include "raster/edge_flags.h"
#include "raster/ellipse.h"
#include "raster/evaluate.h"
#include "raster/halfspace.h"
#include "raster/implicit.h"
#include "raster/line.h"
#include "raster/line_clip.h"
#include "raster/line_dda.h"
#include "raster/line_runs.h"
#include "raster/map_runs.h"
#include "raster/outline.h"
#include "raster/plane.h"
#include "raster/plane_exact.h"
#include "raster/point_runs.h"
#include "raster/polygon.h"
#include "raster/quadric.h"
#include "raster/rect.h"
#include "raster/round_rect.h"
#include "raster/smooth.h"
#include "raster/smooth_shapes.h"
#include "raster/stroke.h"
#include "raster/triangle.h"
#include "raster/triangulate.h"
#include "raster/weights.h"
#include "vertex/assembly.h"
#include "vertex/assembly_line.h"
#include "vertex/clip.h"
#include "vertex/clip_line.h"
#include "vertex/clip_volume.h"
#include "vertex/cull.h"
#include "vertex/elements.h"
#include "vertex/lamp.h"
#include "vertex/light.h"
#include "vertex/matrix.h"
#include "vertex/mesh.h"
#include "vertex/normal.h"
#include "vertex/transform.h"
#include "vertex/varying.h"
#include "vertex/viewport.h"

#endif
