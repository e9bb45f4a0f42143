#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the wood of strands of every sample is one closed surface, and its strands lie as they must.

Usage: check_strands.py PROGRAM [--blender] [--table FILE.md] RECIPE.json...   (or patterns, such as *.json)
       check_strands.py --self-test

Replays each recipe with wood.mesher=strands and prints a line of a table for it:
    nodes, strands, particles, contacts (pairs of strands that overlap)
    open, non-manifold, degenerate, inverted: what the program's own check of the surface counts; all must be 0
    crossings: pairs of triangles that cross; a count, not a fault
    Blender: non-manifold vertices that Blender selects in the exported OBJ, and edges whose faces disagree about the
             outside; with --blender only
    seconds of the replay with its mesh and its checks
It checks the strands themselves as well, from what --profiles writes: no strand begins or ends at a fork, no two are nearer than
their diameter less a twentieth, frames are orthonormal; and in the skeleton no branch is thicker than the one that
carries it, unless a width is set. Ends with 1 if anything is wrong.
"""

import argparse
import glob
import json
import math
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

NEAREST = 2 * (1 - 0.05)  # Strand radii
MUST_BE_ZERO = ("openEdges", "nonManifoldEdges", "nonManifoldVertices", "degenerate", "inverted")
COLUMNS = ("sample", "nodes", "strands", "particles", "contacts", "open", "non-manifold", "degenerate", "inverted",
           "crossings", "Blender", "seconds")


def nearest_pair(places):
    """The least distance below 4 of two places; 4 if there is none."""
    cells = {}
    least = 16.0
    for x, y in places:
        column, row = math.floor(x / 4), math.floor(y / 4)
        for i in (column - 1, column, column + 1):
            for j in (row - 1, row, row + 1):
                for u, v in cells.get((i, j), ()):
                    distance = (x - u) ** 2 + (y - v) ** 2
                    if distance < least:
                        least = distance
        cells.setdefault((column, row), []).append((x, y))
    return math.sqrt(least)


def strand_faults(nodes, per_tip):
    """What is wrong with the sections of strands, as sentences."""
    faults = []
    children = [[] for _ in nodes]
    for i, node in enumerate(nodes):
        if node["parent"] >= 0:
            children[node["parent"]].append(i)
    seen = set()
    for i, node in enumerate(nodes):
        count = len(node["places"])
        spans = sorted((nodes[c]["offset"], len(nodes[c]["places"])) for c in children[i])
        end = 0
        for offset, length in spans:
            if offset != end:
                faults.append(f"node {i}: the strands of its branches are not one after another")
            end = offset + length
        if spans and end != count:
            faults.append(f"node {i} has {count} strands, its branches {end}")
        if not spans and count != per_tip:
            faults.append(f"tip {i} has {count} strands instead of {per_tip}")
        if abs(math.hypot(*node["frame"]) - 1) > 1e-4:
            faults.append(f"node {i}: its frame is not orthonormal")
        key = hash(tuple(map(tuple, node["places"])))
        if key not in seen:
            seen.add(key)
            least = nearest_pair(node["places"])
            if least < NEAREST:
                faults.append(f"node {i}: two strands are {least:.3f} radii apart")
    return faults


def width_faults(rows):
    """Rows are (id, parent, radius)."""
    radius = {row[0]: row[2] for row in rows}
    return [f"internode {i} is thicker than internode {parent}, which carries it"
            for i, parent, r in rows if parent in radius and r > radius[parent] * 1.0001]


def surface_faults(surface):
    return [f"{name} is {surface[name]}" for name in MUST_BE_ZERO if surface[name] != 0]


def blender_faults(found):
    faults = [f"Blender: {name} is {found[name]}"
              for name in ("nonManifoldVertices", "edgesWithoutTwoFaces", "discontiguousEdges", "degenerateFaces")
              if found[name] != 0]
    if found["volume"] <= 0 or found["faces"] == 0:
        faults.append(f"Blender: the volume of {found['faces']} faces is {found['volume']}")
    return faults


def blender(obj):
    script = Path(__file__).parent / "check_surface.py"
    output = subprocess.run(["blender", "-b", "--factory-startup", "--python", str(script), "--", str(obj)], check=True,
                            capture_output=True, text=True).stdout
    lines = [line for line in output.splitlines() if line.startswith("SURFACE ")]
    if not lines:
        sys.exit("Blender could not check the surface:\n" + output[-2000:])
    return json.loads(lines[0][len("SURFACE "):])


def check(program, recipe, with_blender):
    """A row of the table, and what is wrong."""
    with open(recipe, encoding="utf-8") as file:
        operations = [operation["op"] for operation in json.load(file)["operations"]]
    with tempfile.TemporaryDirectory() as folder:
        stats, profiles, skeleton, obj = (Path(folder) / name for name in ("s.json", "p.json", "t.csv", "t.obj"))
        start = time.monotonic()
        run = subprocess.run([program, "replay", str(recipe), "--strict", "--set", "wood.mesher=strands", "--set", "wood.packing=rest",
                              "--set", "leaves.visible=false", "--stats", str(stats), "--profiles", str(profiles),
                              "-o", str(skeleton), *(["-o", str(obj)] if with_blender else [])],
                             env={**os.environ, "QT_QPA_PLATFORM": "offscreen"}, capture_output=True, text=True)
        seconds = time.monotonic() - start
        if run.returncode != 0:
            return None, [run.stderr.strip()]
        counts = json.loads(stats.read_text(encoding="utf-8"))
        nodes = json.loads(profiles.read_text(encoding="utf-8"))["nodes"]
        rows = [line.split(",") for line in skeleton.read_text(encoding="utf-8").splitlines()[1:]]
        found = blender(obj) if with_blender else None
    surface = counts["surface"]
    tips = len(nodes) - len({node["parent"] for node in nodes} - {-1})
    faults = surface_faults(surface) + strand_faults(nodes, counts["strands"] // max(1, tips))
    if counts["contacts"]["count"] != 0:
        faults.append(f"{counts['contacts']['count']} pairs of strands overlap")
    if "setWidth" not in operations:
        faults += width_faults([(int(row[0]), int(row[1]), float(row[8])) for row in rows])
    if found:
        faults += blender_faults(found)
    row = (Path(recipe).stem, len(nodes), counts["strands"], counts["particles"], counts["contacts"]["count"],
           surface["openEdges"], surface["nonManifoldEdges"] + surface["nonManifoldVertices"], surface["degenerate"], surface["inverted"],
           surface["selfIntersections"],
           f"{found['nonManifoldVertices']} + {found['discontiguousEdges']}" if found else "", f"{seconds:.1f}")
    return row, faults


def self_test():
    """Each check finds the fault that it is for."""
    def node(parent, offset, places, frame=(0, 0, 0, 1)):
        return {"parent": parent, "offset": offset, "places": places, "frame": frame}

    good = [node(-1, 0, [[0, 0], [2, 0]]), node(0, 0, [[0, 0]]), node(0, 1, [[0, 0]])]
    assert strand_faults(good, 1) == []
    assert "strands, its branches" in strand_faults([node(-1, 0, [[0, 0], [2, 0], [4, 0]]), *good[1:]], 1)[0]
    assert "one after another" in strand_faults([good[0], good[1], node(0, 0, [[0, 0]])], 1)[0]
    assert "radii apart" in strand_faults([node(-1, 0, [[0, 0], [1.8, 0]]), *good[1:]], 1)[0]
    assert "orthonormal" in strand_faults([node(-1, 0, [[0, 0]], (0, 0, 0, 2))], 1)[0]
    assert "instead of" in strand_faults(good, 2)[0]
    assert width_faults([(0, -1, 1.0), (1, 0, 0.9)]) == []
    assert "thicker" in width_faults([(0, -1, 1.0), (1, 0, 1.1)])[0]
    for name in MUST_BE_ZERO:
        assert name in surface_faults({**dict.fromkeys(MUST_BE_ZERO, 0), name: 1})[0]
    assert surface_faults(dict.fromkeys(MUST_BE_ZERO, 0)) == []
    found = {"nonManifoldVertices": 0, "edgesWithoutTwoFaces": 0, "discontiguousEdges": 0, "degenerateFaces": 0, "volume": 1.0, "faces": 4}
    assert blender_faults(found) == []
    for name in ("nonManifoldVertices", "edgesWithoutTwoFaces", "discontiguousEdges", "degenerateFaces"):
        assert name in blender_faults({**found, name: 1})[0]
    assert "volume" in blender_faults({**found, "volume": -1.0})[0]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program", nargs="?")
    parser.add_argument("recipes", nargs="*")
    parser.add_argument("--blender", action="store_true")
    parser.add_argument("--table")
    parser.add_argument("--self-test", action="store_true")
    line = parser.parse_intermixed_args()
    if line.self_test:
        self_test()
        return 0
    if not line.recipes:
        parser.error("which recipes?")
    table = ["| " + " | ".join(COLUMNS) + " |", "| " + " | ".join(["---"] * len(COLUMNS)) + " |"]
    print("\n".join(table))
    wrong = [] if any(map(glob.glob, line.recipes)) else ["There are no such recipes."]
    for recipe in sorted(path for pattern in line.recipes for path in glob.glob(pattern)):
        row, faults = check(line.program, recipe, line.blender)
        if row:
            table.append("| " + " | ".join(map(str, row)) + " |")
            print(table[-1], flush=True)
        wrong += [f"{Path(recipe).stem}: {fault}" for fault in faults[:8]]
    if line.table:
        Path(line.table).write_text("\n".join(table + ["", *wrong]) + "\n", encoding="utf-8")
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
