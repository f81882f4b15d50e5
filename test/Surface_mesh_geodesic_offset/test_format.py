# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests that clang-format changes no source file. Lists the files that it changes with their numbers of changed lines.

    test_format.py PROJECT_FOLDER

The exit code is 77, for "skipped", without clang-format of VERSION: other versions break some lines elsewhere.
"""

import difflib
import os
import shutil
import subprocess
import sys

VERSION = 14  # of Debian 12
FOLDERS = ("include", "test", "examples", "benchmark")


def changed_lines(text, formatted):
    """Lines of the text that the formatter changes or removes, or behind which it adds lines."""
    matcher = difflib.SequenceMatcher(None, text.splitlines(), formatted.splitlines(), autojunk=False)
    return sum(max(i2 - i1, 1) for tag, i1, i2, _, _ in matcher.get_opcodes() if tag != "equal")


def main():
    root = sys.argv[1]
    program = shutil.which("clang-format-%d" % VERSION) or shutil.which("clang-format")
    if program is None or " version %d." % VERSION not in subprocess.run([program, "--version"], stdout=subprocess.PIPE, check=True).stdout.decode():
        print("skipped: clang-format %d is not installed" % VERSION)
        return 77
    total = files = 0
    for top in FOLDERS:
        lines = changed = 0
        for folder, _, names in sorted(os.walk(os.path.join(root, top))):
            for name in sorted(names):
                if not name.endswith((".h", ".cpp")):
                    continue
                path = os.path.join(folder, name)
                with open(path, encoding="utf-8") as file:
                    text = file.read()
                formatted = subprocess.run([program, "--style=file", path], stdout=subprocess.PIPE, check=True).stdout.decode()
                number = changed_lines(text, formatted)
                files += number > 0
                lines += text.count("\n")
                changed += number
                if number:
                    print("%6d  %s" % (number, os.path.relpath(path, root)))
        print("%6d of %d lines in %s" % (changed, lines, top))
        total += changed
    print("%6d lines in %d files" % (total, files))
    return 1 if total else 0


if __name__ == "__main__":
    sys.exit(main())
