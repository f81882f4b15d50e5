# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests that clang-format changes no source file. Lists the files that it changes with their numbers of changed places.

    test_format.py PROJECT_FOLDER

The exit code is 77, for "skipped", without clang-format of VERSION: other versions break some lines elsewhere.
"""

import collections
import os
import re
import shutil
import subprocess
import sys

VERSION = 14  # of Debian 12
FOLDERS = ("include", "test", "examples", "benchmark")


def source_files(root):
    for top in FOLDERS:
        for folder, _, names in sorted(os.walk(os.path.join(root, top))):
            for name in sorted(names):
                if name.endswith((".h", ".cpp")):
                    yield os.path.relpath(os.path.join(folder, name), root)


def main():
    root = sys.argv[1]
    program = shutil.which("clang-format-%d" % VERSION) or shutil.which("clang-format")
    if program is None or " version %d." % VERSION not in subprocess.run([program, "--version"], stdout=subprocess.PIPE, check=True).stdout.decode():
        print("skipped: clang-format %d is not installed" % VERSION)
        return 77
    files = list(source_files(root))
    # one process for all files: its start takes longer than a file
    run = subprocess.run([program, "--style=file", "--dry-run", "--ferror-limit=0"] + files, cwd=root, stderr=subprocess.PIPE, check=True)
    places = collections.Counter(re.findall(r"^(.+?):\d+:\d+: \w+: code should be clang-formatted", run.stderr.decode(), re.MULTILINE))
    for file in files:
        if places[file]:
            print("%6d  %s" % (places[file], file))
    print("%6d places in %d of %d files" % (sum(places.values()), len(places), len(files)))
    return 1 if places or not files else 0


if __name__ == "__main__":
    sys.exit(main())
