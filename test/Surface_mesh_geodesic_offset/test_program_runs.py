# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of the programs: exit codes, messages, and conditions on what they write, from the page bad_input.md and from
data/program_runs.txt.

    test_program_runs.py GEODESIC_OFFSET FILE [--update]

The other programs are in the folder of GEODESIC_OFFSET. With --update the messages are written into the file, in loops those of the
first words, to be read before they are committed. The tables of a page (.md) have the rows

    | `` arguments `` | code | `` message `` |                a command line
    | `` name `` | `` content `` | code | `` message `` |     a file, with the escapes of Python in its content
    | `` name `` | `` content `` |                            a file that other rows name; `-> file`: a symbolic link

Other files have blocks of lines, divided by empty lines:

    # comment
    for NAME in WORD...     the block is run with each word, quoted as for a shell, in place of the name
    file NAME CONTENT       a file that remains; `<N name`: the first N bytes of another file
    $ ARGUMENTS | [CODE] MESSAGE       a command line, exit code and error; without them the run succeeds. Without the name of a
                                       program, it is geodesic_offset
    @ NAME CONTENT | [CODE] MESSAGE    a file, and the command line that reads it
    ! MESSAGE               another line on standard error: a warning
    > TEXT                  a part of a line of the output
    ? CONDITION             in Python, with the names of `conditions()`
    = NAME EXPRESSION       for conditions that follow

In messages and texts, `...` stands for any text. In command lines, OUTPUTS is a file of each kind. Each run has exactly the given
lines on standard error, with the name of the program in front, and none that cannot be printed; a failed run leaves all files of
the folder as they are, and writes no others unless a condition is `new == ...`. A run with warnings is repeated with --quiet,
which suppresses everything else.
"""

import itertools
import json
import math
import os
import re
import shlex
import subprocess
import sys
import tempfile

from program_bench import cube, read_ply, sphere, torus, write_grid, write_off

CELL = r"`` ([^`|]*) ``"  # Doxygen ends a span with one backtick at a quotation mark
GIVEN = re.compile(r"^\| %s \| %s \|$" % (CELL, CELL))
COMMAND = re.compile(r"^\| %s \| (\d*) \| %s \|$" % (CELL, CELL))
FILE = re.compile(r"^\| %s \| %s \| (\d*) \| %s \|$" % (CELL, CELL, CELL))
ROW = re.compile(r"(.*?)(?: \| (\[-?\d+\].*))?$")
OUTPUTS = "--output out.polylines.txt --output out.vtk --output out.obj --output out.dxf --field field.ply --picture out.png"
LEAST_CASES = 300  # of each file


def command_of_file(name):
    if name.endswith(".curves.polylines.txt"):
        return "validate_geodesic_offsets square.off --source-vertex 0 --distance 0.5 --curves " + name
    if name.endswith(".polylines.txt"):
        return "mesh.off --source-polyline %s --distance 1 --quiet OUTPUTS" % name
    if name.endswith((".txt", ".table.ply")):
        return "validate_geodesic_distances mesh.off --source-vertex 0 --per-vertex rows.txt --distances " + name
    return "%s --source-vertex 0 --distance 1 --quiet OUTPUTS" % name


class Runs:
    def __init__(self, program, folder):
        self.programs = {name: os.path.join(os.path.dirname(os.path.abspath(program)), name) for name in
                         ("geodesic_offset", "geodesic_distance_matrix", "validate_geodesic_distances", "validate_geodesic_offsets")}
        self.folder, self.cases, self.names = folder, 0, {}

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, content):
        if content.startswith("-> "):
            os.symlink(content[3:], self.path(name))
            return
        part = re.match(r"<(\d+) (\S+)$", content)
        data = self.read(part[2])[:int(part[1])] if part else content.encode("latin-1").decode("unicode_escape")
        os.makedirs(os.path.dirname(self.path(name)), exist_ok=True)
        with open(self.path(name), "wb") as file:
            file.write(data.encode("latin-1"))

    def read(self, name):
        with open(self.path(name), encoding="latin-1", newline="") as file:
            return file.read()

    def files(self):
        return {name: os.lstat(self.path(name)).st_mtime_ns for name in os.listdir(self.folder)}

    def run(self, command, *options):
        """Exit code, output, lines on standard error, new files, and faults."""
        words = shlex.split(command.replace("OUTPUTS", OUTPUTS))
        if not words or words[0] not in self.programs:
            words.insert(0, "geodesic_offset")
        before = self.files()
        result = subprocess.run([self.programs[words[0]], *words[1:], *options], cwd=self.folder, stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=120, env=dict(os.environ, LC_ALL="C"))
        output, errors = (stream.decode("utf-8", "backslashreplace") for stream in (result.stdout, result.stderr))
        lines, faults, prefix = errors.split("\n"), [], words[0] + ": "
        if lines.pop() or not all(line.startswith(prefix) and line.isprintable() for line in lines):
            faults.append("lines on standard error: " + repr(errors))
        lines = [line[len(prefix):] for line in lines]
        after = self.files()
        if any(after.get(name) != time for name, time in before.items()):
            faults.append("files were changed")
        if result.returncode in (1, 2):
            if [line.startswith("warning: ") for line in lines] != [True] * (len(lines) - 1) + [False]:
                faults.append("not one error: %s" % lines)
            if words[0] != "geodesic_offset" and output:
                faults.append("output before an error: " + output)
        return result.returncode, output, lines, set(after) - set(before), faults

    def remove(self, names):
        for name in names:
            os.remove(self.path(name))

    def page(self, lines, report):
        for line in lines:
            given = GIVEN.match(line)
            if given:
                self.write(*given.groups())
        for i, line in enumerate(lines):
            in_file, in_command = FILE.match(line), COMMAND.match(line)
            if in_file:
                name, content = in_file.groups()[:2]
                self.write(name, content)
                messages, faults = self.block_run(command_of_file(name), [])
                self.remove([name])
            elif in_command:
                messages, faults = self.block_run(in_command[1], [])
            else:
                if line.startswith("| ``") and not GIVEN.match(line):
                    report(i, ["a row in none of the forms of this test"])
                continue
            result = re.match(r"\[([12])\] ([^`|]+)$", messages[0]) if len(messages) == 1 else None
            if result is None:
                faults.append("the program gives %s, which cannot be in this table" % messages)
            elif report.update:
                lines[i] = re.sub(r"\| \d* \| `` [^`]* `` \|$", lambda _: "| %s | `` %s `` |" % result.groups(), line)
            elif result.groups() != (in_file or in_command).groups()[-2:]:
                faults.append("the program gives %s" % messages)
            report(i, faults)

    def conditions(self, output, messages, new):
        """The names of conditions."""
        stats = json.loads(self.read("stats.json")) if "stats.json" in new else {}
        curves = [level for level in stats.get("curves", []) if level["number"] > 0]
        return dict(self.names, out=output, messages=messages, stats=stats, new=new, text=self.read, math=math, re=re,
                    near=lambda a, b, tolerance=1e-9: abs(a - b) <= tolerance,
                    levels=[level["distance"] for level in curves], length=sum(level["length"] for level in curves),
                    field=lambda name="field.ply": [v["distance"] for v in read_ply(self.path(name))["vertex"][1]])

    def block_run(self, command, expected):
        """Exit code and error, warnings, and faults of the other expectations."""
        self.cases += 1
        needs_stats = "--stats" not in command and any(line[0] in "?=" and re.search(r"\b(stats|levels|length)\b", line) for line in expected)
        options = ["--stats", "stats.json"] if needs_stats else []
        code, output, messages, new, faults = self.run(command, *options)
        names = self.conditions(output, messages, new)
        for line in expected:
            if line[0] == ">" and not any(matches(line[2:], text) for text in output.split("\n")):
                faults.append("'%s' is in no line of: %s" % (line[2:], output))
            try:
                if line[0] == "=":
                    name, _, expression = line[2:].partition(" ")
                    self.names[name] = names[name] = eval(expression, names)
                if line[0] == "?" and not eval(line[2:], names):
                    raise ValueError({word: names[word] for word in re.findall(r"\w+", line)
                                      if isinstance(names.get(word), (int, float, str, list, dict, set))})
            except Exception as error:
                faults.append("%s: %s" % (line[2:], error))
        if code != 0 and new and not any(line.startswith("? new ==") for line in expected):
            faults.append("new files %s" % new)
        self.remove(new)
        if code == 0 and messages and "--quiet" not in command and "validate" not in command:
            _, output, repeated, new, _ = self.run(command, *options, "--quiet")
            if output or repeated != messages:
                faults.append("with --quiet: %s, %s" % (output, repeated))
            self.remove(new)
        warnings = ["! " + message for message in messages]
        if code != 0:
            warnings.insert(0, "[%d] %s" % (code, warnings.pop()[2:]) if code in (1, 2) and messages else "[%d]" % code)
        return warnings, faults

    def block(self, first, lines, report):
        """Runs a block, and returns its lines with the messages of the first words of its loops."""
        loops = [re.match(r"for ([A-Z]+) in (.*)$", line).groups() for line in lines if line.startswith("for ")]
        rows = [i for i, line in enumerate(lines) if line[0] in "$@"] + [len(lines)]
        for i, line in enumerate(lines):
            if not line.startswith(("for ", "file ", "#") if i < rows[0] else ("$", "@ ", "! ", "> ", "? ", "= ", "#")):
                report(first + i, ["a line in none of the forms of this test"])
        result = None
        for words in itertools.product(*(shlex.split(words) for _, words in loops)):
            instance = lines
            for (name, _), word in zip(loops, words):
                instance = [line if line.startswith("for ") else line.replace(name, word) for line in instance]
            new = lines[:rows[0]]
            for line in instance[:rows[0]]:
                if line.startswith("file "):
                    _, name, content = line.split(" ", 2)
                    self.write(name, content)
            for i, end in zip(rows, rows[1:]):
                row, error = ROW.match(instance[i]).groups()
                command, expected = row[2:], instance[i + 1:end]
                if instance[i][0] == "@":
                    name, _, content = command.partition(" ")
                    self.write(name, content)
                    command = command_of_file(name)
                messages, faults = self.block_run(command, expected)
                if instance[i][0] == "@":
                    self.remove([name])
                wanted = ([error] if error else []) + [line for line in expected if line[0] == "!"]
                is_same = len(wanted) == len(messages) and all(map(matches_all, wanted, messages))
                if not is_same and not report.update:
                    faults.append("the program gives %s" % messages)
                if is_same or result is not None:
                    new += lines[i:end]
                else:
                    errors = "".join(" | " + line for line in messages if line[0] == "[")
                    new += [ROW.match(lines[i])[1] + errors, *(line for line in messages if line[0] == "!"),
                            *(line for line in lines[i + 1:end] if line[0] != "!")]
                report(first + i, faults)
            result = result or new
        return result or lines

    def blocks(self, lines, report):
        write_off(self.path("sphere.off"), *sphere(1))
        write_off(self.path("cube.off"), *cube(2, 1))
        write_off(self.path("torus.off"), *torus(24, 12))
        write_grid(self.path("grid.off"), lambda p: (p[0], p[1], 0), n=40)
        for n in 299, 401, 2001:
            points = ["%f %f 0\n" % (100 * math.cos(2 * math.pi * i / n), 100 * math.sin(2 * math.pi * i / n)) for i in range(n)]
            star = " ".join(str(2 * i % n) for i in range(n))
            self.write("star%d.off" % n, "OFF\\n%d 1 0\\n%s%d %s\\n" % (n, "".join(points), n, star))
        result, block = [], []
        for i, line in enumerate(lines + [""]):
            if line:
                block.append(line)
                continue
            result += self.block(i - len(block), block, report) if any(row[0] in "$@f" for row in block) else block
            result.append(line)
            block = []
        lines[:] = result[:-1]


def matches(pattern, text, whole=False):
    expression = re.escape(pattern).replace(r"\.\.\.", ".*")
    return bool((re.fullmatch if whole else re.search)(expression, text))


def matches_all(pattern, text):
    return matches(pattern, text, True)


class Faults:
    def __init__(self, name, update):
        self.name, self.update, self.failures = name, update, 0

    def __call__(self, line, faults):
        for fault in faults:
            print("%s:%d: %s" % (self.name, line + 1, fault))
        self.failures += bool(faults)


def main(program, source, update=False):
    with open(source, encoding="utf-8") as file:
        lines = file.read().split("\n")
    report = Faults(os.path.basename(source), update)
    with tempfile.TemporaryDirectory() as folder:
        runs = Runs(program, folder)
        (runs.page if source.endswith(".md") else runs.blocks)(lines, report)
    if update:
        with open(source, "w", encoding="utf-8") as file:
            file.write("\n".join(lines))
    print("%s: %d cases, %d failures" % (report.name, runs.cases, report.failures))
    return 1 if report.failures or runs.cases < LEAST_CASES else 0


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:3], update=sys.argv[3:] == ["--update"]))
