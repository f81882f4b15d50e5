# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Distance matrices of the program geodesic_distance_matrix: values, runs that are killed and resumed, and mpirun."""

import array
import csv
import math
import os
import shutil
import signal
import subprocess
import time

from program_bench import check, check_close, run_test, skip, torus, write_off

PROGRAM = "geodesic_distance_matrix"
# mpirun of Open MPI: more processes than processors, also as root
ENVIRONMENT = dict(os.environ, LC_ALL="C", OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")


def read_npy(path):
    """The rows of an .npy file of version 1.0."""
    with open(path, "rb") as file:
        data = file.read()
    start = 10 + data[8] + 256 * data[9]
    check(data[:8] == b"\x93NUMPY\x01\x00" and start % 64 == 0 and data[start - 1:start] == b"\n", "header of an .npy file")
    header = eval(data[10:start], {})  # pylint: disable=eval-used
    check(header["descr"] == "<f8" and header["fortran_order"] is False, "type of an .npy file")
    rows, columns = header["shape"]
    numbers = array.array("d", data[start:])
    check(len(numbers) == rows * columns, "size of an .npy file")
    return [numbers[i * columns:(i + 1) * columns] for i in range(rows)]


def complete_rows(path):
    return [i for i, row in enumerate(read_npy(path)) if not any(map(math.isnan, row))] if os.path.exists(path) else []


def contents(path):
    with open(path, "rb") as file:
        return file.read()


def mesh_file(bench, n, m):
    points, faces = torus(n, m)
    write_off(bench.path("torus.off"), points, faces)
    return bench.path("torus.off")


def matrix(bench, *arguments):
    result = bench.start(*arguments, program=PROGRAM)
    check(result.returncode == 0 and not result.stderr, "%s: %s" % (arguments, result.stderr))
    return result.stdout


def test_values(bench):
    mesh = mesh_file(bench, 12, 7)
    output, table, field = bench.path("m.npy"), bench.path("m.csv"), bench.path("field.csv")
    matrix(bench, mesh, "--sources", "all", "--output", output)
    rows = read_npy(output)
    check(len(rows) == len(rows[0]) == 84, "all of all")
    for v in range(0, 84, 5):
        bench.run(mesh, "--source-vertex", v, "--threads", 1, "--field", field)
        with open(field, newline="") as file:
            expected = [float(row["distance"]) for row in csv.DictReader(file)]
        check(max(abs(a - b) for a, b in zip(rows[v], expected)) <= 1e-13, "row %d and the field of its source" % v)
    check(max(abs(rows[i][j] - rows[j][i]) for i in range(84) for j in range(84)) <= 1e-12, "symmetry")

    # sources and targets in files, a cutoff, and the other format
    sources, targets = bench.write("sources.txt", "3 # one\n 80\n41 3\n"), bench.write("targets.txt", "5\n3")
    matrix(bench, mesh, "--sources", sources, "--targets", targets, "--cutoff", 1, "--output", table)
    with open(table, newline="") as file:
        numbers = [[float(x) for x in row] for row in csv.reader(file)]
    expected = [[rows[i][j] if rows[i][j] <= 1 else math.inf for j in (5, 3)] for i in (3, 80, 41, 3)]
    check(numbers == expected and any(math.inf in row for row in numbers), "a table: %s" % numbers)

    text = matrix(bench, mesh, "--sources", "farthest", 5, "--targets", "farthest", 5, "--output", output)
    near = read_npy(output)
    check(" 5 rows and 5 columns" in text and all(near[i][i] == 0 for i in range(5)), "farthest vertices")
    radius = min(near[k][j] for k in range(5) for j in range(k))
    all_rows = matrix(bench, mesh, "--sources", "farthest", 5, "--output", output) and read_npy(output)
    last = [i for i in range(84) if all_rows[4][i] == 0][0]
    check_close(min(all_rows[k][last] for k in range(4)), max(min(all_rows[k][j] for k in range(4)) for j in range(84)), 1e-12, "the last one")
    check(radius > 0.5, "distances of farthest vertices")


def kill_in_the_middle(bench, command, output, rows, find_victim):
    process = subprocess.Popen(command, cwd=bench.folder, env=ENVIRONMENT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    deadline = time.monotonic() + 120
    while len(complete_rows(output)) < 3 and process.poll() is None and time.monotonic() < deadline:
        time.sleep(0.02)
    victim = find_victim(process.pid)
    if check(process.poll() is None and victim is not None, "a process to kill"):
        os.kill(victim, signal.SIGKILL)
    check(process.wait(timeout=120) != 0, "exit code after kill -9")
    left = complete_rows(output)
    check(3 <= len(left) < rows, "%d of %d rows are left" % (len(left), rows))
    return left


def check_resumed(bench, command, whole, output, left):
    result = subprocess.run([*command, "--resume"], cwd=bench.folder, env=ENVIRONMENT, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                            encoding="utf-8", timeout=300, check=False)
    check(result.returncode == 0, "a resumed run: " + result.stderr)
    check("resumed: %d rows of 60 complete: %d" % (len(left), left[0]) in result.stdout, "the complete rows: " + result.stdout)
    check(contents(output) == contents(whole), "a resumed matrix is not the same to the bit")


def large_case(bench):
    mesh = mesh_file(bench, 150, 80)
    whole, output = bench.path("whole.npy"), bench.path("m.npy")
    arguments = [mesh, "--sources", "farthest", "60", "--output"]
    matrix(bench, *arguments, whole)
    return arguments, whole, output


def test_resumed(bench):
    arguments, whole, output = large_case(bench)
    command = [os.path.join(os.path.dirname(bench.program), PROGRAM), *arguments, output, "--threads", "1"]
    left = kill_in_the_middle(bench, command, output, 60, lambda pid: pid)
    check_resumed(bench, command, whole, output, left)
    text = matrix(bench, *arguments, output, "--resume")
    check("60 rows of 60 complete: 0-59\n" in text and "\n0 rows computed" in text, "nothing to do: " + text)

    # what is resumed must be the same matrix
    bench.expect_error(1, ["no matrix of 59 rows"], arguments[0], "--sources", "farthest", 59, "--output", output, "--resume", program=PROGRAM)
    bench.expect_error(1, ["row 0 is not that of this mesh"], *arguments, output, "--cutoff", 1, "--resume", program=PROGRAM)
    data = contents(output)
    bench.write("m.npy", data[:-1])
    bench.expect_error(1, ["no matrix of 60 rows"], *arguments, output, "--resume", program=PROGRAM)
    bench.write("m.npy", data[:-8] + array.array("d", [math.nan]).tobytes())  # as a row that was not written to its end
    text = matrix(bench, *arguments, output, "--resume")
    check("59 rows of 60 complete: 0-58\n" in text and contents(output) == data, "a row that is not complete: " + text)


def test_mpi(bench):
    if shutil.which("mpirun") is None or "Boost.MPI" not in bench.start("--version", program=PROGRAM).stdout:
        skip("libboost-mpi-dev")
    arguments, whole, output = large_case(bench)
    mpirun = [shutil.which("mpirun"), "--oversubscribe", "-n"]
    command = [os.path.join(os.path.dirname(bench.program), PROGRAM), *arguments, output]
    for processes in "2", "3":
        result = subprocess.run([*mpirun, processes, *command], cwd=bench.folder, env=ENVIRONMENT, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, encoding="utf-8", timeout=300, check=False)
        check(result.returncode == 0 and "60 rows computed by %s processes with 1 thread" % processes in result.stdout, result.stdout + result.stderr)
        check(contents(output) == contents(whole), "a matrix of %s processes is not the same to the bit" % processes)
        os.remove(output)

    def rank(pid):
        """A process that mpirun has started."""
        for name in os.listdir("/proc"):
            if name.isdigit():
                try:
                    parent = contents("/proc/%s/stat" % name).rpartition(b")")[2].split()[1]
                    if int(parent) == pid and PROGRAM.encode() in contents("/proc/%s/cmdline" % name):
                        return int(name)
                except OSError:
                    pass
        return None

    left = kill_in_the_middle(bench, [*mpirun, "2", *command], output, 60, rank)
    check_resumed(bench, [*mpirun, "2", *command], whole, output, left)
    result = subprocess.run([*mpirun, "2", command[0], "none.off", *command[2:]], cwd=bench.folder, env=ENVIRONMENT, stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, encoding="utf-8", timeout=120, check=False)
    check(result.returncode != 0 and result.stderr.count(PROGRAM + ": ") == 1, "an error of two processes: " + result.stderr)


if __name__ == "__main__":
    run_test(values=test_values, resumed=test_resumed, mpi=test_mpi)
