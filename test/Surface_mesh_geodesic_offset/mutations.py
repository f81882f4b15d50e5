# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Random damage to files: bytes, numbers, words, lines, and parts of other files."""

import random

import sample_files

LONGEST = 1 << 16
SEPARATORS = b" \n\r\t/"
WORDS = [word.encode() for word in (
    "-1 0 1 2 3 4 5 6 7 100 255 256 65535 65536 2147483647 2147483648 4294967295 4294967296 4294967297 9223372036854775808 "
    "18446744073709551615 18446744073709551616 99999999999999999999999999 -2147483648 -2147483649 1e999 -1e999 1e-400 1e308 nan -nan "
    "inf -inf 1.5 0x10 1e e5 . - + +-1 --1 1,5 1#2 1/2/3 / // 5/ -9 1.#IND NAN(5) 00000000000000000003 3.0 1_000").split()]
KEYWORDS = [word.encode("latin-1") for word in (
    "OFF COFF NOFF STOFF 4OFF nOFF STCN4nOFF SKEL BINARY v vt f l # ply format ascii binary_little_endian binary_big_endian 1.0 comment "
    "element vertex vertices face property list char uchar short ushort int uint float double int8 float64 half x y z vertex_indices "
    "vertex_index end_header solid facet normal outer loop endloop endfacet endsolid distance").split()
    + ["\\\n", "\n", "\r", "\r\n", "\t", "\xef\xbb\xbf", "property list uchar int x", "element nothing 1000000000",
       "property uchar a\nproperty list int int b"]]
NUMBERS = (0, 1, 3, 0xff, 0x7f, 0x80, 0xffff, 0x7fffffff, 0x80000000, 0xffffffff, 0x7f800000, 0x7fc00000, 0x100, 0x1000000, (1 << 64) - 1,
           0x7ff0000000000000)  # of binary files


def word_at(data, at):
    begin = end = at
    while begin > 0 and data[begin - 1] not in SEPARATORS:
        begin -= 1
    while end < len(data) and data[end] not in SEPARATORS:
        end += 1
    return begin, end


def line_at(data, at):
    begin = data.rfind(b"\n", 0, at) + 1
    return begin, (data.find(b"\n", begin) + 1) or len(data)


def change(generator, data, other):
    below = lambda n: generator.randrange(n) if n > 0 else 0
    at, kind = below(len(data) + 1), below(13)
    begin, end, new = at, at, b""
    if kind == 0:
        end, new = at + 1, bytes([below(256)])
    elif kind == 1 and at < len(data):
        end, new = at + 1, bytes([data[at] ^ 1 << below(8)])
    elif kind == 2:
        new = bytes([below(256)])
    elif kind == 3:
        end = at + 1 + below(generator.choice((3, 100)))
    elif kind == 4:
        end = len(data)
    elif 5 <= kind <= 8:
        begin, end = word_at(data, at)
        new = b"" if kind == 8 else generator.choice(generator.choice((WORDS, KEYWORDS)))
    elif kind == 9:  # repeats a line
        begin, end = line_at(data, at)
        new = data[begin:end] * (below(300) if below(8) == 0 else 1)
        begin = end = line_at(data, below(len(data) + 1))[0]
    elif kind == 10:
        begin, end = line_at(data, at)
    elif kind == 11:
        size = 1 << below(4)
        end, new = at + size, (generator.choice(NUMBERS) % (1 << 8 * size)).to_bytes(size, generator.choice(("little", "big")))
    elif kind == 12:
        begin_of_part = below(len(other))
        end, new = at + below(40), other[begin_of_part:begin_of_part + below(60)]
    return (data[:begin] + new + data[end:])[:LONGEST]


def mutations(count, seed):
    """Seed, extension and bytes of each mutation. Extensions are equally likely, however many samples they have."""
    samples = [*sample_files.meshes(), *sample_files.others()]
    groups = [[data for name, data in samples if sample_files.extension(name) == e] for e in sample_files.EXTENSIONS]
    for i in range(seed, seed + count):
        generator = random.Random(i)
        data = generator.choice(groups[i % len(groups)])
        for _ in range(generator.randint(1, 8) if generator.randrange(3) == 0 else 1):
            data = change(generator, data, generator.choice(samples)[1])
        yield i, sample_files.EXTENSIONS[i % len(groups)], data
