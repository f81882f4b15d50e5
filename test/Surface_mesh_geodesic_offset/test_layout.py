# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The layout of the headers: two packages, core and shell, no cycle of includes between modules, no protected members, names of files and
include guards.

    test_layout.py INCLUDE_FOLDER

Each public header is a module, as programs include it alone. Each folder of internal/, IO/internal/, and the files beside the
folders of internal/ are a module each. So an internal header may include a public one, for example of a type of results, if
that header needs nothing of the folder of the internal header.

The folders of internal/ are core or shell, see the page for contributors. A header of the core includes none of the shell, and definitions, in files
*_impl.h, are included only by the header that declares, unless the library is compiled, and by core_definitions.h.

Radical_number is a package of its own: its headers include none of the other package, which includes only its public header.

A header has the name of its main class or type; that of a public class may omit "Geodesic_". A name in lower case is for
headers of functions or metafunctions, with no more classes than these.
"""

import os
import re
import sys

PACKAGE = "CGAL/Surface_mesh_geodesic_offset"
INTERNAL = PACKAGE + "/internal/"
NUMBERS = "CGAL/Radical_number"
INCLUDE = re.compile(r"^ *# *include *[<\"]((?:%s|%s)[./][^>\"]*)[>\"]" % (PACKAGE, NUMBERS), re.MULTILINE)
GEODESIC = re.compile(r"^ *# *include.*Surface_mesh_geodesic_offset.*", re.MULTILINE)
NAME = re.compile(r"^(?:(class|struct)|enum class|using) (?:alignas\(.*\) )?(\w+)(?! *[;<\w])|^typedef [^;]*?(\w+);", re.MULTILINE)
FUNCTION = re.compile(r"^(?!class|struct|enum|using|typedef|namespace|template|static_assert)\w.*\b\w+\(|^  typedef [^;]*\btype;",
                      re.MULTILINE)
DOORS = {PACKAGE + "/Radical_numbers.h", PACKAGE + "/core_definitions.h"}  # public headers of internal modules, without a class
SHELL = ["surface", "functions", "parameters", "splitting"]  # folders of internal/; all others are core
DEFINITIONS = PACKAGE + "/core_definitions.h"
COMPILED = "#ifndef CGAL_GEODESIC_OFFSET_COMPILED\n#include <%s>\n#endif\n"
NO_GUARD = {INTERNAL + "parameters/parameters_interface.h"}  # included once per list


def headers(root):
    names = [PACKAGE + ".h", NUMBERS + ".h"]
    for package in (PACKAGE, NUMBERS):
        for folder, _, files in os.walk(os.path.join(root, package)):
            names += [os.path.relpath(os.path.join(folder, f), root).replace(os.sep, "/") for f in files if f.endswith(".h")]
    return {name: open(os.path.join(root, name), encoding="utf-8").read() for name in sorted(names)}


def module_of(name):
    """The folder of an internal header, the name of a public one."""
    return os.path.dirname(name) if "/internal/" in name else name


def is_shell(name):
    return name.startswith(tuple(INTERNAL + folder + "/" for folder in SHELL))


def division_errors(name, text):
    """What is wrong with the division into core and shell, and into declarations and definitions."""
    errors = []
    for included in INCLUDE.findall(text):
        if name.startswith(INTERNAL) and not is_shell(name) and is_shell(included):
            errors.append("%s, of the core, includes %s, of the shell" % (name, included))
        if included.endswith("_impl.h") and name != DEFINITIONS and (
                included != name[:-2] + "_impl.h" or COMPILED % included not in text):
            errors.append("%s includes the definitions in %s" % (name, included))
    return errors


def package_errors(name, text):
    """What is wrong with the division into packages."""
    if name.startswith(NUMBERS):
        return ["%s has the line %s" % (name, line) for line in GEODESIC.findall(text)]
    return ["%s includes the internal header %s" % (name, included) for included in INCLUDE.findall(text)
            if included.startswith(NUMBERS + "/")]


def naming_error(name, text):
    """What is wrong with the name of a header; empty if nothing is."""
    base = os.path.basename(name)[:-2]
    if base.endswith("_impl") or name in DOORS:
        return ""
    found = NAME.findall(text)
    types = {of_class or of_type for _, of_class, of_type in found}
    main = base[0].upper() + base[1:]
    if base == main:
        is_public = "/internal/" not in name
        is_main = base in types or is_public and "Geodesic_" + base[0].lower() + base[1:] in types
        return "" if is_main else name + " is not named after one of its types"
    classes = {of_class for kind, of_class, _ in found if kind}
    if main in types or len(classes) > len(FUNCTION.findall(text)):
        return "%s is not a header of functions: it has the classes %s" % (name, ", ".join(sorted(classes)))
    return ""


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
        errors += package_errors(name, text) + division_errors(name, text)
        if naming_error(name, text):
            errors.append(naming_error(name, text))
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
    functions = INTERNAL + "memory/prefetch.h"
    number, signs = NUMBERS + ".h", NUMBERS + "/internal/Radical_sign.h"
    for name, text in ((second, texts[second].replace("struct Window ", "struct Other ")),
                       (functions, texts[functions].replace("\nnamespace CGAL", "\nstruct Prefetch\n{\n};\nnamespace CGAL", 1)),
                       (first, texts[first] + "#include <%s>\n" % second.replace("Window.h", "Lower_envelope.h")),
                       (first, texts[first] + "#include <%s/Geodesic_mesh.h>\n" % PACKAGE),
                       (second, texts[second] + "#include <%sparameters/named_parameters.h>\n" % INTERNAL),
                       (second, texts[second] + "#include <%sGeodesic_build_impl.h>\n" % INTERNAL),
                       (PACKAGE + "/Offset_side.h",
                        "#include <%s/Offset_piece.h>\n" % PACKAGE + texts[PACKAGE + "/Offset_side.h"]),
                       (PACKAGE + "/IO/internal/Curve_line.h",
                        texts[PACKAGE + "/IO/internal/Curve_line.h"] + "#include <%s/IO/write_vtk.h>\n" % PACKAGE),
                       (number, texts[number] + "#include <%snumbers/Number_policy.h>\n" % INTERNAL),
                       (signs, texts[signs] + "#include <CGAL/license/Surface_mesh_geodesic_offset.h>\n"),
                       (signs, texts[signs] + "#include <%s>\n" % number), (signs, texts[signs].replace("class Radical_sign\n", "class Sign\n")),
                       (second, texts[second] + "#include <%s>\n" % signs),
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
