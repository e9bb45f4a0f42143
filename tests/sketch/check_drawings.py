#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a tree of each drawing of Quick, Draw! files, and says what came of it.

Usage: check_drawings.py ESPALIER FILE.ndjson... [--pictures FOLDER]

Prints a table: strokes, what joined the tree, crowns, the error from the front in thousandths of the drawing, the silhouette
from the side as a share of that from the front, and seconds. Fails if a drawing gives neither a tree nor one sentence, if a
tree is farther than a thousandth from its drawing, or if a drawing with three or more branches and no crown is much
fuller or thinner from the side (beyond a quarter).
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("espalier")
    parser.add_argument("files", nargs="+")
    parser.add_argument("--pictures")
    arguments = parser.parse_args()
    faults = []
    refused = 0
    print("| drawing | strokes | attached | crowns | internodes | front error | side / front | s |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    for name in arguments.files:
        count = sum(1 for line in pathlib.Path(name).read_text().splitlines() if line.strip())
        for index in range(count):
            label = f"{pathlib.Path(name).stem} {index}"
            with tempfile.TemporaryDirectory() as folder:
                stats = pathlib.Path(folder) / "stats.json"
                command = [arguments.espalier, "sketch", name, "--index", str(index), "--stats", str(stats)]
                if arguments.pictures:
                    pathlib.Path(arguments.pictures).mkdir(parents=True, exist_ok=True)
                    picture = pathlib.Path(arguments.pictures) / f"{pathlib.Path(name).stem}-{index:02}.png"
                    command += ["--png", str(picture), "--size", "300x300", "--camera", "three-quarter"]
                done = subprocess.run(command, capture_output=True, text=True, timeout=120)
                if done.returncode == 3 and done.stderr.count("\n") == 1:
                    refused += 1
                    print(f"| {label} | {done.stderr.strip()} |")
                    continue
                if done.returncode != 0:
                    faults.append(f"{label}: exit {done.returncode}: {done.stderr.strip()}")
                    continue
                said = json.loads(stats.read_text())
            seconds = said["seconds"].get("infer", 0.0)
            print(f"| {label} | {said['strokes']} | {said['attached']} | {said['crowns']} | {said['internodes']} "
                  f"| {said['frontError']:.2f} | {said['sideOverFront']:.2f} | {seconds:.3f} |")
            if said["frontError"] > 1.0:
                faults.append(f"{label}: {said['frontError']:.1f} thousandths from its drawing")
            branches = said["attached"] - said["leavesPlaced"]
            if branches > 3 and said["crowns"] == 0 and not 0.75 <= said["sideOverFront"] <= 1.25:
                faults.append(f"{label}: the side is {said['sideOverFront']:.2f} of the front")
    print(f"{refused} refused with a sentence")
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
