"""tradeoff.svg: error against cost on Cortex-M0+, a panel a question. What no other mode beats in error, in
cost a pixel and in cost a small triangle is green; what another beats is grey."""
from math import log10

PANELS = (
    ("Colour", "largest error beyond 1/2 step", "near", "step", lambda m: "block" not in m, True),
    ("Colour of 8 x 8 px", "mean error of a block's mean, steps", "ramps", "step",
     lambda m: "block" in m, False),
    ("Depth", "largest error beyond 1/2 unit or code", "near", "unit code", lambda m: True, True),
    ("Hidden surfaces", "share of wrong pixels", "near", "wrong", lambda m: True, False),
    ("Perspective", "largest error beyond 1/2 texel", "near", "texel", lambda m: True, True),
    ("Edges", "mean error of a pixel's share", "near", "pixel", lambda m: True, False),
)
W, H, COLUMNS, LEFT, TOP, RIGHT, BOTTOM = 480, 330, 2, 74, 52, 120, 44
FLOOR = 1e-6  # what is less stands on the lowest line, as 0


def points_of(rows, panel):
    """(cost a pixel, error, cost a small triangle, mode) of a panel, cheapest first. The error is the
    largest of all scenes, or the mean of one; the small triangles are those of the mesh."""
    title, axis, scene, units, wanted, largest = panel
    here = [r for r in rows if r["unit"] in units.split() and wanted(r["mode"])]
    out = []
    for r in here:
        if r["scene"] != scene:
            continue
        same = [s for s in here if s["mode"] == r["mode"]]
        small = [s["m0plus_all"] for s in same if s["scene"] == "mesh"]
        error = max(0, max(float(s["max"]) for s in same) - 0.5) if largest else float(r["mean"])
        out.append((float(r["m0plus"]), error, small[0] if small else 0,
                    r["mode"].replace(" by block", "")))
    return sorted(out)


def beats(a, b):
    """a is as good as b in everything, and better in something by more than a thousandth."""
    return all(x <= y + 1e-6 for x, y in zip(a[:3], b[:3])) and \
        any(x < y * 0.999 - 1e-6 for x, y in zip(a[:3], b[:3]))


def best(points):
    """Those that none beats."""
    return [p for p in points if not any(beats(q, p) for q in points)]


def front(points):
    """Of these, what no cheaper one a pixel is as exact as: the line."""
    out, least = [], float("inf")
    for p in points:
        if p[1] < least * 0.999:
            out.append(p)
            least = p[1]
    return out


def ticks(low, high):
    return [e for e in range(int(low) - 1, int(high) + 2) if low - 1e-9 <= e <= high + 1e-9]


def power(e):
    return f"{10 ** e:g}" if -4 <= e <= 4 else f"1e{e}"


def labels(placed):
    """Moves labels apart upwards where they would overlap: (x, y, y of the label, mode, good)."""
    out = []
    for x, y, mode, good in sorted(placed, key=lambda p: (-p[1], p[0])):
        at = y + 4
        while any(abs(at - other[2]) < 12 and abs(x - other[0]) < 105 for other in out):
            at -= 4
        out.append((x, y, at, mode, good))
    return out


def panel_svg(rows, panel, left, top):
    points = points_of(rows, panel)
    good = best(points)
    xs = [log10(p[0]) for p in points]
    ys = [log10(max(p[1], FLOOR)) for p in points]
    x0, x1 = min(xs) - 0.1, max(xs) + 0.1
    y0, y1 = min(ys) - 0.3, max(ys) + 0.3
    w, h = W - LEFT - RIGHT, H - TOP - BOTTOM

    def at(p):
        return (left + LEFT + (log10(p[0]) - x0) / (x1 - x0) * w,
                top + TOP + (y1 - log10(max(p[1], FLOOR))) / (y1 - y0) * h)

    out = [f'<text x="{left + LEFT}" y="{top + 24}" font-weight="bold" font-size="15">{panel[0]}</text>',
           f'<text x="{left + LEFT}" y="{top + 42}" fill="#555">{panel[1]}</text>',
           f'<rect x="{left + LEFT}" y="{top + TOP}" width="{w}" height="{h}" fill="#fafafa" stroke="#bbb"/>']
    for e in ticks(y0, y1):
        y = top + TOP + (y1 - e) / (y1 - y0) * h
        name = "0" if 10 ** e <= FLOOR * 1.001 else power(e)
        out.append(f'<line x1="{left + LEFT}" x2="{left + LEFT + w}" y1="{y:.1f}" y2="{y:.1f}" stroke="#e4e4e4"/>')
        out.append(f'<text x="{left + LEFT - 6}" y="{y + 4:.1f}" text-anchor="end" fill="#555">{name}</text>')
    for v in (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000):
        if x0 <= log10(v) <= x1:
            x = left + LEFT + (log10(v) - x0) / (x1 - x0) * w
            out.append(f'<line x1="{x:.1f}" x2="{x:.1f}" y1="{top + TOP}" y2="{top + TOP + h}" stroke="#e4e4e4"/>')
            out.append(f'<text x="{x:.1f}" y="{top + TOP + h + 15}" text-anchor="middle" fill="#555">{v}</text>')
    out.append(f'<text x="{left + LEFT + w / 2}" y="{top + TOP + h + 32}" text-anchor="middle" '
               'fill="#555">instructions a pixel, Cortex-M0+</text>')
    if len(good) > 1:
        line = " ".join("%.1f,%.1f" % at(p) for p in front(good))
        out.append(f'<polyline points="{line}" fill="none" stroke="#2a8f4e" stroke-width="2" opacity=".5"/>')
    placed = [(*at(p), p[3], p in good) for p in points]
    for x, y, label, mode, ok in labels(placed):
        color = "#1b7a3d" if ok else "#999"
        out.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{5 if ok else 3.5}" fill="{color}"/>')
        if abs(label - y) > 6:
            out.append(f'<line x1="{x:.1f}" y1="{y:.1f}" x2="{x + 7:.1f}" y2="{label - 3:.1f}" stroke="#bbb"/>')
        out.append(f'<text x="{x + 9:.1f}" y="{label:.1f}" fill="{color}"'
                   f'{" font-weight=" + chr(34) + "bold" + chr(34) if ok else ""}>{mode}</text>')
    return out


def svg(rows):
    out = []
    for i, panel in enumerate(PANELS):
        out += panel_svg(rows, panel, i % COLUMNS * W, i // COLUMNS * H)
    height = (len(PANELS) + COLUMNS - 1) // COLUMNS * H
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{COLUMNS * W}" height="{height}" '
            f'font-family="sans-serif" font-size="12"><rect width="100%" height="100%" fill="white"/>\n'
            + "\n".join(out) + "\n</svg>\n")
