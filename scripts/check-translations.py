#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that every text of the program is translated into every language.

Usage: check-translations.py LUPDATE

Reads the sources by Qt's own lupdate, and reports what a translation lacks: texts that are missing, empty or unfinished, and such
whose placeholders (%1, %L2, …) are not those of the source. What the sources no longer have counts for nothing.
"""

import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
LAYERS = ["app", "commands", "model", "panels", "views"]
PLACEHOLDER = re.compile(r"%L?\d|%n")


def messages(file):
    """Each (context, source, comment) of a .ts file with its translation, None where that is unfinished."""
    result = {}
    for context in ElementTree.parse(file).getroot().iter("context"):
        for message in context.iter("message"):
            translation = message.find("translation")
            kind = translation.get("type")
            if kind in ("vanished", "obsolete"):
                continue
            key = (context.findtext("name"), message.findtext("source"), message.findtext("comment", ""))
            # The texts of a plural are in its forms.
            forms = [form.text or "" for form in translation.iter("numerusform")]
            result[key] = None if kind == "unfinished" else forms[0] if forms else translation.text
    return result


def sources(lupdate):
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "sources.ts"
        subprocess.run([lupdate, "-silent", "-source-language", "en", "-target-language", "de", "-I", ".", *LAYERS,
                        "-ts", str(file)], cwd=ROOT, check=True, stderr=subprocess.DEVNULL)
        return messages(file)


def faults(translation, wanted):
    for key in wanted:
        context, source, _ = key
        text = translation.get(key)
        if not text:
            yield f"{context}: “{source}” is not translated"
        elif Counter(PLACEHOLDER.findall(source)) != Counter(PLACEHOLDER.findall(text)):
            yield f"{context}: “{text}” has other placeholders than “{source}”"


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    wanted = sources(sys.argv[1])
    if len(wanted) < 100:
        sys.exit(f"check-translations: only {len(wanted)} texts were found in the sources")
    found = 0
    for file in sorted((ROOT / "translations").glob("*.ts")):
        for fault in faults(messages(file), wanted):
            print(f"{file.name}: {fault}")
            found += 1
    print(f"check-translations: {found} faults in {len(wanted)} texts")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
