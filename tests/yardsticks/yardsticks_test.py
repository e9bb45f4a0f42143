#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Known answers for yardsticks.py: trees so regular that their measures follow from their making."""

import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
import yardsticks  # noqa: E402  Says what is missing if there is no NumPy.
import numpy as np  # noqa: E402

SCRIPT = Path(__file__).with_name("yardsticks.py")


class Builder:
    def __init__(self):
        self.rows = []

    def add(self, parent, start, direction, length, radius):
        start = np.asarray(start, dtype=float)
        direction = np.asarray(direction, dtype=float) / np.linalg.norm(direction)
        end = start + length * direction
        self.rows.append((len(self.rows), parent, *start, *end, radius))
        return len(self.rows) - 1, end

    def write(self, folder):
        path = Path(folder) / "tree.csv"
        lines = ["id,parent,x0,y0,z0,x1,y1,z1,radius"]
        lines += [f"{i},{p}," + ",".join(repr(float(v)) for v in rest) for i, p, *rest in self.rows]
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")
        return path

    def measure(self, cut=0.0):
        with tempfile.TemporaryDirectory() as folder:
            return yardsticks.measure(yardsticks.Skeleton(self.write(folder)), cut)


def binary_tree(levels=7):
    """Every branch forks in two that are 1.5 times shorter and carry half its area each."""
    tree = Builder()

    def grow(parent, start, direction, level):
        row, end = tree.add(parent, start, direction, 1.5 ** -level, 0.1 * 2 ** (-level / 2))
        if level + 1 < levels:
            across = np.cross(direction, [0.3, 0.5, 0.8] if level % 2 else [0.8, -0.1, 0.2])
            across /= np.linalg.norm(across)
            for side in (1, -1):
                grow(row, end, direction + side * across, level + 1)

    grow(-1, [0, 0, 0], np.array([0.0, 0.0, 1.0]), 0)
    return tree


def pole(height=10.0, radius=lambda left: 0.1, segments=100):
    tree, parent, at = Builder(), -1, np.zeros(3)
    for i in range(segments):
        left = height * (1 - (i + 0.5) / segments)
        parent, at = tree.add(parent, at, [0, 0, 1], height / segments, radius(left))
    return tree


class YardsticksTest(unittest.TestCase):
    def test_binaryTree_hasTheRatiosItWasMadeWith(self):
        values = binary_tree().measure()
        self.assertEqual(values["Strahler order"], 7)
        self.assertAlmostEqual(values["bifurcation ratio"], 2.0, 6)
        self.assertAlmostEqual(values["length ratio"], 1.5, 6)
        self.assertAlmostEqual(values["diameter ratio"], math.sqrt(2), 6)
        self.assertAlmostEqual(values["Tokunaga T1"], 0.0, 6)
        self.assertAlmostEqual(values["path fraction"], 1.0, 6)
        self.assertAlmostEqual(values["diameter exponent"], 2.0, 6)
        self.assertAlmostEqual(values["tips against radius"], 2.0, 6)
        self.assertAlmostEqual(values["child / parent radius"], math.sqrt(0.5), 6)
        self.assertAlmostEqual(values["fork asymmetry"], 0.0, 6)
        self.assertAlmostEqual(values["twig radius (mm)"], 100 * 2 ** -3, 6)

    def test_cut_leavesOutWhatIsThinner(self):
        values = binary_tree().measure(cut=0.1 * 2 ** -1.6)
        self.assertEqual(values["Strahler order"], 4)

    def test_cut_concernsTheBranchingAlone(self):
        whole, cut = binary_tree().measure(), binary_tree().measure(cut=0.1 * 2 ** -1.6)
        for name in ("height / diameter", "crown width / height", "twig radius (mm)", "sky from the side", "sky from below"):
            self.assertEqual(cut[name], whole[name], name)
        self.assertNotEqual(cut["box dimension"], whole["box dimension"])

    def test_cut_ofTheWholeTree_isRefusedInWords(self):
        with self.assertRaisesRegex(SystemExit, "nothing is as thick as 500 mm"):
            binary_tree(3).measure(cut=0.5)

    def test_orderOfLinesAndIds_doesNotMatter(self):
        tree = binary_tree(5)
        expected = tree.measure()
        names = {row[0]: 1000 - 7 * row[0] for row in tree.rows}
        names[-1] = -1
        tree.rows = [(names[r[0]], names[r[1]], *r[2:]) for r in reversed(tree.rows)]
        for name, value in tree.measure().items():
            if math.isfinite(value):
                self.assertAlmostEqual(value, expected[name], 6, name)

    def test_herringbone_hasItsSideBranches(self):
        # One axis with five single laterals: order 2, T1 = 5 less the two that meet at its top.
        tree = pole(segments=6)
        for i in range(5):
            tree.add(i, [0, 0, 10 * (i + 1) / 6], [1, 0, 1], 1.0, 0.02)
        values = tree.measure()
        self.assertEqual(values["Strahler order"], 2)
        self.assertAlmostEqual(values["Tokunaga T1"], 4.0)

    def test_pole_hasItsTaperAndSlenderness(self):
        values = pole(radius=lambda left: 0.02 * left ** 0.7).measure()
        self.assertAlmostEqual(values["trunk taper"], 0.7, 2)
        values = pole(radius=lambda left: 0.1).measure()
        self.assertAlmostEqual(values["height / diameter"], 50.0, 6)

    def test_limbs_haveTheirAnglesWidthAndShare(self):
        # Limbs of 2 m at 60 degrees from 4 m up, 137.5 degrees apart, bearing a twig each.
        tree = pole()
        for i in range(40, 100, 3):
            azimuth = math.radians(137.5) * i / 3
            out = [math.sin(math.radians(60)) * math.cos(azimuth), math.sin(math.radians(60)) * math.sin(azimuth),
                   math.cos(math.radians(60))]
            limb, end = tree.add(i, [0, 0, (i + 1) * 0.1], out, 1.9, 0.02)
            tree.add(limb, end, out, 0.1, 0.01)
        values = tree.measure()
        self.assertAlmostEqual(values["branching angle of limbs"], 60.0, 3)
        self.assertAlmostEqual(values["spread of branching angles"], 0.0, 3)
        self.assertAlmostEqual(values["crown share of height"], 0.6, 1)
        self.assertAlmostEqual(values["crown width / height"], 2 * 2 * math.sin(math.radians(60)) / 10.9, 1)
        self.assertAlmostEqual(values["spacing variation"], 0.0, 3)

    def test_regularAzimuths_areToldFromRandomOnes(self):
        for regular in (True, False):
            tree, random = pole(), np.random.default_rng(4)
            for i in range(20, 100, 2):
                azimuth = math.radians(137.5) * i / 2 if regular else random.uniform(0, 2 * math.pi)
                out = [math.cos(azimuth), math.sin(azimuth), 1.0]
                limb, end = tree.add(i, [0, 0, (i + 1) * 0.1], out, 1.0, 0.02)
                for side in (-1, 0, 1):
                    tree.add(limb, end, [out[0] + side, out[1], 1.0], 0.2, 0.01)
            self.assertEqual(yardsticks.verdict("azimuth regularity", tree.measure()["azimuth regularity"]),
                             "OUT" if regular else "ok")

    def test_sky_isWhatBarsLeave(self):
        # Level bars of 5 cm every 10 cm on both sides of a thin pole.
        tree = pole(height=4.0, radius=lambda left: 0.001, segments=40)
        for i in range(40):
            for side in (-1, 1):
                row, end = tree.add(i, [0, 0, (i + 1) * 0.1], [side, 0, 0], 1.0, 0.025)
                tree.add(row, end, [side, 0, 0], 1.0, 0.025)
        self.assertAlmostEqual(tree.measure()["sky from the side"], 0.5, 1)

    def test_sharpTurns_areCountedByTheMetre(self):
        # A zigzag with a corner of 90 degrees every metre, and a bow without any.
        zigzag, parent, at = Builder(), -1, np.zeros(3)
        for i in range(10):
            for _ in range(10):
                parent, at = zigzag.add(parent, at, [1, 0, 1] if i % 2 else [-1, 0, 1], 0.1, 0.02)
        self.assertAlmostEqual(zigzag.measure()["sharp turns a metre"], 0.9, 1)
        bow, parent, at = Builder(), -1, np.zeros(3)
        for i in range(100):
            parent, at = bow.add(parent, at, [math.sin(0.02 * i), 0, math.cos(0.02 * i)], 0.1, 0.02)
        self.assertEqual(bow.measure()["sharp turns a metre"], 0.0)

    def test_boxDimension_ofALineAndOfAWall(self):
        self.assertAlmostEqual(pole().measure()["box dimension"], 1.0, 1)
        tree = pole(height=4.0, segments=200)
        for i in range(200):
            for side in (-1, 1):
                tree.add(i, [0, 0, (i + 1) * 0.02], [side, 0, 0], 2.0, 0.01)
        self.assertGreater(tree.measure()["box dimension"], 1.85)

    def test_check_failsWhereAMeasureIsOut(self):
        with tempfile.TemporaryDirectory() as folder:
            path = binary_tree().write(folder)
            command = [sys.executable, str(SCRIPT), str(path)]
            self.assertEqual(subprocess.run(command, capture_output=True).returncode, 0)
            self.assertEqual(subprocess.run(command + ["--check"], capture_output=True).returncode, 1)
            json_output = subprocess.run(command + ["--json"], capture_output=True, text=True).stdout
            self.assertIn('"bifurcation ratio"', json_output)

    def test_brokenFiles_areRefusedInWords(self):
        with tempfile.TemporaryDirectory() as folder:
            for text in ("", "id,parent\n1,2\n", "id,parent,x0,y0,z0,x1,y1,z1,radius\n1,2,3\n",
                         "id,parent,x0,y0,z0,x1,y1,z1,radius\n0,-1,0,0,0,0,0,nan,1\n"):
                path = Path(folder) / "broken.csv"
                path.write_text(text, encoding="utf-8")
                result = subprocess.run([sys.executable, str(SCRIPT), str(path)], capture_output=True, text=True)
                self.assertNotEqual(result.returncode, 0)
                self.assertIn("broken.csv", result.stderr)
                self.assertNotIn("Traceback", result.stderr)


if __name__ == "__main__":
    unittest.main()
