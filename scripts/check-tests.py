#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that no test has vanished: ctest knows exactly the tests of tests/tests.txt, and no test can be skipped.

Usage: check-tests.py CTEST BUILD_FOLDER
       check-tests.py --self-test
"""

import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
LIST = "tests/tests.txt"
# Words that leave out a test, or a part of it, while the rest passes.
SKIPS = {
    "*.cpp": re.compile(r"\b(QSKIP|QEXPECT_FAIL)\b"),
    "*.h": re.compile(r"\b(QSKIP|QEXPECT_FAIL)\b"),
    "*.py": re.compile(r"\b(skipTest|skipIf|skipUnless|expectedFailure)\b"),
    "CMakeLists.txt": re.compile(r"\b(SKIP_RETURN_CODE|SKIP_REGULAR_EXPRESSION|DISABLED|WILL_FAIL)\b"),
}


def listed(file):
    """The names in the list, one to a line; lines that begin with # are comments."""
    lines = [line.strip() for line in file.read_text(encoding="utf-8").splitlines()]
    return [line for line in lines if line and not line.startswith("#")]


def registered(ctest, build):
    """The names that ctest knows. It is asked in another folder, since it would empty the log of the tests that are running."""
    with tempfile.TemporaryDirectory() as folder:
        tests = Path(build).resolve().as_posix()
        (Path(folder) / "CTestTestfile.cmake").write_text(f"subdirs([=[{tests}]=])\n", encoding="utf-8")
        result = subprocess.run([ctest, "--test-dir", folder, "--show-only=json-v1"], check=True, capture_output=True)
    return [test["name"] for test in json.loads(result.stdout)["tests"]]


def name_faults(wanted, known):
    for name in sorted({name for name in wanted if wanted.count(name) > 1}):
        yield f"{LIST} names {name} twice"
    for name in sorted(set(wanted) - set(known)):
        yield f"{name} is in {LIST}, and ctest does not know it: it would be left out"
    for name in sorted(set(known) - set(wanted)):
        yield f"{name} is not in {LIST}: add a line"


def skip_faults(folder):
    for pattern, words in SKIPS.items():
        for file in sorted(folder.rglob(pattern)):
            for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
                if match := words.search(line):
                    yield (f"{file}:{number}: {match.group(0)} lets a test pass that did not run; "
                           "let it fail, and say what is missing")


def self_test():
    assert list(name_faults(["a", "b"], ["b", "a"])) == []
    assert len(list(name_faults(["a", "b"], ["b"]))) == 1
    assert len(list(name_faults(["a"], ["b", "a"]))) == 1
    assert len(list(name_faults(["a", "a"], ["a"]))) == 1
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "tests.txt").write_text("# comment\na\n\nb\n", encoding="utf-8")
        assert listed(folder / "tests.txt") == ["a", "b"]
        (folder / "Good.cpp").write_text("QVERIFY(true);\n", encoding="utf-8")
        assert list(skip_faults(folder)) == []
        (folder / "Bad.cpp").write_text('QSKIP("no display");\n', encoding="utf-8")
        (folder / "CMakeLists.txt").write_text("set_tests_properties(a PROPERTIES SKIP_RETURN_CODE 77)\n", encoding="utf-8")
        assert len(list(skip_faults(folder))) == 2
    print("check-tests: the checks find what they look for")


def main():
    if sys.argv[1:] == ["--self-test"]:
        self_test()
        return
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    wanted = listed(ROOT / LIST)
    faults = [*name_faults(wanted, registered(*sys.argv[1:])), *skip_faults(ROOT / "tests")]
    print("\n".join(faults) or f"check-tests: all {len(wanted)} tests are there")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
