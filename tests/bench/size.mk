# size.mk: which programs of `make size` (bench.mk) fail when they pass their budget.
SIZE_ENFORCE := lines_small flat_small gouraud_small gouraud_depth_small texture_depth_small
CHECK_STEPS += size
