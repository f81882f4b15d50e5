# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The layout of the headers: no cycle of includes between modules, no protected members, include guards named after files.

    test_layout.py INCLUDE_FOLDER

Each public header is a module, as programs include it alone. Each folder of internal/, IO/internal/, and the files beside the
folders of internal/ are a module each. So an internal header may include a public one, for example of a type of results, if
that header needs nothing of the folder of the internal header.
"""

import os
import re
import sys

PACKAGE = "CGAL/Surface_mesh_geodesic_offset"
INTERNAL = PACKAGE + "/internal/"
INCLUDE = re.compile(r"^ *# *include *[<\"](%s[^>\"]*)[>\"]" % PACKAGE, re.MULTILINE)
NO_GUARD = {INTERNAL + "parameters/parameters_interface.h"}  # included once per list


def headers(root):
    names = [PACKAGE + ".h"]
    for folder, _, files in os.walk(os.path.join(root, PACKAGE)):
        names += [os.path.relpath(os.path.join(folder, f), root).replace(os.sep, "/") for f in files if f.endswith(".h")]
    return {name: open(os.path.join(root, name), encoding="utf-8").read() for name in sorted(names)}


def module_of(name):
    """The folder of an internal header, the name of a public one."""
    return os.path.dirname(name) if "/internal/" in name else name


def cycle(graph):
    """Modules of a cycle in the order of their includes; empty if there is none."""
    done = set()

    def search(module, path):
        if module in path:
            return path[path.index(module):] + [module]
        if module in done:
            return []
        for other in sorted(graph.get(module, {})):
            found = search(other, path + [module])
            if found:
                return found
        done.add(module)
        return []

    for module in sorted(graph):
        found = search(module, [])
        if found:
            return found
    return []


def errors_of(texts):
    errors = []
    graph = {}
    for name, text in texts.items():
        for included in INCLUDE.findall(text):
            if included not in texts:
                errors.append("%s includes %s, which does not exist" % (name, included))
            a, b = module_of(name), module_of(included)
            if a != b:
                graph.setdefault(a, {}).setdefault(b, "%s includes %s" % (name, included))
    found = cycle(graph)
    if found:
        errors.append("a cycle of modules: " + "; ".join(graph[a][b] for a, b in zip(found, found[1:])))
    for name, text in texts.items():
        if re.search(r"^ *protected *:", text, re.MULTILINE):
            errors.append(name + " has protected members")
        guard = re.search(r"^#ifndef (CGAL_\w+_H)$\n^#define \1$", text, re.MULTILINE)
        expected = name[len("CGAL/"):].replace("/", "_").replace(".", "_").upper()
        if name not in NO_GUARD and (not guard or guard.group(1) != "CGAL_" + expected):
            errors.append("%s has the include guard %s, not CGAL_%s" % (name, guard and guard.group(1), expected))
    return errors


def check_checks(texts):
    """Each kind of error is found in headers that have it."""
    first, second = INTERNAL + "mesh/Unfolded_mesh.h", INTERNAL + "windows/Window.h"
    for name, text in ((first, texts[first] + "#include <%s>\n" % second.replace("Window.h", "Lower_envelope.h")),
                       (first, texts[first] + "#include <%s/Geodesic_mesh.h>\n" % PACKAGE),
                       (PACKAGE + "/Offset_side.h", "#include <%s/Offset_piece.h>\n" % PACKAGE + texts[PACKAGE + "/Offset_side.h"]),
                       (PACKAGE + "/IO/internal/curve_line.h",
                        texts[PACKAGE + "/IO/internal/curve_line.h"] + "#include <%s/IO/write_vtk.h>\n" % PACKAGE),
                       (second, texts[second] + "protected:\n"), (second, texts[second].replace("_H\n", "_HH\n")),
                       (first, texts[first] + "#include <%s>\n" % second.replace("Window.h", "Nothing.h"))):
        assert errors_of(dict(texts, **{name: text})), "an error in %s was not found" % name


def main():
    texts = headers(sys.argv[1])
    errors = errors_of(texts)
    if not errors:
        check_checks(texts)
    print("\n".join(errors) if errors else "%d headers" % len(texts))
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
