"""The tables of the documentation: for every mode what it costs, how it errs and when to choose it."""

# mode -> when to choose it. A mode without a line here is an error.
WHEN = {
    "flat": "one colour a triangle",
    "precise": "the default: no visible or countable difference to exact",
    "exact": "pictures that must be right to the bit by their definition, references, tests",
    "exact carried": "never: exact is cheaper and no less exact. Not shipped",
    "precise small": "flash counts more than time",
    "fast": "never: 5 % less on a mesh, no less elsewhere, more flash, and errs. Not shipped",
    "packed": "never: precise is cheaper and more exact. Not shipped",
    "barycentric": "a function of one's own for every pixel, not for colours alone",
    "precise dithered": "slow ramps, where steps of RGB565 show; see the next table",
    "precise by block": "the eye sees steps where a ramp is slow",
    "dithered by block": "slow ramps: the mean over 8 x 8 px is what was meant",
    "flat dithered by block": "a colour between two of RGB565",
    "flat by block": "colours that RGB565 has",
    "linear precise": "the default",
    "linear exact": "depths that must be right to the bit",
    "inverse": "near : far beyond 1 : 500",
    "depth buffer": "the default",
    "buffer exact": "planes less than 1/64 unit of depth apart",
    "buffer inverse": "near : far beyond 1 : 500",
    "ordering table": "no room for depth, small triangles that are apart",
    "painter": "no room for depth, and order must be right: few triangles, or few that pierce",
    "affine": "textures that are seen from the front, or triangles of a few pixels",
    "divide every 16": "the default",
    "divide every 8": "as 16 where coordinates curve by more than 1/32 texel a pixel squared",
    "divide every pixel": "coordinates that curve strongly: close to the eye, seen along the surface",
    "whole pixel": "pictures that do not move: no cheaper than 1/256 px",
    "1/256 px": "the default",
    "edges plain": "the default",
    "edges smooth": "lines, circles and shapes over a picture; meshes show seams",
    "multisample 4x": "meshes of large triangles",
    "shared samples": "as multisampling, with 6/10 of the memory",
    "supersample 2x2": "meshes of any kind with plain painters",
    "supersample 3x3": "better edges for more memory",
    "supersample 4x4": "the best edges of a mesh",
}
GROUPS = (
    ("Colour, steps of a channel", "step", lambda r: "block" not in r["mode"]),
    ("Colour, steps of the mean of 8 x 8 px", "step", lambda r: "block" in r["mode"]),
    ("Depth, units or codes of 16 bits", "unit code", lambda r: True),
    ("Hidden surfaces, share of wrong pixels", "wrong", lambda r: True),
    ("Perspective, texels from the centre of the one drawn", "texel", lambda r: True),
    ("Vertices, pixels moved", "px", lambda r: True),
    ("Edges, share of a pixel, of pixels on an edge", "pixel", lambda r: True),
)


def line(rows):
    """Of one mode: errors over all scenes, cost on the near scene and a mesh triangle."""
    by_scene = {r["scene"]: r for r in rows}
    near = by_scene["near"]
    small = by_scene.get("mesh") or by_scene.get("slivers") or by_scene.get("floor")

    def per_triangle(core):
        return f"{small[core + '_all'] / int(small['triangles']):,.0f}" if small else ""
    worst = max(rows, key=lambda r: float(r["max"]))
    return (near["mode"], f"`{near['kernel']}`" if "etch_" in near["kernel"] else near["kernel"],
            f"{float(near['mean']):.3g}", f"{float(near['p999']):.3g}",
            f"{float(worst['max']):.6g}", f"{float(near['m0plus']):.1f}", f"{float(near['m4']):.1f}",
            per_triangle("m0plus"), per_triangle("m4"), f"{near['flash']:,}",
            f"{int(near['bytes']) * 5120:,}" + (f" + {near['triangle']} a triangle"
                                                if near["triangle"] != "0" else ""),
            WHEN[near["mode"]])


def separations(apart):
    out = ["### Smallest separation that a depth tells apart", "",
           "Walls that face the eye, at a distance in times of near, as a share of that distance; linear",
           "and inverse, for three ratios of near to far. A dash: not even twice as far.", "",
           "| distance | 1 : 100 linear | inverse | 1 : 1000 linear | inverse | 1 : 65535 linear | inverse |",
           "|--:|--:|--:|--:|--:|--:|--:|"]
    table = {}
    for ratio, distance, linear, inverse in apart:
        table.setdefault(float(distance), {})[ratio] = (float(linear), float(inverse))

    def share(v):
        return "-" if v == 0 else f"1/{1 / v:,.0f}" if v < 0.2 else f"{v:.2f}"
    for distance, by_ratio in sorted(table.items()):
        cells = []
        for ratio in ("100", "1000", "65535"):
            cells += [share(v) for v in by_ratio[ratio]] if ratio in by_ratio else ["", ""]
        out.append(f"| {distance:,.0f} | " + " | ".join(cells) + " |")
    return out


# What each mode promises beyond the 1/2 of rounding, where it says so, and what proves it tight.
BOUNDS = """### What is promised, and how tight that is

| mode | stated in | error beyond 1/2 at most | an input that comes near it |
|---|---|---|---|
| exact | [exact.h](../../core/fragment/exact.h) | 0 | every tie: [exact.c](../unit/exact.c) |
| precise colour | [basis.h](../../core/raster/basis.h) | 3/2048 step near, (x + y + 1) / 2^28 else | [tight.c](../unit/tight.c) |
| precise depth | [plane.h](../../core/raster/plane.h) | 1/64 unit where x + y <= 2046, (x + y + 1) / 2^17 beyond | [tight.c](../unit/tight.c) |
| inverse depth | [inverse.h](../../core/fragment/inverse.h) | q within 1/64 2^-up, the code of that rounded | [tight.c](../unit/tight.c) |
| dithered, a block's mean | [dither.h](../../core/fragment/dither.h) | 1/128 step in all | [tight.c](../unit/tight.c) |
| reciprocal of the area | [texture.h](../../core/base/texture.h) | 2^-27.9 of itself | [tight.c](../unit/tight.c), all tried |
| reciprocal of w | [reciprocal.h](../../core/vertex/reciprocal.h) | 0: the quotient rounded down | [vertex.c](../unit/vertex.c), all tried |
| reciprocal root | [unit.h](../../core/base/unit.h) | 2.42 units below, 0.93 above | [tight.c](../unit/tight.c), all tried |
"""


def tables(rows, apart):
    out = []
    for title, units, wanted in GROUPS:
        modes = {}
        for r in rows:
            if r["unit"] in units.split() and wanted(r):
                modes.setdefault(r["mode"], []).append(r)
        out += [f"### {title}", "",
                "| mode | kernel | mean | 99.9 % | worst of all scenes | M0+ /px | M4 /px | M0+ /triangle "
                "| M4 | flash | RAM | choose it for |", "|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|---|"]
        out += ["| " + " | ".join(line(m)) + " |" for m in modes.values()] + [""]
    return "\n".join(out + separations(apart)) + "\n\n" + BOUNDS
