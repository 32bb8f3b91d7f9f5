# size.mk: which programs of `make size` (bench.mk) fail when they pass their budget.
SIZE_ENFORCE := lines_small flat_small gouraud_small gouraud_depth_small texture_depth_small
SIZE_ENFORCE += text ellipse round_rect arcs borders gradient pattern opacity smooth_round smooth_line
SIZE_ENFORCE += blit sprites packed bilinear
CHECK_STEPS += size
