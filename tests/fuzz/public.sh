#!/bin/sh
# public.sh OBJECTS: every public drawing function is referred to by the objects of the tables of calls.
# Public: declared in a header that core/etch.h includes, or in one called *_small.h that no other header
# declares private. Drawing: it has a surface among its arguments, or is declared by one of the types below.
set -u
export LC_ALL=C
types='etch_triangle_painter etch_line_painter etch_point_runs etch_multisample_painter
    etch_shared_painter etch_glyph_painter etch_image_row etch_kernel etch_cover_kernel
    etch_element_kind etch_stage_function etch_texel_colors etch_texel_alphas etch_texel_wrap
    etch_texel_filter etch_stencil_operation etch_line_varying etch_varying'

# Not called, and why.
except() {
    case $1 in
    # in place of a surface: they set one up, or a clip, or a sink that is then called by a row
    etch_surface_init | etch_surface_clip | etch_clip_push | etch_clip_pop | etch_*_sink_init) true ;;
    # addresses, and the templates of kernels
    etch_surface_index | etch_surface_row | etch_blend_runs | etch_shade_runs) true ;;
    # parts of a pass that rows run whole
    etch_carry_begin | etch_carry_row | etch_carry_end | etch_smooth_window) true ;;
    # a kernel that etch_triangle_barycentric sets; one that line_stipple does; brushes' source of stages
    etch_kernel_barycentric | etch_kernel_line_stipple | etch_source_brush) true ;;
    # in the lists etch_perspective.. of base/texture.h, which rows give
    etch_kernel_perspective*) true ;;
    # these need Phong planes behind the pipeline: driven by scenes (scene.c)
    etch_source_shade* | etch_stage_phong* | etch_varying_shade) true ;;
    *) false ;;
    esac
}

headers=$(sed -n 's|^#include "\(.*\)"|core/\1|p' core/etch.h; ls core/draw/*_small.h \
    core/fragment/*_small.h core/raster/*_small.h)
declared=$(for h in $headers; do
    # comments and line ends away, a declaration a line
    sed -e 's|/\*[^*]*\*/||g' "$h" | awk '/\/\*/ { c = 1 } !c { print } /\*\// { c = 0 }' |
        grep -av '^#' | tr '\n' ' ' | tr ';{}' '\n\n\n'
done)
functions=$(
    echo "$declared" | grep -av typedef | grep -a 'struct etch_surface \*' |
        sed -n 's/.*[ *]\(etch_[a-z0-9_]*\)(.*/\1/p'
    for t in $types; do
        echo "$declared" | sed -n "s/^ *$t \(etch_.*\)/\1/p" | tr ',' '\n' | grep -ao 'etch_[a-z0-9_]*'
    done
)
called=$(nm -u "$@" | sed -n 's/^ *U //p' | sort -u)
passed=0 failed=0
for f in $(echo "$functions" | sort -u); do
    if except "$f" || echo "$called" | grep -qx "$f"; then
        passed=$((passed + 1))
    else
        echo "FAIL tests/fuzz: no row calls $f"
        failed=$((failed + 1))
    fi
done
[ "$passed" -ge 250 ] || { echo "FAIL tests/fuzz: only $passed functions found"; failed=$((failed + 1)); }
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
