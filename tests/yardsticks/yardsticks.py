#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures trees and compares them with measures of real trees.

Usage: yardsticks.py TREE.csv... [--cut MILLIMETRES] [--json] [--check]

A tree is a skeleton: lines "id,parent,x0,y0,z0,x1,y1,z1,radius" in metres, z up, below a header; a parent of -1 is the base.
Prints a table of the measures of each tree beside those of real trees; --json prints the same as JSON. With --check the exit code is 1 if a
measure is out of its range.

The ranges come from scanned trees, from photographs and from measures taken in the field, and each measure is taken of the part of the
tree that its source contains. Scans end at twigs of about 4.7 mm radius. So measures of branching (orders, ratios, angles, spacing, taper,
box dimension) are taken without thinner twigs, which the ranges do not include.
--cut sets another radius, 0 measures the whole tree. Height, crown, twigs and sky are always those of the whole tree; a
scanned tree without its twigs therefore lets more light through than the photographs that the range of sky comes from.

The functions describe how each measure is taken. The main axis at a fork is the child of the greatest radius, of those the one that
carries the most length.
"""

import argparse
import json
import math
import sys
from pathlib import Path

try:
    import numpy as np
except ImportError:
    sys.exit(f"yardsticks: {sys.executable} has no NumPy; on Debian, scripts/setup.sh test installs it for /usr/bin/python3")

# measure: (least, greatest) of real trees; where trees differ by place or species the whole span.
RANGES = {
    "Strahler order": (5, 7),
    "bifurcation ratio": (2.9, 7.0),
    "length ratio": (1.3, 2.1),
    "diameter ratio": (1.3, 1.9),
    "Tokunaga T1": (0.65, 2.3),
    "path fraction": (0.36, 0.93),
    "diameter exponent": (1.8, 3.0),
    "tips against radius": (1.9, 2.2),
    "trunk taper": (0.5, 0.95),
    "height / diameter": (32, 82),
    "crown width / trunk diameter": (19, 40),
    "crown width / height": (0.23, 1.0),
    "crown share of height": (0.40, 0.84),
    "branching angle of limbs": (38, 67),
    "branching angle": (46, 63),
    "spread of branching angles": (46, 110),
    "azimuth regularity": (0.0, 4.6),
    "spacing variation": (0.63, 1.19),
    "fork asymmetry": (0.66, 0.85),
    "child / parent radius": (0.56, 0.94),
    "twig radius (mm)": (0.5, 4.2),
    "sky from the side": (0.44, 0.54),
    "sky from below": (0.44, 0.54),
    "box dimension": (1.4, 2.0),
    "sharp turns a metre": (0.0, 0.8),
}

SCANNED = 0.0047  # m, radius of the thinnest twigs of the scanned trees


class Skeleton:
    """Segments by rows, each parent before its children."""

    def __init__(self, path):
        try:
            table = np.genfromtxt(path, delimiter=",", names=True, dtype=float)
            columns = [np.atleast_1d(table[name]) for name in ("id", "parent", "x0", "y0", "z0", "x1", "y1", "z1", "radius")]
        except (OSError, ValueError, IndexError) as error:
            raise SystemExit(f"{path}: {error}") from error
        if len(columns[0]) == 0 or not np.isfinite(np.column_stack(columns)).all():
            raise SystemExit(f"{path}: no segments, or numbers that are none")
        ids, parents = columns[0].astype(int), columns[1].astype(int)
        rows = {name: row for row, name in enumerate(ids)}
        parent = np.array([rows.get(name, -1) for name in parents])
        start, end = np.column_stack(columns[2:5]), np.column_stack(columns[5:8])
        radius = columns[8]
        order = topological(parent, path)
        for row in order:  # unknown radii are their bearer's
            if radius[row] <= 0.0:
                radius[row] = radius[parent[row]] if parent[row] >= 0 else radius.max()
        self.path = path
        self.take(order, parent, start, end, radius)

    def without(self, cut):
        """The same tree without segments thinner than that radius."""
        kept = np.zeros(len(self.parent), dtype=bool)
        for row, above in enumerate(self.parent):
            kept[row] = self.radius[row] >= cut and (above < 0 or kept[above])
        if not kept.any():
            raise SystemExit(f"{self.path}: nothing is as thick as {1000.0 * cut:g} mm")
        result = Skeleton.__new__(Skeleton)
        result.path = self.path
        result.take(np.nonzero(kept)[0], self.parent, self.start, self.end, self.radius)
        return result

    def take(self, order, parent, start, end, radius):
        """Keeps the given rows, in that order, and computes derived values."""
        place = {row: i for i, row in enumerate(order)}
        self.parent = np.array([place.get(parent[row], -1) for row in order])
        self.start, self.end, self.radius = start[order], end[order], radius[order]
        self.direction = self.end - self.start
        self.length = np.linalg.norm(self.direction, axis=1)
        self.direction /= np.maximum(self.length, 1e-12)[:, None]
        self.children = [[] for _ in order]
        for row, above in enumerate(self.parent):
            if above >= 0:
                self.children[above].append(row)
        self.tips = self.gathered(np.array([not c for c in self.children], dtype=float))
        self.carried = self.gathered(self.length)
        self.main = [max(c, key=self.rank) if c else -1 for c in self.children]
        self.trunk = self.axis_from(0)
        self.base = self.start[0, 2]
        self.height = max(self.end[:, 2].max(), self.start[:, 2].max()) - self.base

    def gathered(self, own):
        """Sums over all segments that each segment carries, including itself."""
        sums = own.copy()
        for row in range(len(sums) - 1, 0, -1):
            if self.parent[row] >= 0:
                sums[self.parent[row]] += sums[row]
        return sums

    def rank(self, row):
        """Sort key of a fork's children: the greatest continues the axis; of equal ones the higher, then a fixed one of them."""
        return (self.radius[row], round(self.carried[row], 9), *np.round(self.end[row, [2, 0, 1]], 9))

    def axis_from(self, row):
        axis = [row]
        while self.main[axis[-1]] >= 0:
            axis.append(self.main[axis[-1]])
        return axis

    def axes(self):
        starts = [0] + [c for row, all_of in enumerate(self.children) for c in all_of if c != self.main[row]]
        return [self.axis_from(row) for row in starts]

    def laterals(self, row):
        return [c for c in self.children[row] if c != self.main[row]]

    def forks(self):
        return [row for row, c in enumerate(self.children) if len(c) > 1]

    def diameter_at(self, height):
        """Diameter of the trunk at a height above the base, between segments evenly; NaN above its top."""
        for row in self.trunk:
            low, high = self.start[row, 2] - self.base, self.end[row, 2] - self.base
            if low <= height <= high:
                return 2.0 * self.radius[row]
        return math.nan


def topological(parent, path):
    children = [[] for _ in parent]
    for row, above in enumerate(parent):
        if above >= 0:
            children[above].append(row)
    bases = [row for row, above in enumerate(parent) if above < 0]
    if not bases:
        raise SystemExit(f"{path}: it has no base")
    order, open_rows = [], [bases[0]]
    while open_rows:
        row = open_rows.pop()
        order.append(row)
        open_rows.extend(children[row])
    if len(order) != len(parent):
        print(f"{path}: {len(parent) - len(order)} segments hang on nothing and are left out", file=sys.stderr)
    return order


# Orders ------------------------------------------------------------------------------------------------------------

def strahler(tree):
    """Order of each segment: 1 at a tip, one more where two of the highest order meet."""
    orders = np.ones(len(tree.parent), dtype=int)
    for row in range(len(orders) - 1, -1, -1):
        above = sorted((orders[c] for c in tree.children[row]), reverse=True)
        if above:
            orders[row] = above[0] + (1 if len(above) > 1 and above[1] == above[0] else 0)
    return orders


def streams(tree, orders):
    """Maximal chains of segments of one order, lowest first."""
    result = []
    for row in range(len(orders)):
        above = tree.parent[row]
        if above >= 0 and orders[above] == orders[row]:
            continue
        chain = [row]
        while True:
            onward = [c for c in tree.children[chain[-1]] if orders[c] == orders[row]]
            if not onward:
                break
            chain.append(onward[0])
        result.append(chain)
    return result


def slope(x, y):
    return float(np.polyfit(x, y, 1)[0]) if len(x) > 1 else math.nan


def order_ratios(tree):
    """Ratios between orders, from lines through the logarithms of number, mean length and mean diameter by order. Of lengths and
    diameters the highest order does not count: it is one stream, cut off at the ground."""
    orders = strahler(tree)
    chains = streams(tree, orders)
    highest = int(orders.max())
    by_order = [[c for c in chains if orders[c[0]] == order] for order in range(1, highest + 1)]
    numbers = [len(c) for c in by_order]
    lengths = [np.mean([tree.length[c].sum() for c in of]) for of in by_order]
    widths = [np.mean([np.average(tree.radius[c], weights=np.maximum(tree.length[c], 1e-9)) for c in of]) for of in by_order]
    x = np.arange(1, highest + 1)
    below = slice(0, max(2, highest - 1))

    # T_k: side branches k orders lower on a branch; T1 is their mean over all orders above the first.
    sides = []
    for order in range(2, highest + 1):
        joined = 0
        for chain in by_order[order - 1]:
            for row in chain[:-1]:
                joined += sum(1 for c in tree.children[row] if orders[c] == order - 1)
        sides.append(joined / len(by_order[order - 1]))
    return {
        "Strahler order": highest,
        "bifurcation ratio": math.exp(-slope(x, np.log(numbers))) if highest > 1 else math.nan,
        "length ratio": math.exp(slope(x[below], np.log(lengths[below]))) if highest > 1 else math.nan,
        "diameter ratio": math.exp(slope(x[below], np.log(widths[below]))) if highest > 1 else math.nan,
        "Tokunaga T1": float(np.mean(sides)) if sides else math.nan,
    }


def path_fraction(tree):
    """Mean length of the paths from base to tip, divided by the longest."""
    paths = tree.length.copy()
    for row in range(1, len(paths)):
        paths[row] += paths[tree.parent[row]]
    paths = paths[[not c for c in tree.children]]
    return {"path fraction": float(paths.mean() / paths.max())}


# Widths ------------------------------------------------------------------------------------------------------------

def fork_exponent(parent, children):
    """n in d^n = sum of d_i^n, or NaN if no n below 10 fits."""
    ratios = np.asarray(children) / parent
    if (ratios >= 1.0).any() or (ratios <= 0.0).any():
        return math.nan
    low, high = 0.0, 10.0
    if np.power(ratios, high).sum() > 1.0:
        return math.nan
    for _ in range(60):
        middle = 0.5 * (low + high)
        if np.power(ratios, middle).sum() > 1.0:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def widths(tree):
    """The exponent at forks is the median of those that have one. Tips against radius: the slope of logarithms, by the mean of each
    class of radii, so that the many twigs do not outweigh the few limbs. A fork's children are all of them."""
    exponents = np.array([fork_exponent(tree.radius[row], tree.radius[tree.children[row]]) for row in tree.forks()])
    exponents = exponents[np.isfinite(exponents)]
    ratios = [tree.radius[c] / tree.radius[row] for row in tree.forks() for c in tree.children[row]]
    logs = np.log(tree.radius)
    classes = np.floor(logs / 0.2).astype(int)
    means = [(logs[classes == k].mean(), np.log(tree.tips[classes == k]).mean()) for k in np.unique(classes)]
    return {
        "diameter exponent": float(np.median(exponents)) if len(exponents) else math.nan,
        "tips against radius": slope(*zip(*means)) if len(means) > 2 else math.nan,
        "child / parent radius": float(np.median(ratios)) if ratios else math.nan,
    }


def twigs(tree):
    return {"twig radius (mm)": float(1000.0 * np.median(tree.radius[[not c for c in tree.children]]))}


def taper(tree):
    """The trunk's radius grows as its distance from the top to the power of the taper: a line through the logarithms over the whole
    trunk, but for the last fiftieth."""
    rows = np.array(tree.trunk)
    along = np.cumsum(tree.length[rows])
    left = along[-1] - along + 0.5 * tree.length[rows]
    usable = left > 0.02 * along[-1]
    return {"trunk taper": slope(np.log(left[usable]), np.log(tree.radius[rows][usable]))}


def build(tree):
    """Diameter is that at 1.3 m, for trees of less than 4 m at a third of the height; the crown begins where the lowest limb with
    a fiftieth of the tips leaves the trunk."""
    rows = np.array(tree.trunk)
    breast = 1.3 if tree.height >= 4.0 else tree.height / 3.0
    diameter = tree.diameter_at(breast)
    limbs = [c for row in rows for c in tree.laterals(row) if tree.tips[c] >= 0.02 * tree.tips[0]]
    crown_base = min((tree.start[c, 2] for c in limbs), default=tree.base) - tree.base
    in_crown = tree.end[:, 2] - tree.base >= crown_base
    width = crown_width(tree.end[in_crown, :2])
    return {
        "height / diameter": tree.height / diameter,
        "crown width / trunk diameter": width / diameter,
        "crown width / height": width / tree.height,
        "crown share of height": 1.0 - crown_base / tree.height,
    }


def crown_width(points):
    """Mean width of the crown over all directions."""
    angles = np.radians(np.arange(0, 180, 5))
    across = points @ np.stack([np.cos(angles), np.sin(angles)])
    return float((across.max(axis=0) - across.min(axis=0)).mean())


# Angles and spacing ------------------------------------------------------------------------------------------------

def initial_direction(tree, row, reach):
    """Direction of an axis over its first part."""
    start, travelled = tree.start[row], 0.0
    while travelled + tree.length[row] < reach and tree.main[row] >= 0:
        travelled += tree.length[row]
        row = tree.main[row]
    chord = tree.end[row] - start
    norm = np.linalg.norm(chord)
    return chord / norm if norm > 0.0 else tree.direction[row]


def angles(tree):
    """Between the bearing axis and the first part, three diameters of the bearer long, of a lateral that carries more than one
    segment. Regularity of azimuths: n R^2 of the turns between successive limbs of the trunk, of which uniform
    ones exceed 4.6 once in a hundred times (Rayleigh). Spacing: the median over axes of at least six laterals; laterals at one
    place count as one. Asymmetry: the mean over forks that carry ten tips or more, for the least ones cannot but be equal."""
    found, of_limbs = [], []
    for axis in tree.axes():
        for row in axis:
            for c in tree.laterals(row):
                if not tree.children[c]:
                    continue
                toward = initial_direction(tree, c, max(6.0 * tree.radius[row], tree.length[c]))
                angle = math.degrees(math.acos(float(np.clip(toward @ tree.direction[row], -1.0, 1.0))))
                found.append(angle)
                if axis[0] == 0:
                    of_limbs.append(angle)

    azimuths = []
    for row in tree.trunk:
        for c in tree.laterals(row):
            if tree.tips[c] >= 3:
                toward = initial_direction(tree, c, max(6.0 * tree.radius[row], tree.length[c]))
                azimuths.append(math.atan2(toward[1], toward[0]))
    turns = np.diff(azimuths)
    regularity = len(turns) * abs(np.exp(1j * turns).mean()) ** 2 if len(turns) > 4 else math.nan

    variations = []
    for axis in tree.axes():
        along = np.cumsum(tree.length[axis])
        places = np.unique([s for s, row in zip(along, axis) if tree.laterals(row)])
        if len(places) >= 6:
            gaps = np.diff(places)
            variations.append(gaps.std() / gaps.mean())
    crowns = [np.sort(tree.tips[tree.children[row]]) for row in tree.forks() if tree.tips[row] >= 10]
    asymmetries = [1.0 - tips[-2] / tips[-1] for tips in crowns]
    return {
        "branching angle of limbs": float(np.median(of_limbs)) if of_limbs else math.nan,
        "branching angle": float(np.median(found)) if found else math.nan,
        "spread of branching angles": float(np.subtract(*np.percentile(found, [90, 10]))) if found else math.nan,
        "azimuth regularity": float(regularity),
        "spacing variation": float(np.median(variations)) if variations else math.nan,
        "fork asymmetry": float(np.mean(asymmetries)) if asymmetries else math.nan,
    }


# Pictures ----------------------------------------------------------------------------------------------------------

def points_along(tree, chosen, step):
    """Points on the axes of the chosen segments, no further than a step apart."""
    chosen = np.nonzero(chosen)[0]
    counts = np.maximum(1, np.ceil(tree.length[chosen] / step).astype(int))
    rows = np.repeat(chosen, counts)
    part = (np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts) + 0.5) / np.repeat(counts, counts)
    return tree.start[rows] + part[:, None] * (tree.end - tree.start)[rows]


def silhouette(tree, axes, picture, low, pixel):
    """How much of each pixel the segments leave open, seen along the axis that is not among axes. What is thinner than what a line
    touches covers its share of it, as if by chance."""
    side = picture.shape[0]
    start, end = tree.start[:, axes], tree.end[:, axes]
    along = end - start
    length = np.linalg.norm(along, axis=1)
    across = np.stack([-along[:, 1], along[:, 0]], axis=1) / np.maximum(length, 1e-12)[:, None]
    touched = 4.0 / math.pi * pixel  # mean breadth of the pixels that a line touches, over all its directions
    share = np.minimum(1.0, 2.0 * tree.radius / touched)
    flat = picture.reshape(-1)
    for i, half in enumerate(tree.radius):
        s = (np.arange(int(2.5 * length[i] / pixel) + 1) + 0.5) / (int(2.5 * length[i] / pixel) + 1)
        reach = max(0.0, half - 0.5 * touched)
        t = np.linspace(-reach, reach, int(5.0 * reach / pixel) + 1) if reach > 0.0 else np.zeros(1)
        points = start[i] + s[:, None, None] * along[i] + t[None, :, None] * across[i]
        index = np.clip(((points - low) / pixel).astype(np.int32), 0, side - 1).reshape(-1, 2)
        index = index[:, 0] * side + index[:, 1]
        if share[i] >= 1.0:
            flat[index] = 0.0
        else:
            flat[np.unique(index)] *= 1.0 - share[i]


def dilated(picture, reach):
    """Every pixel within a square of the given reach of one that is set."""
    result = picture
    for axis in (0, 1):
        sums = np.cumsum(result.astype(np.int32), axis=axis)
        pad = [(reach + 1, reach) if a == axis else (0, 0) for a in (0, 1)]
        sums = np.pad(sums, pad, mode="edge")
        if axis == 0:
            sums[: reach + 1] = 0
            result = sums[2 * reach + 1:] - sums[: -2 * reach - 1] > 0
        else:
            sums[:, : reach + 1] = 0
            result = sums[:, 2 * reach + 1:] - sums[:, : -2 * reach - 1] > 0
    return result


def sky(tree, pixels=2400):
    """Share of the crown's outline through which one sees the sky, as on a photograph: past twigs, limbs and what of the trunk stands
    in the crown. The outline is that of what the trunk's limbs carry and closes gaps of up to a tenth of its extent."""
    is_crown = np.ones(len(tree.parent), dtype=bool)
    is_crown[tree.trunk] = False
    result = {}
    for name, axes in (("sky from the side", (0, 2)), ("sky from below", (0, 1))):
        if is_crown.sum() < 10:
            result[name] = math.nan
            continue
        ends = np.concatenate([tree.start[is_crown][:, axes], tree.end[is_crown][:, axes]])
        extent = (ends.max(axis=0) - ends.min(axis=0)).max()
        pixel = max(extent / pixels, 1e-9)
        margin = pixels // 8
        side = pixels + 2 * margin
        low = ends.min(axis=0) - margin * pixel
        picture = np.ones((side, side), dtype=np.float32)
        silhouette(tree, axes, picture, low, pixel)
        coarse = np.zeros((side // 4, side // 4), dtype=bool)  # the outline needs no detail
        index = ((points_along(tree, is_crown, 2.0 * pixel)[:, axes] - low) / (4.0 * pixel)).astype(int)
        coarse[index[:, 0], index[:, 1]] = True
        reach = coarse.shape[0] // 25
        outline = ~dilated(~dilated(coarse, reach), reach)
        result[name] = float(picture.reshape(side // 4, 4, side // 4, 4).mean(axis=(1, 3))[outline].mean())
    return result


def box_dimension(tree):
    """Slope of the number of occupied boxes against their size, from a sixth of the height to a ninetieth."""
    points = points_along(tree, np.ones(len(tree.parent), dtype=bool), tree.height / 400.0)
    sizes = tree.height / np.geomspace(6, 90, 9)
    numbers = []
    for size in sizes:
        least = math.inf  # over some places of the grid, which must not matter
        for shift in (0.0, 0.33, 0.67):
            boxes = np.floor(points / size + shift).astype(np.int64)
            keys = (boxes[:, 0] * 1000003 + boxes[:, 1]) * 1000003 + boxes[:, 2]
            least = min(least, len(np.unique(keys)))
        numbers.append(least)
    return {"box dimension": -slope(np.log(sizes), np.log(numbers))}


def sharp_turns(tree, chord=0.1, angle=30.0):
    """Turns of more than 30 degrees between successive chords of 10 cm along the axes, a metre of chords."""
    turns, chords = 0, 0
    for axis in tree.axes():
        line = np.vstack([tree.start[axis[0]], tree.end[axis]])
        points, left = [line[0]], chord
        for a, b in zip(line, line[1:]):
            length = np.linalg.norm(b - a)
            at = left
            while at <= length and length > 0.0:
                points.append(a + (b - a) * at / length)
                at += chord
            left = at - length
        steps = np.diff(np.array(points), axis=0)
        chords += len(steps)
        if len(steps) > 1:
            norms = np.maximum(np.linalg.norm(steps, axis=1), 1e-12)
            cosines = (steps[:-1] * steps[1:]).sum(axis=1) / (norms[:-1] * norms[1:])
            turns += int((np.degrees(np.arccos(np.clip(cosines, -1.0, 1.0))) > angle).sum())
    return {"sharp turns a metre": turns / (chord * chords) if chords else math.nan}


def measure(tree, cut=SCANNED):
    """All measures by name; what a tree is too small for is NaN."""
    values = {}
    scanned = tree.without(cut)
    for part in (order_ratios, path_fraction, widths, taper, angles, box_dimension, sharp_turns):
        values.update(part(scanned))
    for part in (build, twigs, sky):
        values.update(part(tree))
    return {name: values[name] for name in RANGES}


def verdict(name, value, bounds=None):
    if not math.isfinite(value):
        return "-"
    low, high = bounds or RANGES[name]
    return "ok" if low <= round(value, 2) <= high else "OUT"


def main():
    parser = argparse.ArgumentParser(description="Measures trees by the yardsticks of real ones.")
    parser.add_argument("trees", nargs="+", metavar="TREE.csv", type=Path)
    parser.add_argument("--cut", type=float, default=1000.0 * SCANNED, metavar="MILLIMETRES",
                        help="radius down to which branching is measured (default: %(default)g)")
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.add_argument("--check", action="store_true", help="end with 1 if a measure is out of its range")
    arguments = parser.parse_args()
    measured = {str(path): measure(Skeleton(path), arguments.cut / 1000.0) for path in arguments.trees}

    if arguments.json:
        print(json.dumps({path: {name: {"value": None if math.isnan(value) else round(value, 4), "range": RANGES[name],
                                        "verdict": verdict(name, value)} for name, value in values.items()}
                          for path, values in measured.items()}, indent=2))
    else:
        print(f"{'measure':30}{'real trees':>14}" + "".join(f"{Path(path).stem[:14]:>18}" for path in measured))
        for name, (low, high) in RANGES.items():
            cells = "".join(f"{values[name]:>13.3g} {verdict(name, values[name]):<4}" for values in measured.values())
            print(f"{name:30}{f'{low:g} to {high:g}':>14}{cells}".rstrip())
    if arguments.check and any(verdict(name, v) == "OUT" for values in measured.values() for name, v in values.items()):
        sys.exit(1)


if __name__ == "__main__":
    main()
