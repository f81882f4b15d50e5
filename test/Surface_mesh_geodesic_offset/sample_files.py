# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""A small surface in all variants of all formats of meshes, polylines and distances that the programs read. The tests expect the
same surface from all mesh files, and mutations.py damages these files.

    sample_files.py FOLDER        writes the files as a corpus for fuzz_readers.cpp

A name in the list is that of the variant, then the extension, which determines the format."""

import os
import struct
import sys

# a pyramid over a quadrilateral: integers from 0 to 9, which every number type represents
POINTS = (0, 0, 0), (4, 0, 0), (4, 5, 0), (0, 5, 0), (2, 2, 9)
POLYGONS = (0, 3, 2, 1), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)
TRIANGLES = [(p[0], p[k], p[k + 1]) for p in POLYGONS for k in range(1, len(p) - 1)]
CODES = dict(char="b", uchar="B", short="h", ushort="H", int="i", uint="I", float="f", double="d", int8="b", uint8="B", int16="h",
             uint16="H", int32="i", uint32="I", float32="f", float64="d")
EXTENSIONS = ".off", ".obj", ".ply", ".stl", ".polylines.txt", ".txt", ".table.ply"  # numbered as in fuzz_readers.cpp
# through the points of the edges at distance 3 of vertex 0
CURVES = b"4  3 0 0  0.635999 0.635999 2.861994  0 3 0  3 0 0 # closed\n"


def ply(order, coordinate="float", count="uchar", index="int", others=False, faces_first=False, third="float nz"):
    """`order`: empty for text, < or >; `others`: other elements and properties, too."""
    def row(*values):
        if not order:
            return b" ".join(b"%d" % x for _, x in values) + b"\n"
        return b"".join(struct.pack(order + CODES[kind], x) for kind, x in values)

    vertices, faces = b"element vertex 5\n", b"element face 5\n"
    vertices += b"property list uchar short weights\n" * others
    for c, other in zip("xyz", ("float nx", "float ny", third)):
        vertices += b"property %s %s\n" % (coordinate.encode(), c.encode()) + b"property %s\n" % other.encode() * others
    faces += b"property uchar red\n" * others + b"property list %s %s vertex_indices\n" % (count.encode(), index.encode())
    faces += b"property list int double weights\n" * others
    vertex_rows = b"".join(row(*([("uchar", i)] + [("short", -7)] * i if others else []),
                               *(pair for c in p for pair in [(coordinate, c)] + [("float", 1)] * others))
                           for i, p in enumerate(POINTS))
    face_rows = b"".join(row(*[("uchar", 200)] * others, (count, len(p)), *((index, v) for v in p),
                             *[("int", 1), ("double", 5)] * others) for p in POLYGONS)
    name = {"": b"ascii", "<": b"binary_little_endian", ">": b"binary_big_endian"}[order]
    header = b"ply\nformat " + name + b" 1.0\ncomment a pyramid\nobj_info none\n" + b"element camera 1\nproperty double zoom\n" * others
    header += (faces + vertices if faces_first else vertices + faces) + b"element edge 1\nproperty int from\nproperty int to\n" * others
    return (header + b"end_header\n" + row(("double", 3)) * others + (face_rows + vertex_rows if faces_first else vertex_rows + face_rows)
            + row(("int", 0), ("int", 1)) * others)


def off(keyword):
    """[ST][C][N][4][n]OFF as text."""
    has, w = {c: c in keyword[:-3] for c in "STCN4n"}, "4" in keyword
    text = keyword + "\n# a pyramid\n" + "3\n" * has["n"] + "5 5 8\n"
    for p in POINTS:
        text += " ".join(str(x * (2 if w else 1)) for x in p) + " 2" * w + (" 0 0 1" + " 1" * w) * has["N"]
        text += " 255 128 0 255" * has["C"] + (" 0.5 0.5" + " 1" * w) * has["S"] + "\n"
    return (text + "".join("%d  %s%s\n" % (len(p), " ".join(map(str, p)), " 0.1 0.2 0.3" * has["C"]) for p in POLYGONS)).encode()


def off_binary(keyword):
    has, w = {c: c in keyword[:-3] for c in "STCN4n"}, "4" in keyword
    data = keyword.encode() + b" BINARY\n" + struct.pack(">i", 3) * has["n"] + struct.pack(">3i", 5, 5, 8)
    for p in POINTS:
        values = [x * (4 if w else 1) for x in p] + [4] * w + [1] * ((3 + w) * has["N"])
        values += [0.5] * (4 * has["C"]) + [0.25] * ((2 + w) * has["S"])
        data += struct.pack(">%df" % len(values), *values)
    for p in POLYGONS:
        data += struct.pack(">%di" % (len(p) + 2), len(p), *p, 3 * has["C"]) + struct.pack(">f", 0.5) * (3 * has["C"])
    return data


def stl():
    text = b"solid a pyramid\n"
    for t in TRIANGLES:
        text += b"facet normal 0 0 nan\nouter loop\n"
        text += b"".join(b"vertex %d.0e+00 %d.0e+00 %d.0e+00\n" % POINTS[v] for v in t) + b"endloop\nendfacet\n"
    return text + b"endsolid a pyramid\n"


def stl_binary(header):
    data = header.ljust(80) + struct.pack("<I", len(TRIANGLES))
    for t in TRIANGLES:
        data += struct.pack("<12fH", 0, 0, 1, *(c or -0.0 for v in t for c in POINTS[v]), 7)
    return data


def meshes():
    """Pairs of name and bytes."""
    for n in range(32):
        keyword = "".join(word for k, word in enumerate(("ST", "C", "N", "4", "n")) if n >> k & 1) + "OFF"
        yield keyword + ".off", off(keyword)
        yield keyword + " BINARY.off", off_binary(keyword)
    yield "OFF on one line.off", (b"OFF 5 5 0 # sizes\n\n0 0 0\n4 0 0\n4 5 0 255 0 0\n+0 .5e1 -0\n2. 20E-1 9 # apex\n"
                                  b"4 0 3 2 1 0.5 0.5 0.5\n3 0 1 4\n3 1 2 4 # side\n3 2 3\n 4\n3 3 0 4")
    yield "OFF with a byte order mark.off", b"\xef\xbb\xbf" + off("OFF")
    yield "OBJ.obj", (b"# a pyramid\nmtllib none\no pyramid\nv 0 0 0\nv 4 0 0\nv 4 5 0\nv 0 5 0\nv 2 2 9\nvn 0 0 1\nvt 0 0\ng sides\n"
                      b"usemtl none\nf 1 4 3 2\ns off\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n")
    yield "OBJ with all kinds of indices.obj", (
        b"v 0 0 0 1\nv 4 0 0 1 0 0\nf 1/1 4/2 3 2\nv 4 5 0\nv 0 5 0\nvt 0 0\nv 2 2 9\n\tf 1//1 2//1 5//1\n"
        b"f 2/1/1 3/1/1 5/1/1\nf -3 -2 -1\nf -2/1/-1 -5 -1 # closed\nl 1 2\np 1\n")
    yield "OBJ with continued lines.obj", (b"v 0 0 \\\n0\nv 4 0 0\nv 4 5 0\nv 0 5 0\nv 2 2 9\nf 1 4 3 \\\r\n2\n"
                                           b"f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 \\\n1 \\\n5")
    for order, name in ("", "ASCII"), ("<", "little endian"), (">", "big endian"):
        for kind in CODES:
            yield "%s PLY, coordinates of type %s.ply" % (name, kind), ply(order, coordinate=kind)
            if not kind.startswith(("float", "double")):
                yield "%s PLY, counts of type %s.ply" % (name, kind), ply(order, count=kind)
                yield "%s PLY, indices of type %s.ply" % (name, kind), ply(order, index=kind)
        yield name + " PLY, other elements and properties.ply", ply(order, "double", "uchar", "uint", True)
        yield name + " PLY, other elements of type int.ply", ply(order, "float", "int", "int", True)
        yield name + " PLY, faces first.ply", ply(order, "double", "uchar", "uint", True, True)
    for end, name in (b"\r\n", "CR LF"), (b"\r", "CR"):
        yield "OFF with %s.off" % name, off("COFF").replace(b"\n", end)
        yield "STL with %s.stl" % name, stl().replace(b"\n", end)
        yield "ASCII PLY with %s.ply" % name, ply("", others=True).replace(b"\n", end)
        header, rows = ply("<").split(b"end_header\n")
        yield "binary PLY with %s.ply" % name, (header + b"end_header\n").replace(b"\n", end) + rows
    yield "STL.stl", stl()
    yield "STL in capitals.stl", stl().upper().replace(b"E", b"e")
    yield "STL of two solids.stl", b"solid\nendsolid\n" + stl()
    yield "binary STL.stl", stl_binary(b"a pyramid")
    yield "binary STL that begins with solid.stl", stl_binary(b"solid pyramid")


def others():
    """Polylines, and distances of the vertices as text and PLY files."""
    yield "polylines.polylines.txt", b"# two\n2  0 0 0  1 0 0.5\n4  0 0 0  1 0 0  0 1e-1 0  0 0 0 # closed\n"
    yield "curves.polylines.txt", CURVES
    yield "a column.txt", b"# distances\n0\n4\n6.4\ninf\n1e1\n"
    yield "pairs.txt", b"4 1e1\n1 4\n\n2 6.4 # far\r\n3 +inf\n0 0\n"
    for order, name in ("", "text"), ("<", "little endian"), (">", "big endian"):
        yield name + ".table.ply", ply(order, "double", "uchar", "uint", True, third="float distance")


def extension(name):
    return max((e for e in EXTENSIONS if name.endswith(e)), key=len)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    os.makedirs(sys.argv[1], exist_ok=True)
    for name, data in [*meshes(), *others()]:
        with open(os.path.join(sys.argv[1], name), "wb") as file:
            file.write(bytes([EXTENSIONS.index(extension(name))]) + data)
