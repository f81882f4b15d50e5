# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of the programs: no file name causes a loss of data, signals and full disks leave no partial files, time and memory of
large files, and the progress bar on a terminal."""

import math
import os
import pty
import re
import resource
import signal
import stat
import subprocess
import sys

from program_bench import check, check_close, read_ply, run_test, sphere, write_grid, write_off

ON_MESH = "mesh.off", "--source-vertex", 0, "--distance", 0.5, "--quiet"


def read(bench, name):
    with open(bench.path(name)) as file:
        return file.read()


def test_names(bench):
    """An output that is an input or another output, under any name; long names; links."""
    bench.write("in.obj", "v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n")
    bench.write("curve.polylines.txt", "2 0 0 0 1 1 0\n")
    bench.write("keep.vtk", "old")
    bench.write("table.txt", "0\n1\n1\n")
    for name, other in ("in.obj", "hard.obj"), ("curve.polylines.txt", "other.polylines.txt"), ("table.txt", "rows.txt"):
        os.link(bench.path(name), bench.path(other))
    for target, name in ("in.obj", "soft.obj"), (".", "folder"), ("circle.vtk", "circle.vtk"):
        os.symlink(target, bench.path(name))
    on_obj = "in.obj", "--source-vertex", 0, "--distance", 1
    for alias in "in.obj", "./in.obj", "folder/in.obj", "folder/folder/in.obj", "hard.obj", "soft.obj", "folder/soft.obj":
        bench.expect_error(2, ["'in.obj'", "twice"], *on_obj, "--output", alias)
    bench.expect_error(2, ["'curve.polylines.txt'", "other.polylines.txt"], "in.obj", "--source-polyline", "curve.polylines.txt",
                 "--distance", 1, "--output", "other.polylines.txt")
    for name in "keep.vtk", "new.vtk":
        for alias in "./" + name, "folder/" + name, "folder/./" + name:
            bench.expect_error(2, [name, alias], *on_obj, "--output", name, "--output", alias)
    bench.expect_error(2, ["twice"], "in.obj", "--source-vertex", 0, "--distances", "table.txt", "--per-vertex", "rows.txt",
                 program="validate_geodesic_distances")
    bench.expect_error(1, ["circle.vtk", "Too many levels of symbolic links"], *on_obj, "--output", "circle.vtk")

    for size in 252, 255:
        name = "n" * (size - 4) + ".vtk"
        result = bench.start(*on_obj, "--output", name)
        check(result.returncode == 0 and not result.stderr and "LINES" in read(bench, name), "%d bytes: %s" % (size, result.stderr))
    # a symbolic link remains; its target receives the offsets, with the permissions of a new file; also if it does not exist yet
    os.mkdir(bench.path("there"))
    bench.write("there/real.vtk", "old")
    for target, name in ("there/real.vtk", "link.vtk"), ("there/new.vtk", "dangling.vtk"), ("dangling.vtk", "second.vtk"):
        os.symlink(target, bench.path(name))
    check(bench.start(*on_obj, "--output", "link.vtk").returncode == 0 and os.path.islink(bench.path("link.vtk")), "a link remains")
    check("LINES" in read(bench, "there/real.vtk") and os.listdir(bench.path("there")) == ["real.vtk"], "the target of a link")
    check(stat.S_IMODE(os.stat(bench.path("there/real.vtk")).st_mode) & 0o700 == 0o600, "permissions of a new file")
    bench.expect_error(2, ["dangling.vtk", "second.vtk"], *on_obj, "--output", "dangling.vtk", "--output", "second.vtk")
    check(bench.start(*on_obj, "--output", "second.vtk").returncode == 0 and os.path.islink(bench.path("second.vtk"))
          and "LINES" in read(bench, "there/new.vtk"), "a link to a new file")


def test_signals(bench):
    write_off(bench.path("mesh.off"), *sphere(1))
    write_grid(bench.path("grid.off"), lambda p: (p[0], p[1], 0), n=150)
    before = bench.files()
    for number in signal.SIGINT, signal.SIGTERM, signal.SIGHUP:
        program = subprocess.Popen([bench.program, "grid.off", "--source-vertex", "0", "--spacing", "0.02", "--output", "out.vtk",
                                    "--output", "out.dxf"], cwd=bench.folder, stdout=subprocess.PIPE, universal_newlines=True,
                                   preexec_fn=lambda: signal.signal(number, signal.SIG_DFL))  # the caller may ignore it
        for line in program.stdout:
            if line.startswith("sources: 1"):
                program.send_signal(number)
                break
        program.communicate(timeout=120)
        check(program.returncode == 128 + number, "signal %d: exit code %d" % (number, program.returncode))
        check(bench.files() == before, "signal %d: files remain" % number)
    # as nohup does
    result = bench.start(*ON_MESH, "--spacing", 0.01, shell=("trap '' HUP INT; (sleep 0.1; kill -HUP $$; kill -INT $$) &", ""))
    check(result.returncode == 0, "ignored signals: " + result.stderr)


def test_limits(bench):
    """No room on the disk or in memory"""
    write_off(bench.path("mesh.off"), *sphere(1))
    many = "mesh.off", "--source-vertex", 0, "--spacing", 0.02
    for name in "out.vtk", "out.dxf", "out.obj", "out.polylines.txt":
        bench.expect_error(1, [name, "large"], *many, "--output", name, shell=("ulimit -f 4;", ""))
    bench.expect_error(1, ["f.ply", "large"], *ON_MESH, "--field", "f.ply", shell=("ulimit -f 1;", ""))
    bench.expect_error(1, ["s.ply", "large"], *ON_MESH, "--spacing", 0.1, "--split", "s.ply", shell=("ulimit -f 4;", ""))
    bench.write("good.txt", "\n".join(["0"] * 42))
    if os.path.exists("/dev/full"):
        bench.expect_error(1, ["standard output", "space"], *many, "--output", "out.vtk", shell=("", "> /dev/full"))
        bench.expect_error(1, ["standard output", "space"], "--help", shell=("", "> /dev/full"))
        bench.expect_error(1, ["standard output"], *many, "--output", "out.vtk", shell=("", "| true; exit 1"))
        bench.expect_error(1, [], "mesh.off", "--source-vertex", 0, "--distances", "good.txt", "--per-vertex", "rows.txt",
                     program="validate_geodesic_distances", shell=("", "> /dev/full"))
        os.symlink("/dev/full", bench.path("full.json"))
        bench.expect_error(1, ["full.json", "regular"], *ON_MESH, "--stats", "full.json")
    with open(bench.program, "rb") as file:  # does not run with a limit of the address space
        if b"__asan_init" in file.read():
            print("with AddressSanitizer: limits of the address space are left out")
            return
    if sys.platform == "linux":
        bench.write("large.off", "OFF\n")
        os.truncate(bench.path("large.off"), 3 << 30)  # a sparse file
        bench.expect_error(1, ["large.off", "needs at least 3.2 GB"], "large.off", "--source-vertex", 0, shell=("ulimit -v 2000000;", ""))
        bench.write("many.off", "OFF\n3 1000000 0\n0 0 0\n1 0 0\n0 1 0\n" + 1000000 * "3 0 1 2\n")
        bench.expect_error(1, ["many.off", "1000000 triangles", "needs at least"], "many.off", "--source-vertex", 0,
                     shell=("ulimit -v 220000;", ""))


def test_crowded(bench):
    """Reading takes no quadratic time where many faces share a vertex, or an edge."""
    n, most_seconds = 60000, 5  # a search around the vertex for each face takes 10 and more
    circle = [(math.cos(6.28 * i / n), math.sin(6.28 * i / n)) for i in range(n)]
    apex, flat = [(0, 0, 1)], [(x, y, 0) for x, y in circle]
    for name, points, faces in (("a cone", flat, [(0, i + 1, (i + 1) % n + 1) for i in range(n)]),
                                ("fans", [(x, y, z) for x, y in circle for z in (0, 1)], [(0, 2 * i + 1, 2 * i + 2) for i in range(n)]),
                                ("faces around an edge", flat, [(0, 1, i + 1) for i in range(1, n)])):
        write_off(bench.path("crowded.off"), apex + points, faces)
        start = resource.getrusage(resource.RUSAGE_CHILDREN)
        result = bench.start("crowded.off", "--source-vertex", 2, "--maximum-distance", 1e-9, "--quiet")
        end = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = end.ru_utime + end.ru_stime - start.ru_utime - start.ru_stime
        check(result.returncode == 0 and seconds < most_seconds, "%s: %g s, %s" % (name, seconds, result.stderr))


def test_fans(bench):
    """Paths pass through vertices that fans of faces share, open or closed. The field does not depend on the file of the surface,
    --quiet does not hide the warning, and the certified bounds of the other program hold."""
    s, infinity = math.sqrt(2), math.inf
    flat = "0 0 0\n1 0 0\n1 1 0\n2 1 0\n2 2 0\n"
    star = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n-1 0 0\n0 -1 0\n0 0 -1\n"
    first, second = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n", "3 0 4 5\n3 0 6 4\n3 0 5 6\n3 4 6 5\n"
    mixed = "3 0 4 5\n3 0 2 1\n3 4 6 5\n3 0 1 3\n3 0 6 4\n3 0 3 2\n3 1 2 3\n3 0 5 6\n"
    for name, mesh, source, shared, expected in (
            ("two open fans", "OFF\n5 2 0\n" + flat + "3 0 1 2\n3 2 3 4\n", 1, 2, [1, 0, 1, 2, 1 + s]),
            ("two open fans, one of them reversed", "OFF\n5 2 0\n" + flat + "3 0 1 2\n3 2 4 3\n", 1, 2, [1, 0, 1, 2, 1 + s]),
            ("two closed fans", "OFF\n7 8 0\n" + star + first + second, 1, 0, [1, 0, s, s, 2, 2, 2]),
            ("two closed fans, faces mixed", "OFF\n7 8 0\n" + star + mixed, 1, 0, [1, 0, s, s, 2, 2, 2]),
            ("an open and a closed fan", "OFF\n6 5 0\n" + star[:star.rindex("0 0 -1")] + first + "3 0 4 5\n", 4, 0, [1, 2, 2, 2, 0, s]),
            ("the source is shared", "OFF\n7 8 0\n" + star + first + second, 0, 0, [0, 1, 1, 1, 1, 1, 1]),
            # both fans at vertex 2 are connected, and the surface is cut between vertices 0 and 1
            ("an edge of three faces beside two fans", "OFF\n7 4 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 2 0\n1 2 0\n"
             "3 0 1 2\n3 1 0 3\n3 0 1 4\n3 2 6 5\n", 6, 2, None)):
        bench.write("shared.off", mesh)
        result = bench.start("shared.off", "--source-vertex", source, "--field", "f.ply", "--spacing", 0.3, "--output", "out.vtk", "--quiet")
        warning = r"warning: 'shared.off': 1 vertex is shared by fans.*vertex %d\)" % shared
        check(result.returncode == 0 and not result.stdout and re.search(warning, result.stderr)
              and result.stderr.count("\n") == (1 if expected else 2), "%s: %s" % (name, result.stderr))
        distances = [v["distance"] for v in read_ply(bench.path("f.ply"))["vertex"][1]]
        if expected is None:
            check(distances[2] < infinity and distances[0] < infinity and infinity in distances[3:5], "%s: %s" % (name, distances))
            continue
        for i, (actual, d) in enumerate(zip(distances, expected)):
            check_close(actual, d, 1e-14, "%s, vertex %d" % (name, i))
        check(len(distances) == len(expected), name + ": vertices")
        result = bench.start("shared.off", "--source-vertex", source, "--distances", "f.ply", program="validate_geodesic_distances")
        check(result.returncode == 0 and "shared by fans" in result.stderr, "%s: %s%s" % (name, result.stdout, result.stderr))


def on_terminal(bench, *arguments):
    """Exit code, output, and what a terminal as standard error receives."""
    ours, theirs = pty.openpty()
    with open(bench.path("output"), "w+") as output:
        program = subprocess.Popen([bench.program, *map(str, arguments)], cwd=bench.folder, stdin=subprocess.DEVNULL, stdout=output,
                                   stderr=theirs)
        os.close(theirs)
        shown = b""
        try:
            while block := os.read(ours, 4096):
                shown += block
        except OSError:  # the other side is closed
            pass
        os.close(ours)
        code = program.wait(timeout=120)
        output.seek(0)
        return code, output.read(), shown.decode()


def test_terminal(bench):
    """The progress bar"""
    write_grid(bench.path("grid.off"), lambda p: (p[0], p[1], 0), n=60)
    arguments = ("grid.off", "--source-vertex", 0, "--spacing", 10, "--output", "out.vtk", "--field", "out.ply", "--picture", "out.png")
    code, output, shown = on_terminal(bench, *arguments)
    check(code == 0 and "offsets: " in output and "\r" not in output, "exit code %d: %s" % (code, output))
    for step in "\rreading '", "\rdistances and offsets [", "#", " % ", "cut", "\rwriting '", "\rpicture [":
        check(step in shown, "%r is not in %r" % (step, shown))
    check(not shown[shown.rindex("\r", 0, -2):].strip("\r "), "the bar is erased at the end: %r" % shown[-100:])
    check(on_terminal(bench, *arguments, "--quiet") == (0, "", ""), "with --quiet")
    result = bench.start(*arguments)
    check(result.returncode == 0 and not result.stderr and "\r" not in result.stdout and len(result.stdout) > 100, "in a pipe")


if __name__ == "__main__":
    run_test(names=test_names, signals=test_signals, limits=test_limits, crowded=test_crowded, fans=test_fans, terminal=test_terminal)
