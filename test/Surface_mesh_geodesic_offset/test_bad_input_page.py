# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page bad_input.md: runs each of its cases, and compares exit code and message.

    test_bad_input_page.py GEODESIC_OFFSET VALIDATE_GEODESIC_DISTANCES VALIDATE_GEODESIC_OFFSETS PAGE [--update]

With --update the messages are written into the page, to be read before they are committed. The tables of the page have the
rows

    | `` arguments `` | code | `` message `` |                a command line
    | `` name `` | `` content `` | code | `` message `` |     a file, with the escapes of Python in its content
    | `` name `` | `` content `` |                            a file that other rows name; `-> file`: a symbolic link
"""

import os
import re
import shlex
import subprocess
import sys
import tempfile

CELL = r"`` ([^`|]*) ``"  # Doxygen ends a span with one backtick at a quotation mark
GIVEN = re.compile(r"^\| %s \| %s \|$" % (CELL, CELL))
COMMAND = re.compile(r"^\| %s \| (\d*) \| %s \|$" % (CELL, CELL))
FILE = re.compile(r"^\| %s \| %s \| (\d*) \| %s \|$" % (CELL, CELL, CELL))


def write(folder, name, content):
    if content.startswith("-> "):
        os.symlink(content[3:], os.path.join(folder, name))
        return
    with open(os.path.join(folder, name), "wb") as file:
        file.write(content.encode("latin-1").decode("unicode_escape").encode("latin-1"))


def run(programs, folder, command):
    """Exit code and message of a command, which leaves the files of the folder as they are."""
    def files():
        return {name: os.lstat(os.path.join(folder, name)).st_mtime_ns for name in os.listdir(folder)}
    before = files()
    words = shlex.split(command)
    result = subprocess.run([programs[words[0]]] + words[1:], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                            timeout=60, env=dict(os.environ, LC_ALL="C"))
    message = result.stderr.decode("utf-8", "backslashreplace")
    faults = []
    if files() != before:
        faults.append("files were changed")
    if message.count("\n") != 1 or not message.endswith("\n") or not message.startswith(words[0] + ": "):
        faults.append("not one line")
    if not all(c.isprintable() for c in message[:-1]):
        faults.append("characters that cannot be printed")
    if result.returncode not in (1, 2):
        faults.append("exit code %d" % result.returncode)
    return result.returncode, message.strip()[len(words[0]) + 2:], faults


def command_of_file(name):
    if name.endswith(".curves.polylines.txt"):
        return "validate_geodesic_offsets square.off --source-vertex 0 --distance 0.5 --curves " + name
    if name.endswith(".polylines.txt"):
        return "geodesic_offset mesh.off --source-polyline %s --distance 1 --quiet" % name
    if name.endswith((".txt", ".table.ply")):
        return "validate_geodesic_distances mesh.off --source-vertex 0 --distances " + name
    return "geodesic_offset %s --source-vertex 0 --distance 1 --quiet" % name


def main(geodesic_offset, validate_distances, validate_offsets, page, update=False):
    programs = {"geodesic_offset": os.path.abspath(geodesic_offset),
                "validate_geodesic_distances": os.path.abspath(validate_distances),
                "validate_geodesic_offsets": os.path.abspath(validate_offsets)}
    with open(page, encoding="utf-8") as file:
        lines = file.read().split("\n")
    failures = cases = 0
    with tempfile.TemporaryDirectory() as folder:
        for line in lines:
            given = GIVEN.match(line)
            if given:
                write(folder, *given.groups())
        for i, line in enumerate(lines):
            in_file, in_command = FILE.match(line), COMMAND.match(line)
            if in_file:
                name, content, code, message = in_file.groups()
                write(folder, name, content)
                found_code, found, faults = run(programs, folder, command_of_file(name))
                os.remove(os.path.join(folder, name))
                new = "| `` %s `` | `` %s `` | %d | `` %s `` |" % (name, content, found_code, found)
            elif in_command:
                arguments, code, message = in_command.groups()
                command = arguments if arguments.split()[0] in programs else "geodesic_offset " + arguments
                found_code, found, faults = run(programs, folder, command)
                new = "| `` %s `` | %d | `` %s `` |" % (arguments, found_code, found)
            else:
                if line.startswith("| ``") and not GIVEN.match(line):
                    print("%s:%d: a row in none of the forms of this test" % (os.path.basename(page), i + 1))
                    failures += 1
                continue
            cases += 1
            if "`" in found or "|" in found:
                faults.append("the message cannot be in a table")
            if update:
                lines[i] = new
            elif (code, message) != (str(found_code), found):
                faults.append("the page says %s '%s', the program %d '%s'" % (code, message, found_code, found))
            for fault in faults:
                print("%s:%d: %s: %s" % (os.path.basename(page), i + 1, line.split("|")[1].strip(), fault))
            failures += bool(faults)
    if update:
        with open(page, "w", encoding="utf-8") as file:
            file.write("\n".join(lines))
    print("test_bad_input_page: %d cases, %d failures" % (cases, failures))
    return 1 if failures or cases < 300 else 0


if __name__ == "__main__":
    if len(sys.argv) not in (5, 6):
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:5], update=sys.argv[5:] == ["--update"]))
