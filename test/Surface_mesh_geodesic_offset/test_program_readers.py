# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Readers of the programs: all variants of all formats give the same surface; damaged files give one line that names the file;
mutated files cause no fault:

    test_program_readers.py GEODESIC_OFFSET mutations|mutated [COUNT [SEED [READ_FILES]]]

The mutations are those of mutations.py, each with the next seed. READ_FILES is the program of fuzz/fuzz_readers.cpp. Files with faults
are left in the current folder.
"""

import collections
import os
import random
import re
import struct
import subprocess
import time

import sample_files
from mutations import mutations
from program_bench import check, read_ply, run_test


def test_variants(bench):
    """The same vertices, distances and faces, and no remarks; an .stl file has its own order of vertices."""
    fields, outputs = {}, {}
    field = bench.path("field.ply")

    def read(name, mesh):
        result = bench.start(mesh, "--source-point", "0,0,0", "--field", field)
        if check(result.returncode == 0 and not result.stderr, "%s: %s" % (name, result.stderr)):
            rows = [[tuple(row.values()) for row in read_ply(field)[element][1]] for element in ("vertex", "face")]
            check(rows == fields.setdefault(mesh.endswith(".stl"), rows), name + ": another surface")
        return re.sub(r" \(\d+\.\d+ s\)", "", result.stdout)

    for name, data in sample_files.meshes():
        mesh = bench.write("file" + os.path.splitext(name)[1], data)
        output = read(name, mesh)
        check(output == outputs.setdefault(mesh.endswith(".stl"), output), "%s: remarks: %s" % (name, output))
        if name in ("OFF BINARY.off", "binary STL.stl") or "PLY, faces first" in name:
            output = read(name + " and more", bench.write(os.path.basename(mesh), data + b"0 0 0\n"))
            check(re.search(r"\d bytes behind the last ", output), "bytes behind the announced elements: " + output)
    vertices, faces = fields[False]
    check(tuple(v[:3] for v in vertices) == sample_files.POINTS, "vertices: %s" % vertices)
    check(tuple(corners for (corners,) in faces) == sample_files.POLYGONS, "faces: %s" % faces)
    vertices, faces = fields[True]
    check([[vertices[i][:3] for i in corners] for (corners,) in faces]
          == [[sample_files.POINTS[i] for i in t] for t in sample_files.TRIANGLES], "triangles of an .stl file: %s" % faces)


def test_damaged(bench):
    """Noise, files that end early, and numbers of binary files out of range."""
    outputs = [word for e in (".polylines.txt", ".vtk", ".obj", ".dxf") for word in ("--output", "out" + e)]
    outputs += ["--field", "f.ply", "--stats", "s.json", "--distance", 0.5]

    def refuse(name, data, words=()):
        bench.write(name, data)
        if name.endswith(".polylines.txt"):
            bench.expect_error(1, ["'%s'" % name, *words], "mesh.off", "--source-polyline", name, *outputs)
        else:
            bench.expect_error(1, ["'%s'" % name, *words], name, "--source-vertex", 0, *outputs)

    generator = random.Random(1)
    samples = dict(sample_files.meshes())
    for name in "OFF.off", "OBJ.obj", "little endian PLY, coordinates of type float.ply", "STL.stl":
        data, bad = samples[name], "bad" + os.path.splitext(name)[1]
        for size in 7, 300, 20000:
            refuse(bad, generator.randbytes(size))
        if not name.startswith("PLY"):
            refuse(bad, data[:data.index(b"\n") + 1] + b"\1" + generator.randbytes(1000))
        for part in (0.003, 0.1, 0.5, 0.9) if name != "OBJ.obj" else ():  # parts of an .obj file are such files, too
            size = int(part * len(data))
            while size > 1 and (data[size - 1:size + 1].strip() != data[size - 1:size + 1]):
                size -= 1
            refuse(bad, data[:size])
    bench.write("mesh.off", samples["OFF.off"])
    refuse("bad.polylines.txt", b"7" + generator.randbytes(500))

    def number(data, at, value):
        return data[:at] + struct.pack(">i", value) + data[at + 4:]

    for keyword in "OFF", "STCN4nOFF":
        data = sample_files.off_binary(keyword)
        header = data.index(b"\n") + 1 + 4 * ("n" in keyword)
        faces = len(data) - sum(4 * (len(p) + 2) + (12 if "C" in keyword else 0) for p in sample_files.POLYGONS)
        for at, value, words in ((header, -1, ("vertices", "-1")), (header, 2147483647, ("of 2147483647 vertices",)),
                                 (header + 4, 2147483647, ("of 2147483647 faces",)), (faces, 2147483647, ("faces",)),
                                 (faces, -3, ("face 0", "-3")), (faces + 4, 5, ("face 0", "'5'", "5 vertices")),
                                 (faces + 4, -1, ("face 0", "'-1'"))):
            refuse("bad.off", number(data, at, value), words)
    data = sample_files.ply(">", "float", "int", "int")
    faces = data.index(b"end_header\n") + 11 + 5 * 12
    for at, value, words in ((faces, -1, ("face",)), (faces, 2147483647, ("face",)), (faces + 4, -1, ("face 0", "'-1'", "5 vertices")),
                             (faces + 4, 5, ("face 0", "'5'", "5 vertices")), (faces - 4, 0x7fc00000, ("vertex 4", "nan"))):
        refuse("bad.ply", number(data, at, value), words)
    for order in "", "<", ">":
        data = sample_files.ply(order, "float", "int", "int", True)
        for old, new in (b"element vertex 5", b"element vertex 99999999999"), (b"camera 1\n", b"camera 18446744073709551615\n"):
            check(old in data, "an element to be changed")
            refuse("bad.ply", data.replace(old, new))
    text, data = sample_files.stl(), sample_files.stl_binary(b"a pyramid")
    for old, new, words in ((b"vertex 4.0e+00", b"vertex four", ("line 6", "facet 0", "'four'")),
                            (b"vertex 0.0e+00 0.0e+00 0.0e+00", b"vertex 0 0", ("line 4", "facet 0", "three coordinates")),
                            (b"vertex 4.0e+00 5.0e+00 0.0e+00\n", b"", ("facet 0", "'vertex'")),
                            (b"endsolid a pyramid\n", b"", ("without endsolid", "6 facets")),
                            (b"facet", b"faced", ("line 2", "'facet' or 'endsolid'", "'faced'"))):
        refuse("bad.stl", text.replace(old, new, 1), words)
    refuse("bad.stl", data[:80] + b"\xff\xff\xff\xff" + data[84:], ("6 of 4294967295 facets",))
    refuse("bad.stl", data[:96] + b"\x00\x00\xc0\x7f" + data[100:], ("facet 0", "finite"))


def numbers(bench, *defaults):
    return [int(x) for x in (*bench.options, *defaults[len(bench.options):])][:len(defaults)]


def keep(name, data):
    with open(name, "wb") as file:
        file.write(data)


def read_files(bench, files):
    """Runs the readers with pairs of name and bytes. Returns for each whether it is accepted; files with faults are kept."""
    path = (*bench.options[2:], os.path.join(os.path.dirname(bench.program), "read_files_sanitized"))[0]
    records = [b"%d\n%c%s" % (len(data) + 1, sample_files.EXTENSIONS.index(sample_files.extension(name)), data) for name, data in files]
    result = subprocess.run([path], input=b"".join(records), stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    replies = result.stdout.decode().splitlines()
    for (name, data), reply in zip(files, replies + ["fault: the program ends: " + result.stderr.decode("latin-1")]):
        if not check(not reply.startswith("fault"), "%s: %s" % (name, reply)):
            keep(name, data)
    check(result.returncode == 0 and len(replies) == len(files), "exit code %d" % result.returncode)
    return [reply.startswith("accepted") for reply in replies]


def test_mutations(bench):
    """Samples, their beginnings, and mutations in the readers themselves"""
    samples = [*sample_files.meshes(), *sample_files.others()]
    check(all(read_files(bench, samples)), "a sample is rejected")
    for name, data in samples:
        more = "other elements of type int" in name  # the last one is redundant
        if more or "BINARY" in name or "binary STL" in name:
            parts = [("part_%d_of_%s" % (size, name), data[:size]) for size in range(len(data) - 4 * more)]
            check(not any(read_files(bench, parts)), "a beginning of %s is accepted" % name)
    count, seed = numbers(bench, 70000, 1000000)
    accepted = collections.Counter()
    for first in range(seed, seed + count, 10000):
        files = [("mutated_%d%s" % (i, e), data) for i, e, data in mutations(min(10000, seed + count - first), first)]
        accepted.update((sample_files.extension(name), is_good) for (name, _), is_good in zip(files, read_files(bench, files)))
    print(accepted)
    for extension in sample_files.EXTENSIONS if count >= 30000 else ():  # they reach all parts of the readers
        check(accepted[extension, True] > 100 and accepted[extension, False] > 1000, "mutations of " + extension)


def test_mutated(bench):
    """Meshes, polylines and curves in both programs: exit codes, and one error or none, within 5 seconds."""
    count, seed = numbers(bench, 250, 2000000)
    bench.write("mesh.off", sample_files.off("OFF"))
    bench.write("curves.polylines.txt", sample_files.CURVES)
    for i, extension, data in mutations(count, seed):
        if extension in (".txt", ".table.ply"):
            continue
        name = "mutated_%d%s" % (i, extension)
        bench.write(name, data)
        mesh, curves = ("mesh.off", name) if extension == ".polylines.txt" else (name, "curves.polylines.txt")
        sources = ("--source-polyline", name) if extension == ".polylines.txt" else ("--source-vertex", 0)
        for program, words in (("geodesic_offset", (mesh, *sources, "--distance", 0.5, "--quiet")),
                               ("validate_geodesic_offsets", (mesh, "--source-vertex", 0, "--distance", 3, "--curves", curves))):
            start = time.monotonic()
            result = bench.start(*words, program=program)
            lines = result.stderr.split("\n")
            accepted = result.returncode in ((0,) if program == "geodesic_offset" else (0, 3))
            errors = [line for line in lines[:-1] if not line.startswith(program + ": warning: ")]
            if not check((accepted or result.returncode in (1, 2)) and bool(result.stdout) == (accepted and program != "geodesic_offset")
                         and lines[-1] == "" and all(line.startswith(program + ": ") for line in lines[:-1])
                         and len(errors) == (0 if accepted else 1) and time.monotonic() - start < 5,
                         "%s, %s: exit code %d: %s" % (program, name, result.returncode, result.stderr)):
                keep(name, data)


if __name__ == "__main__":
    run_test(variants=test_variants, damaged=test_damaged, mutations=test_mutations, mutated=test_mutated)
