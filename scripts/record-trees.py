#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws trees in the real window, as a person does with a mouse, and saves what was drawn as recipes of its pointer
samples, with pictures: docs/recordings/NAME.json and docs/pictures/recorded-NAME.jpg.

Usage: scripts/record-trees.py [NAME...]        NAME: oak, willow, pine, bonsai

Prints for each tree how many gestures it took and how many seconds, from the blank page to the last gesture. Fails if
a tree took more than two minutes or fifteen gestures. Needs build/release/bin/espalier, Xvfb, xdotool and ImageMagick.
"""

import subprocess
import sys

from hand import PROGRAM, ROOT, Hand

MOST_SECONDS = 120
MOST_GESTURES = 15


class Page:
    """The page of a seedling seen from the front; places are in metres to the right of its foot and above it."""

    FOOT = (720, 674)  # px
    SLIDER = 252  # Of the brush's radius, px from the left

    def __init__(self, hand, species, card, metre):
        """card: the species' place among those that the library finds; metre: in px."""
        hand.start_from(species, card)
        self.hand, self.metre = hand, metre

    def stroke(self, seconds, *points):
        self.hand.stroke([(self.FOOT[0] + x * self.metre, self.FOOT[1] - y * self.metre) for x, y in points], seconds)

    def slide(self, start, end):
        """Drags the handle of the radius slider from one height to another, px."""
        self.hand.drag([(self.SLIDER, start), (self.SLIDER, (start + end) / 2), (self.SLIDER, end)], 0.5)

    def front(self):
        self.hand.key("1", 1.8)

    def side(self):
        self.hand.key("3", 1.8)


def oak(hand):
    page = Page(hand, "oak", 3, 74.5)
    page.slide(195, 303)
    page.stroke(1.2, (0, 0), (0.05, 1.0), (-0.08, 2.0), (0.1, 3.0))
    page.stroke(1.0, (0.0, 1.9), (1.0, 2.5), (2.1, 3.0), (3.0, 3.9))
    page.stroke(1.0, (0.0, 2.2), (-1.0, 2.9), (-1.9, 3.5), (-2.9, 3.9))
    page.stroke(0.9, (0.08, 2.9), (0.4, 4.0), (1.0, 5.2))
    page.stroke(0.9, (0.05, 2.8), (-0.5, 3.9), (-1.1, 5.0))
    page.side()
    page.stroke(1.0, (0.0, 2.0), (1.0, 2.7), (2.0, 3.3), (2.7, 4.2))
    page.stroke(1.0, (0.0, 2.4), (-1.0, 3.0), (-2.0, 3.6), (-2.7, 4.4))
    page.front()
    page.slide(303, 195)
    page.stroke(6.0, (-2.9, 3.6), (-2.8, 4.6), (-1.3, 5.6), (0.5, 5.9), (2.1, 5.2), (3.1, 3.8))
    page.side()
    page.stroke(5.0, (-2.7, 4.1), (-2.1, 5.0), (-0.6, 5.6), (1.0, 5.4), (2.7, 4.1))
    page.front()


def willow(hand):
    page = Page(hand, "willow", 0, 85)
    page.slide(195, 303)
    page.stroke(1.0, (0, 0), (0.06, 0.9), (-0.05, 1.8), (0.05, 2.6))
    page.stroke(1.0, (0.0, 1.7), (0.8, 2.9), (1.5, 3.9), (2.2, 4.6))
    page.stroke(1.0, (0.0, 1.9), (-0.8, 3.0), (-1.4, 4.0), (-2.1, 4.5))
    page.stroke(0.8, (0.05, 2.5), (0.3, 3.6), (0.5, 4.9))
    page.stroke(0.8, (0.0, 2.4), (-0.4, 3.6), (-0.6, 5.0))
    page.side()
    page.stroke(0.9, (0.0, 1.9), (0.8, 3.1), (1.9, 4.5))
    page.stroke(0.9, (0.0, 2.1), (-0.8, 3.2), (-1.9, 4.4))
    page.slide(303, 205)
    page.stroke(3.0, (-2.0, 4.5), (-0.9, 5.2), (0.4, 5.4), (1.9, 4.6))
    page.front()
    page.stroke(3.5, (-2.2, 4.5), (-1.2, 5.2), (0.0, 5.6), (1.2, 5.3), (2.3, 4.6))
    page.stroke(2.2, (-2.4, 4.2), (-2.7, 3.0), (-2.6, 1.6))
    page.stroke(2.2, (2.4, 4.2), (2.7, 3.0), (2.6, 1.6))


def pine(hand):
    page = Page(hand, "pine", 1, 87)
    page.slide(180, 303)
    page.stroke(1.6, (0, 0), (0.05, 1.5), (-0.1, 3.0), (0.05, 4.4), (0.1, 5.6))
    page.stroke(0.8, (-0.05, 3.6), (0.7, 3.8), (1.5, 4.1))
    page.stroke(0.8, (0.0, 4.1), (-0.8, 4.4), (-1.5, 4.5))
    page.stroke(0.8, (0.05, 4.8), (0.8, 5.1), (1.3, 5.4))
    page.stroke(0.8, (0.08, 5.2), (-0.5, 5.6), (-0.9, 5.9))
    page.side()
    page.stroke(0.8, (-0.05, 3.8), (0.8, 4.2), (1.3, 4.4))
    page.stroke(0.8, (0.02, 4.5), (-0.7, 4.8), (-1.3, 5.0))
    page.slide(303, 207)
    page.stroke(1.2, (0.5, 4.3), (1.4, 4.6))
    page.stroke(1.2, (-0.5, 4.9), (-1.4, 5.2))
    page.front()
    page.stroke(1.2, (0.7, 4.0), (1.7, 4.3))
    page.stroke(1.2, (-0.6, 4.5), (-1.7, 4.7))
    page.stroke(2.2, (1.4, 5.4), (0.5, 5.8), (-0.2, 6.2), (-1.0, 6.0))


def bonsai(hand):
    page = Page(hand, "bonsai", 0, 830)
    page.slide(224, 303)
    page.stroke(2.0, (0, 0), (0.07, 0.06), (0.09, 0.16), (0.0, 0.25), (-0.07, 0.33), (-0.03, 0.42), (0.04, 0.48))
    page.stroke(0.8, (0.085, 0.15), (0.17, 0.2), (0.26, 0.2))
    page.stroke(0.8, (-0.04, 0.29), (-0.14, 0.33), (-0.23, 0.32))
    page.stroke(0.8, (-0.05, 0.38), (0.06, 0.42), (0.15, 0.41))
    page.side()
    page.stroke(0.8, (0.0, 0.22), (0.1, 0.27), (0.16, 0.27))
    page.stroke(0.8, (0.0, 0.35), (-0.1, 0.39), (-0.15, 0.39))
    page.slide(303, 232)
    page.stroke(0.9, (0.06, 0.28), (0.17, 0.29))
    page.stroke(0.9, (-0.05, 0.4), (-0.16, 0.41))
    page.front()
    page.stroke(1.0, (0.15, 0.21), (0.28, 0.22))
    page.stroke(1.0, (-0.12, 0.345), (-0.25, 0.345))
    page.stroke(1.0, (0.05, 0.43), (0.17, 0.43))
    page.stroke(1.0, (-0.04, 0.5), (0.08, 0.51))


TREES = {"oak": oak, "willow": willow, "pine": pine, "bonsai": bonsai}


def main():
    is_faulty = False
    for name in sys.argv[1:] or TREES:
        recipe = ROOT / f"docs/recordings/{name}.json"
        recipe.parent.mkdir(exist_ok=True)
        with Hand(":95") as hand:
            TREES[name](hand)
            seconds, gestures = hand.seconds(), hand.gestures
            hand.save_recipe(recipe)
            picture = recipe.with_suffix(".png")
            subprocess.run([PROGRAM, "replay", recipe, "--png", picture, "--size", "640x560"], check=True)
        print(f"{name}: {gestures} gestures, {seconds:.0f} s")
        if not recipe.exists() or seconds > MOST_SECONDS or gestures > MOST_GESTURES:
            is_faulty = True
            continue
        subprocess.run(["convert", picture, "-strip", "-quality", "88", ROOT / f"docs/pictures/recorded-{name}.jpg"],
                       check=True)
        picture.unlink()
    sys.exit(1 if is_faulty else 0)


if __name__ == "__main__":
    main()
