#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that includes point down the layers only, that they are found from the root, that the algorithms stay free
of QObject and of widgets, and that nothing includes itself by way of others: neither units (a header and its source)
nor folders.

Usage: check-includes.py [--self-test]
"""

import re
import sys
import tempfile
from pathlib import Path

BELOW_ROOMS = {"model/base", "model/tree"}
ROOMS = {"model/growth", "model/shape", "model/envelope", "model/sketch", "model/strands", "model/mesh",
         "model/picking", "model/texture"}
MODEL = BELOW_ROOMS | ROOMS | {"model/scene", "model/settings", "model/document", "model/io"}

# What each place may include besides itself.
MAY_INCLUDE = {
    "model/base": set(),
    "model/tree": {"model/base"},
    **{room: BELOW_ROOMS for room in ROOMS},
    # Profiles are lines in a plane, as lassos are.
    "model/strands": BELOW_ROOMS | {"model/shape", "model/envelope"},
    "model/mesh": BELOW_ROOMS | {"model/growth", "model/shape", "model/strands", "model/texture"},
    "model/scene": BELOW_ROOMS,
    # Settings of the user, and the look of the scene that is shown: views and panels share them.
    "model/settings": {"model/base", "model/scene"},
    "model/document": BELOW_ROOMS | ROOMS | {"model/scene"},
    # A project file reads and writes a document.
    "model/io": BELOW_ROOMS | ROOMS | {"model/scene", "model/document"},
    "commands": MODEL,
    "views": MODEL | {"commands"},
    "panels": MODEL | {"commands"},
    "app": MODEL | {"commands", "views", "panels"},
    "tests": MODEL | {"commands", "views", "panels", "app"},
}
TOP_FOLDERS = ["app", "commands", "model", "panels", "tests", "views"]

# QCoreApplication is not among them: plain code translates messages for the user by its translate().
QT_OBJECT_HEADER = re.compile(
    r"(QtCore/|QtGui/)?(QObject|QThread|QTimer|QGuiApplication|QUndo(Stack|Command|Group)|qobject\.h)$")
QT_WIDGET_HEADER = re.compile(
    r"(QtWidgets|QtOpenGL|QtOpenGLWidgets|QtSvgWidgets)(/|$)|Q(Widget|Application|Dialog|MainWindow|MessageBox|OpenGL\w*)$")
OBJECT_MACRO = re.compile(r"\b(Q_OBJECT|Q_GADGET|Q_NAMESPACE)\b")
INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)')
COMMENT_OR_STRING = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.DOTALL)


def place_of(path):
    """The layer or room of a path relative to the root, or None when it is in none."""
    parts = Path(path).parts
    if len(parts) < 2:
        return None
    place = "/".join(parts[:2]) if parts[0] == "model" else parts[0]
    return place if place in MAY_INCLUDE else None


def without_comments(text):
    """The text with comments blanked out, lines kept."""
    def blank(match):
        found = match.group(0)
        return found if found.startswith('"') else "\n" * found.count("\n")
    return COMMENT_OR_STRING.sub(blank, text)


def check_file(root, path):
    """Yields (line number, complaint) for one source file; path is relative to root."""
    place = place_of(path)
    if place is None:
        yield 1, "this folder belongs to no layer"
        return
    plain = place in ROOMS | BELOW_ROOMS
    for number, line in enumerate(without_comments((root / path).read_text(encoding="utf-8")).split("\n"), 1):
        if plain and OBJECT_MACRO.search(line):
            yield number, f"{place} knows no QObject"
        match = INCLUDE.match(line)
        if not match:
            continue
        quoted, angled = match.groups()
        name = quoted or angled
        if quoted and name == path.stem + ".moc":
            continue
        if quoted:
            if not (root / name).is_file() or ".." in Path(name).parts:
                yield number, f'"{name}" is not found from the root'
                continue
        elif place_of(name) and (root / name).is_file():
            yield number, f'<{name}> is our own and belongs in "quotes"'
        if plain and QT_OBJECT_HEADER.match(name):
            yield number, f"{place} knows no QObject: {name}"
        if place in MODEL and QT_WIDGET_HEADER.match(name):
            yield number, f"the model knows no widget and no OpenGL: {name}"
        if quoted:
            target = place_of(name)
            if target is None:
                yield number, f'"{name}" belongs to no layer'
            elif target != place and target not in MAY_INCLUDE[place]:
                yield number, f"{place} may not include {target}: {name}"


def own_includes(root, path):
    """Yields (line number, path relative to the root) for each file of ours that a source file includes."""
    for number, line in enumerate(without_comments((root / path).read_text(encoding="utf-8")).split("\n"), 1):
        match = INCLUDE.match(line)
        if match and match.group(1) and (root / match.group(1)).is_file():
            yield number, Path(match.group(1))


def include_graphs(root, paths):
    """The includes between units and between folders: {from: {to: "file:line" of one include}}."""
    units = {}
    folders = {}
    for path in paths:
        for number, target in own_includes(root, path):
            where = f"{path}:{number}"
            for graph, one, other in ((units, path.with_suffix(""), target.with_suffix("")),
                                      (folders, path.parent, target.parent)):
                if one != other:
                    graph.setdefault(one, {}).setdefault(other, where)
    return units, folders


def way_back(graph, start):
    """The shortest circle through start, as the list of its members, or None."""
    ways = [[start]]
    seen = set()
    for way in ways:
        for target in graph.get(way[-1], {}):
            if target == start:
                return way + [start]
            if target not in seen:
                seen.add(target)
                ways.append(way + [target])
    return None


def circles(graph, what):
    """Yields a complaint for each circle; members of a circle that was named already are skipped."""
    named = set()
    for start in sorted(graph):
        way = way_back(graph, start)
        if way is None or named & set(way):
            continue
        named |= set(way)
        steps = ", ".join(f"{one} by {graph[one][other]}" for one, other in zip(way, way[1:]))
        yield f"{what} include each other in a circle: {' -> '.join(map(str, way))} ({steps})"


def check(root):
    """All complaints about the sources below root, as lines of text."""
    paths = [path.relative_to(root) for folder in TOP_FOLDERS for path in sorted((root / folder).rglob("*"))
             if path.suffix in (".h", ".cpp") and path.is_file()]
    complaints = [f"{path}:{line}: {what}" for path in paths for line, what in check_file(root, path)]
    units, folders = include_graphs(root, paths)
    # A circle of units in several folders is a circle of folders as well: it is reported once.
    complaints += list(circles(units, "units")) or circles(folders, "folders")
    return complaints


# Files that exist in every case of the self-test, and cases: (path, text, part of the one complaint or None), where
# the path may be a dictionary of several files in place of one with its text.
SELF_TEST_HEADERS = [f"{place}/A.h" for place in MAY_INCLUDE]
SELF_TEST_CASES = [
    ("app/B.cpp", '#include "views/A.h"\n#include "panels/A.h"\n', None),
    ("commands/B.cpp", '#include "model/io/A.h"\n#include <QUndoCommand>\n', None),
    ("model/io/B.cpp", '#include "model/document/A.h"\n', None),
    ("model/mesh/B.cpp", '#include "model/growth/A.h"\n#include <QHash>\n', None),
    ("model/document/B.h", "#include <QObject>\nclass B : public QObject { Q_OBJECT };\n", None),
    ("model/tree/B.h", '// Q_OBJECT\n/*\n#include "app/A.h"\n*/\n', None),
    ("tests/B.cpp", '#include "app/A.h"\n#include "B.moc"\n', None),
    ("views/B.cpp", '#include "panels/A.h"\n', "views may not include panels"),
    ("panels/B.cpp", '#include "views/A.h"\n', "panels may not include views"),
    ("panels/B.cpp", '#include "app/A.h"\n', "panels may not include app"),
    ("commands/B.cpp", '#include "views/A.h"\n', "commands may not include views"),
    ("model/document/B.cpp", '#include "commands/A.h"\n', "model/document may not include commands"),
    ("model/document/B.cpp", '#include "model/io/A.h"\n', "model/document may not include model/io"),
    ("model/growth/B.cpp", '#include "model/mesh/A.h"\n', "model/growth may not include model/mesh"),
    ("model/picking/B.cpp", '#include "model/growth/A.h"\n', "model/picking may not include model/growth"),
    ("model/strands/B.cpp", '#include "model/document/A.h"\n', "model/strands may not include model/document"),
    ("model/tree/B.cpp", '#include "model/growth/A.h"\n', "model/tree may not include model/growth"),
    ("model/base/B.cpp", '#include "model/tree/A.h"\n', "model/base may not include model/tree"),
    ("app/B.cpp", '#include "tests/A.h"\n', "app may not include tests"),
    ("model/tree/B.cpp", '#include "A.h"\n', "not found from the root"),
    ("model/tree/B.cpp", '#include "../base/A.h"\n', "not found from the root"),
    ("model/tree/B.cpp", '# include "model/tree/Gone.h"\n', "not found from the root"),
    ("model/tree/B.cpp", "#include <model/tree/A.h>\n", "quotes"),
    ("model/shape/B.h", "#include <QObject>\n", "knows no QObject"),
    ("model/shape/B.h", "#include <QtCore/QObject>\n", "knows no QObject"),
    ("model/shape/B.h", "struct B { Q_OBJECT };\n", "knows no QObject"),
    ("model/base/B.h", "#include <QWidget>\n", "knows no widget"),
    ("model/document/B.h", "#include <QtWidgets/QDialog>\n", "knows no widget"),
    ("model/elsewhere/B.h", "\n", "belongs to no layer"),
    # A source belongs to its header; a second source of a class includes the header, and nothing includes that.
    ({"app/B.h": "\n", "app/B.cpp": '#include "app/B.h"\n', "app/BToo.cpp": '#include "app/B.h"\n'}, "", None),
    ({"app/B.h": '#include "app/C.h"\n', "app/C.h": '#include "app/D.h"\n', "app/D.h": ""}, "", None),
    ({"app/B.h": '#include "app/C.h"\n', "app/C.h": '#include "app/B.h"\n'}, "",
     "units include each other in a circle: app/B -> app/C -> app/B"),
    ({"app/B.h": "", "app/B.cpp": '#include "app/C.h"\n', "app/C.h": "", "app/C.cpp": '#include "app/B.h"\n'}, "",
     "units include each other in a circle: app/B -> app/C -> app/B"),
    ({"app/B.h": '#include "app/C.h"\n', "app/C.h": '#include "app/D.h"\n', "app/D.h": '#include "app/B.h"\n'}, "",
     "app/B -> app/C -> app/D -> app/B"),
    ({"app/B.h": '#include "app/files/B.h"\n', "app/files/B.h": "", "app/files/C.h": '#include "app/C.h"\n',
      "app/C.h": ""}, "", "folders include each other in a circle: app -> app/files -> app"),
    ({"views/x/B.h": '#include "views/y/B.h"\n', "views/y/B.h": "", "views/y/C.h": '#include "views/z/B.h"\n',
      "views/z/B.h": "", "views/z/C.h": '#include "views/x/D.h"\n', "views/x/D.h": ""}, "",
     "views/x -> views/y -> views/z -> views/x"),
    ({"views/B.h": '#include "views/x/B.h"\n', "views/x/B.h": "", "views/x/C.h": '#include "views/y/B.h"\n',
      "views/y/B.h": ""}, "", None),
]


def self_test():
    """Proves that each rule can fail, and that each permission holds."""
    wrong = 0
    for path, text, expected in SELF_TEST_CASES:
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            written = path if isinstance(path, dict) else {path: text}
            for name, content in [(header, "") for header in SELF_TEST_HEADERS] + list(written.items()):
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(content, encoding="utf-8")
            found = check(root)
        good = found == [] if expected is None else len(found) == 1 and expected in found[0]
        if not good:
            wrong += 1
            print(f"self-test: {path} with {text!r} should give {expected!r}, but gives {found}", file=sys.stderr)
    print(f"self-test: {len(SELF_TEST_CASES) - wrong} of {len(SELF_TEST_CASES)} cases right")
    return wrong == 0


def main(arguments):
    if arguments == ["--self-test"]:
        return 0 if self_test() else 1
    if arguments:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    complaints = check(Path(__file__).resolve().parent.parent)
    for complaint in complaints:
        print(complaint, file=sys.stderr)
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
