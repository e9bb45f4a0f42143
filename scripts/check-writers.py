#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that model/io/FileWriter is the only part of the program that opens a file for writing.

Elsewhere a full disk could empty a file without an error: QSaveFile, QFile and QImage::save keep what is written in a
buffer, and do not say that it could not be written in the end. Only the settings are written by Qt (see app/files/Settings.cpp).

Usage: check-writers.py [--self-test]
"""

import re
import sys
import tempfile
from pathlib import Path

TOP_FOLDERS = ["app", "commands", "model", "panels", "views", "tests/gallery", "tests/help"]
# The lock file of a safety copy holds nothing, and a log that is not whole does no harm.
WRITER = {"model/io/FileWriter.h", "model/io/FileWriter.cpp", "app/files/FileLock.cpp", "app/Log.cpp"}
REMEDY = "writeFile() or FileWriter (model/io/FileWriter.h) does this"

# Code that always writes a file.
ALWAYS = [
    (re.compile(r"\b(QSaveFile|QTemporaryFile)\b"), "{} writes a file"),
    (re.compile(r"\bstd::(?:basic_)?(ofstream|fstream)\b"), "std::{} writes a file"),
    (re.compile(r"\b(fopen|freopen|fdopen|mkstemp|creat|openat)\s*\("), "{} opens a file"),
    (re.compile(r"(?<![\w.>:])(::open)\s*\("), "{} opens a file"),
    (re.compile(r"\b(zip_open)\s*\("), "{} writes an archive"),
    (re.compile(r"\b(QFile::copy|filesystem::copy\w*)\s*\("), "{} writes a file"),
    (re.compile(r"(?:\.|->)(Export)\s*\("), "{} of Assimp writes files; ExportToBlob does not"),
]
WRITE_MODE = re.compile(r"(\w+)\s*(?:\.|->)\s*open\s*\([^;]*\b(?:WriteOnly|ReadWrite|Append|Truncate|NewOnly)\b")
BUFFER = r"\bQBuffer\s+(?:\w+\s*\(|)\s*{}\b|\bQBuffer\s*[*&]?\s*{}\b"
PICTURE = re.compile(r"\b(?:QImage|QPixmap|QPicture)\s*&?\s+(\w+)\b")
PICTURE_SAVE = re.compile(r"(\w+|\))\s*(?:\.|->)\s*save\s*\(\s*(?![&)])")
IMAGE_WRITER = re.compile(r"\bQImageWriter\s+\w+\s*\(\s*(?!&)|\bQImageWriter\s*\(\s*(?!&)")
FILE = re.compile(r"\bQFile\s*&?\s+(\w+)\b")
FILE_COPY = re.compile(r"(\w+)\s*(?:\.|->)\s*copy\s*\(")
COMMENT_OR_STRING = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.DOTALL)


def without_comments(text):
    """Text of the same lines without comments and without what strings hold."""
    def blank(match):
        found = match.group(0)
        return '""' if found.startswith('"') else "\n" * found.count("\n")
    return COMMENT_OR_STRING.sub(blank, text)


def is_buffer(text, name):
    return re.search(BUFFER.format(re.escape(name), re.escape(name)), text) is not None


def check_text(text):
    """Yields (line number, complaint) for the text of one source file."""
    text = without_comments(re.sub(r"^\s*#\s*include[^\n]*", "", text, flags=re.MULTILINE))
    line_of = lambda place: text.count("\n", 0, place) + 1
    for pattern, what in ALWAYS:
        for match in pattern.finditer(text):
            yield line_of(match.start()), what.format(match.group(1))
    for match in WRITE_MODE.finditer(text):
        if not is_buffer(text, match.group(1)):
            yield line_of(match.start()), f"{match.group(1)} is opened for writing"
    pictures = set(PICTURE.findall(text))
    for match in PICTURE_SAVE.finditer(text):
        if match.group(1) in pictures or match.group(1) == ")":
            yield line_of(match.start()), "a picture is saved to a file"
    for match in IMAGE_WRITER.finditer(text):
        yield line_of(match.start()), "QImageWriter writes a file"
    files = set(FILE.findall(text))
    for match in FILE_COPY.finditer(text):
        if match.group(1) in files:
            yield line_of(match.start()), f"{match.group(1)} is copied to a file"


def check(root):
    """All complaints about the sources below root, as lines of text."""
    complaints = []
    for folder in TOP_FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            relative = path.relative_to(root)
            if path.suffix in (".h", ".cpp") and path.is_file() and relative.as_posix() not in WRITER:
                found = check_text(path.read_text(encoding="utf-8"))
                complaints += [f"{relative}:{line}: {what}; {REMEDY}" for line, what in found]
    return complaints


# Cases: (text of a source, part of the one complaint or None).
SELF_TEST_CASES = [
    ("#include <QSaveFile>\n// QSaveFile file(name);\n", None),
    ("QFile file(name);\nfile.open(QIODevice::ReadOnly);\n", None),
    ("QByteArray b;\nQBuffer buffer(&b);\nbuffer.open(QIODevice::WriteOnly);\nimage.save(&buffer, \"png\");\n", None),
    ("QImage image;\nQBuffer buffer;\nimage.save(&buffer, \"png\");\n", None),
    ("m_files.save();\nm_file.save(fileName, m_thumbnail());\n", None),
    ("const QImage whole = grab();\nreturn whole.copy(middle);\n", None),
    ("QImageWriter(&buffer, \"png\").write(image);\n", None),
    ("zip_open_from_source(target, ZIP_TRUNCATE, &error);\nzip_fopen(archive, name, 0);\n", None),
    ("const char* text = \"std::ofstream\";\n", None),
    ("QSaveFile file(name);\n", "QSaveFile writes"),
    ("std::unique_ptr<QTemporaryFile> file;\n", "QTemporaryFile writes"),
    ("QFile file(name);\nif (!file.open(QIODevice::WriteOnly | QIODevice::Text))\n    return;\n", "opened for writing"),
    ("file->open(QIODevice::ReadWrite);\n", "opened for writing"),
    ("m_log.open(QFile::Append);\n", "opened for writing"),
    ("std::ofstream out(name);\n", "std::ofstream writes"),
    ("std::FILE* f = std::fopen(name, \"w\");\n", "fopen opens"),
    ("const int f = ::open(name, O_WRONLY);\n", "::open opens"),
    ("QImage image;\nimage.save(fileName);\n", "picture is saved"),
    ("void f(const QPixmap& pixmap) { pixmap.save(name, \"png\"); }\n", "picture is saved"),
    ("widget.grab().save(name);\n", "picture is saved"),
    ("QImageWriter writer(fileName);\n", "QImageWriter writes"),
    ("QFile::copy(a, b);\n", "QFile::copy writes"),
    ("QFile file(a);\nfile.copy(b);\n", "is copied"),
    ("exporter.Export(scene, \"obj\", path);\n", "ExportToBlob"),
    ("zip_open(path, ZIP_CREATE, &error);\n", "writes an archive"),
]


def self_test():
    """Proves that each rule can fail, and that each permission holds."""
    wrong = 0
    for text, expected in SELF_TEST_CASES:
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            for name in ("app/A.cpp", "model/io/FileWriter.cpp"):
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text, encoding="utf-8")
            found = check(root)
        good = found == [] if expected is None else len(found) == 1 and expected in found[0]
        if not good:
            wrong += 1
            print(f"self-test: {text!r} should give {expected!r}, but gives {found}", file=sys.stderr)
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
