#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Takes pictures of the window with each tool and each sheet, in three sizes, dark and light, for somebody to look at:
OUT/SIZE-THEME.png. With names of sizes only those.

Usage: scripts/contact-sheets.py OUT [1024x700|1600x1000|3840x2160]...
"""

import subprocess
import sys
from pathlib import Path

from hand import PROGRAM, ROOT, Hand

SIZES = {"1024x700": ((1024, 700), 1), "1600x1000": ((1600, 1000), 1), "3840x2160": ((3840, 2160), 2)}
# The keys of all tools and sheets.
KEYS = ["b", "s", "o", "shift+g", "p", "shift+b", "shift+m", "w", "shift+s", "shift+r", "v", "r", "u", "t", "shift+u",
        "shift+p", "shift+v", "ctrl+1", "ctrl+2", "ctrl+3", "ctrl+4", "ctrl+5", "ctrl+h", "F1"]
TILE = 760  # px


def main():
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    tree = folder / "oak.espalier"
    subprocess.run([PROGRAM, "replay", ROOT / "resources/recipes/oak.json", "-o", tree], check=True)
    for name in sys.argv[2:] or SIZES:
        size, scale = SIZES[name]
        for theme in ("dark", "light"):
            tiles = []
            with Hand(":96", size, theme, scale, tree) as hand:
                for key in KEYS:
                    if "ctrl" in key:  # A sheet is shown without a tool's own pane.
                        hand.key("w")
                    hand.key(key, 1.5)
                    tiles.append(folder / f"{name}-{theme}-{key.replace('+', '-')}.png")
                    hand.picture(tiles[-1])
                    # Many pictures of a large screen are more than montage may hold.
                    subprocess.run(["mogrify", "-resize", f"{TILE}x", tiles[-1]], check=True)
                    if "ctrl" in key or key == "F1":
                        hand.key(key)
            subprocess.run(["montage", *tiles, "-tile", "4x", "-geometry", f"{TILE}x+6+6",
                            folder / f"{name}-{theme}.png"], check=True)


if __name__ == "__main__":
    main()
