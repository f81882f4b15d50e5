#!/usr/bin/env python3
# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the tables and plots of the benchmarks.

    plot_tables.py TABLES_DIRECTORY [OUTPUT_DIRECTORY [PICTURES_DIRECTORY]]

reads size_ladder.tsv, peers.tsv, hard_meshes.tsv and the tables in Markdown of the other programs, those that are
there, and writes benchmarks.md and pictures in SVG, by default beside them. Nothing but Python 3 is needed.
"""

import csv
import math
import os
import re
import sys

from svg_plot import write_plot


def read_table(path):
    """The rows as dictionaries, and the lines that start with # as lists."""
    if not os.path.exists(path):
        return [], []
    with open(path, encoding="utf-8", newline="") as file:
        lines = file.read().splitlines()
    notes = [line[1:].strip().split("\t") for line in lines if line.startswith("#")]
    rows = list(csv.DictReader((line for line in lines if not line.startswith("#")), delimiter="\t"))
    return rows, notes


def value(row, key):
    """A number; not a number where the program had none."""
    return float(row[key]) if row[key] else math.nan


def in_order(rows, key):
    """The different values of a column, as they come."""
    return list(dict.fromkeys(row[key] for row in rows))


def markdown(header, rows):
    out = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    out += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(out) + "\n"


def short(x, digits=3):
    return "-" if math.isnan(x) else f"{x:.{digits}g}"


def millions(x):
    return f"{x / 1e6:.3f}"


class Output:
    def __init__(self, directory, pictures):
        os.makedirs(directory, exist_ok=True)
        os.makedirs(pictures, exist_ok=True)
        self.directory, self.pictures, self.parts = directory, pictures, []

    def add(self, text):
        self.parts.append(text)

    def plot(self, name, title, *arguments, **options):
        path = os.path.join(self.pictures, f"benchmark_{name}.svg")
        if write_plot(path, title, *arguments, **options):
            self.add(f"![{title}]({os.path.relpath(path, self.directory).replace(os.sep, '/')})\n")

    def close(self):
        with open(os.path.join(self.directory, "benchmarks.md"), "w", encoding="utf-8") as file:
            file.write("\n".join(self.parts))


def write_ladder(out, rows, notes):
    """Growth with the size of the mesh."""
    exponents = {(n[1], n[2], n[3]): float(n[4]) for n in notes if n[0] == "exponent"}
    out.add("## Growth with the size of the mesh\n")
    out.add(
        "One smooth shape, a torus with waves, at many resolutions. Seconds contain the construction, the build and reading "
        "the distances of all vertices; bytes are the peak beyond the mesh itself.\n"
    )
    plain = [row for row in rows if row["levels"] == "0"]
    out.add(
        markdown(
            ["source", "vertices", "seconds", "bytes per vertex", "million windows", "windows per vertex", "ns per window"],
            [
                [
                    row["source"],
                    row["vertices"],
                    short(value(row, "seconds")),
                    f"{value(row, 'peak_bytes_a_vertex'):.0f}",
                    millions(value(row, "windows")),
                    f"{value(row, 'windows_a_vertex'):.1f}",
                    f"{value(row, 'ns_a_window'):.0f}",
                ]
                for source in in_order(plain, "source")
                for row in plain
                if row["source"] == source
            ],
        )
    )
    out.add("Exponents e of the curves c n^e that fit best, n being the number of vertices:\n")
    out.add(
        markdown(
            ["source", "levels", "seconds", "windows", "peak memory", "seconds of offsets"],
            [
                [source, levels]
                + [
                    short(exponents.get((source, levels, what), math.nan))
                    for what in ("seconds", "windows", "peak_bytes", "offset_seconds")
                ]
                for source in in_order(rows, "source")
                for levels in in_order(rows, "levels")
            ],
        )
    )
    out.add("Offsets at 1 and at 100 distances, whose curves are discarded as they come:\n")
    cut = [row for row in rows if row["levels"] != "0"]
    out.add(
        markdown(
            ["source", "levels", "vertices", "seconds", "propagation s", "offsets s", "pieces", "us per piece", "curves"],
            [
                [row["source"], row["levels"], row["vertices"]]
                + [short(value(row, k)) for k in ("seconds", "propagation_seconds", "offset_seconds")]
                + [row["pieces"], short(1e6 * value(row, "offset_seconds") / max(1, value(row, "pieces"))), row["curves"]]
                for source in in_order(cut, "source")
                for levels in in_order(cut, "levels")
                for row in cut
                if (row["source"], row["levels"]) == (source, levels)
            ],
        )
    )

    def series(key, levels, what=None):
        result = []
        for source in in_order(rows, "source"):
            points = [
                (value(row, "vertices"), value(row, key))
                for row in rows
                if row["source"] == source and row["levels"] == levels
            ]
            e = exponents.get((source, levels, what), math.nan)
            result.append((source if math.isnan(e) else f"{source}: n^{e:.2f}", points))
        return result

    n = "vertices n"
    out.plot("time", "Time of a build, and its growth", n, "seconds", series("seconds", "0", "seconds"))
    out.plot("windows", "Windows, and their growth", n, "windows propagated", series("windows", "0", "windows"))
    out.plot("time_of_window", "Time per window", n, "nanoseconds", series("ns_a_window", "0"))
    out.plot("memory", "Peak memory per vertex, beyond the mesh", n, "bytes", series("peak_bytes_a_vertex", "0"))
    offsets = [
        (f"{levels} level{'s' if levels != '1' else ''}, {label}", points)
        for levels in in_order(cut, "levels")
        for label, points in series("offset_seconds", levels, "offset_seconds")
    ]
    out.plot("offsets", "Time of cutting offsets, beside the propagation", n, "seconds", offsets)


def write_peers(out, rows):
    """Time, memory and error of other methods."""
    out.add("## Other methods\n")
    out.add(
        "In the same run, each in a process of its own. Errors are relative to our distances from the true source, over all "
        "vertices; unreached are the vertices that are at infinity with one of the two alone. What each method is given of "
        "a curve is said at the head of `peers.cpp`.\n"
    )
    columns = ["mesh", "vertices", "source", "method"]
    out.add(
        markdown(
            columns + ["seconds", "peak MB", "largest error", "mean error", "unreached"],
            [
                [row[c] for c in columns]
                + [short(value(row, "seconds")), short(value(row, "peak_mb"))]
                + [short(value(row, e), 2) for e in ("largest_error", "mean_error")]
                + [row["unreached"] or "-"]
                for row in rows
            ],
        )
    )
    least = 1e-16  # where ours, whose error is zero by definition, is drawn
    for source, name, title in (("vertex", "vertex", "a vertex"), ("curve", "curve", "a curve")):
        series = {}
        for row in rows:
            if row["source"] == source and not math.isnan(value(row, "seconds")):
                method = re.sub("tolerance .*", "within tolerances", row["method"])
                series.setdefault(method, []).append((value(row, "seconds"), max(value(row, "mean_error"), least)))
        out.plot(
            f"error_{name}",
            f"Mean error and time from {title}: one mark per mesh (and tolerance), exact ones at 1e-16",
            "seconds",
            "mean relative error",
            list(series.items()),
            lines=False,
        )


def write_hard_meshes(out, rows):
    """Robustness."""
    out.add("## Hard meshes\n")
    out.add(
        "Windows on flat meshes, needles, tiny faces and saddles. Outside are the vertices whose distances are off the "
        "certified bounds by more than 1e-12 of themselves; the excess is the largest such difference, relative to the "
        "distance and to the diagonal of the bounding box.\n"
    )
    header = ["mesh", "source", "vertices", "seconds", "windows", "per vertex", "seconds of bounds", "unreachable"]
    keys = ["mesh", "source", "vertices", "seconds", "windows", "windows_a_vertex", "bounds_seconds", "unreachable"]
    header += ["width", "outside", "excess", "of the size"]
    keys += ["width", "outside", "excess", "excess_of_size"]
    out.add(markdown(header, [[row[k] for k in keys] for row in rows]))


def write_markdown_of(out, path, title):
    """What a program has written as Markdown."""
    if os.path.exists(path):
        with open(path, encoding="utf-8") as file:
            out.add(f"## {title}\n\n{file.read()}")


def main(arguments):
    if not 1 <= len(arguments) <= 3 or arguments[0].startswith("-"):
        sys.stderr.write(__doc__)
        return 2
    tables = arguments[0]
    directory = arguments[1] if len(arguments) > 1 else tables
    out = Output(directory, arguments[2] if len(arguments) > 2 else directory)
    out.add("# Benchmarks {#geodesic_offset_benchmarks}\n")
    out.add("Written by `benchmark/Surface_mesh_geodesic_offset/run_benchmarks.sh`. Times depend on the machine.\n")
    ladder, notes = read_table(os.path.join(tables, "size_ladder.tsv"))
    if ladder:
        write_ladder(out, ladder, notes)
    peers, _ = read_table(os.path.join(tables, "peers.tsv"))
    if peers:
        write_peers(out, peers)
    hard, _ = read_table(os.path.join(tables, "hard_meshes.tsv"))
    if hard:
        write_hard_meshes(out, hard)
    write_markdown_of(out, os.path.join(tables, "flat_meshes.md"), "Flat meshes, against closed forms")
    write_markdown_of(out, os.path.join(tables, "scaling.md"), "Growth of time with the answer")
    write_markdown_of(out, os.path.join(tables, "window_counts.md"), "Windows and memory, against the lower envelope")
    write_markdown_of(out, os.path.join(tables, "point_source_against_smsp.md"), "One point, against SMSP")
    write_markdown_of(out, os.path.join(tables, "bounded_error.md"), "Windows within a tolerance")
    write_markdown_of(out, os.path.join(tables, "tolerance_offsets.md"), "Offsets within a tolerance")
    write_markdown_of(out, os.path.join(tables, "certified_bounds.md"), "Certified bounds")
    write_markdown_of(out, os.path.join(tables, "parallel.md"), "Several threads")
    out.close()
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
