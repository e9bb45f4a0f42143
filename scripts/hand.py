# SPDX-License-Identifier: GPL-3.0-or-later
"""A hand at the real window: starts the program on a virtual display of its own, and moves, presses and types there.
Needs build/release/bin/espalier, Xvfb, xdotool and ImageMagick."""

import math
import os
import subprocess
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "build/release/bin/espalier"


def run(*command, **options):
    return subprocess.run([str(part) for part in command], capture_output=True, text=True, **options).stdout


def smooth(points, steps=60):
    """A Catmull-Rom curve through the points."""
    ends = [points[0], *points, points[-1]]
    curve = []
    for a, b, c, d in zip(ends, ends[1:], ends[2:], ends[3:]):
        for step in range(steps):
            t = step / steps
            curve.append(
                tuple(
                    0.5 * (2 * b[i] + (c[i] - a[i]) * t + (2 * a[i] - 5 * b[i] + 4 * c[i] - d[i]) * t**2
                           + (3 * b[i] - a[i] - 3 * c[i] + d[i]) * t**3)
                    for i in (0, 1)))
    return [*curve, points[-1]]


def evenly(curve, count):
    """The curve at count + 1 places of equal distance along it."""
    lengths = [0.0]
    for a, b in zip(curve, curve[1:]):
        lengths.append(lengths[-1] + math.dist(a, b))
    places, j = [], 0
    for i in range(count + 1):
        along = lengths[-1] * i / count
        while j + 2 < len(lengths) and lengths[j + 1] < along:
            j += 1
        share = (along - lengths[j]) / max(lengths[j + 1] - lengths[j], 1e-9)
        places.append(tuple(curve[j][k] + share * (curve[j + 1][k] - curve[j][k]) for k in (0, 1)))
    return places


class Hand:
    """A person at the window, who has seen the tour. Places are in px of the display, which the window fills."""

    def __init__(self, display, size=(1440, 900), theme="dark", scale=1, file=None):
        self.size = size
        self.home = tempfile.TemporaryDirectory()
        (Path(self.home.name) / "Espalier").mkdir()
        (Path(self.home.name) / "Espalier/espalier.conf").write_text(
            f"[help]\ntourSeen=true\n[window]\ntheme={['dark', 'light'].index(theme)}\n")
        os.environ["DISPLAY"] = display
        screen = f"{size[0]}x{size[1]}x24"
        self.server = subprocess.Popen(["Xvfb", display, "-screen", "0", screen, "+extension", "GLX", "-noreset"],
                                       stderr=subprocess.DEVNULL)
        time.sleep(2)
        home = self.home.name
        own = {"HOME": home, "XDG_CONFIG_HOME": home, "XDG_DATA_HOME": home, "XDG_CACHE_HOME": home}
        language = {"LANGUAGE": "en", "LC_ALL": "C.UTF-8", "QT_QPA_PLATFORM": "xcb", "QT_SCALE_FACTOR": str(scale)}
        self.program = subprocess.Popen([PROGRAM, *([file] if file else [])], env={**os.environ, **own, **language},
                                        stderr=subprocess.DEVNULL)
        self.gestures = 0
        self.begun = 0.0

    def __enter__(self):
        time.sleep(8)
        search = ("xdotool", "search", "--onlyvisible", "--name", "Espalier")
        for _ in range(60):
            if windows := run(*search).split():
                break
            time.sleep(1)
        else:
            raise RuntimeError("the program shows no window")
        window = windows[-1]
        run("xdotool", "windowsize", window, *self.size)
        run("xdotool", "windowfocus", window)
        run("xdotool", "mousemove", self.size[0] // 2, self.size[1] // 3)
        time.sleep(2)
        self.begun = time.monotonic()
        return self

    def __exit__(self, *_):
        self.program.kill()
        self.server.kill()
        self.program.wait()
        self.server.wait()
        self.home.cleanup()

    def seconds(self):
        return time.monotonic() - self.begun

    def key(self, name, wait=0.4):
        run("xdotool", "key", name)
        time.sleep(wait)

    def text(self, text):
        run("xdotool", "type", "--delay", 30, text)
        time.sleep(0.4)

    def click(self, place):
        run("xdotool", "mousemove", round(place[0]), round(place[1]))
        time.sleep(0.15)
        run("xdotool", "click", 1)
        time.sleep(0.6)

    def drag(self, points, seconds):
        count = max(4, round(60 * seconds))
        lines = []
        for i, (x, y) in enumerate(evenly(smooth(points), count)):
            lines.append(f"mousemove {round(x)} {round(y)}")
            if i == 0:
                lines.append("mousedown 1")
            lines.append("sleep 0.0166")
        lines.append("mouseup 1")
        run("xdotool", "-", input="\n".join(lines) + "\n")
        time.sleep(0.25)

    def stroke(self, points, seconds):
        self.gestures += 1
        self.drag(points, seconds)

    def picture(self, file):
        run("import", "-window", "root", file)

    def start_from(self, species, card):
        """Begins a seedling that grows as a species of the library; card: its place among those found, from 0."""
        self.key("ctrl+l", 1.5)
        self.text(species)
        time.sleep(0.8)
        self.click((134 + 229 * card, 220))
        self.click((1221, 863))
        time.sleep(1.5)

    def save_recipe(self, file):
        file.unlink(missing_ok=True)
        self.click((30, 24))
        self.click((96, 346))
        time.sleep(1)
        self.text(str(file))
        self.key("Return", 2)
