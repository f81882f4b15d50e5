# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the manual and checks it: test_manual.py DOXYFILE SOURCE_DIR

- Doxygen has no warnings.
- Each public entity has a brief description, and each value of an enumeration a description.
- No public declaration has an internal type or a nameless template parameter.
- Each function outside classes says which header declares it.
- The pages that a newcomer looks for exist, and each local link and picture has a target.
- The Doxyfile.in of each package, the form for the documentation of CGAL, works with the settings of the manual in place of CGAL's.
- Each publication of the bibliography is cited.
- The README and the pages beside the manual name only files that exist; the README has at most 120 lines, and shows a part of the
  example program as it is.

The exit code is 77, for "skipped", where Doxygen is not installed.
"""

import html.parser
import os
import re
import shutil
import subprocess
import sys
import tempfile
import urllib.parse
import xml.etree.ElementTree

checks = failures = 0


def check(ok, text):
    global checks, failures
    checks += 1
    if not ok:
        failures += 1
        print("FAILED", text)
    return ok


def contents(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def build(text, directory):
    """Runs Doxygen with the settings and returns its warnings."""
    settings = os.path.join(directory, "Doxyfile")
    warnings = os.path.join(directory, "warnings.txt")
    with open(settings, "w", encoding="utf-8") as file:
        file.write(text)
        file.write('\nOUTPUT_DIRECTORY = "%s"\nWARN_LOGFILE = "%s"\nGENERATE_XML = YES\n' % (directory, warnings))
    result = subprocess.run(["doxygen", settings], cwd=directory)
    check(result.returncode == 0, "doxygen: exit code %d" % result.returncode)
    return contents(warnings) if os.path.exists(warnings) else ""


def text_of(element):
    return "" if element is None else "".join(element.itertext()).strip()


def check_declarations(directory):
    """Briefs and types of all public entities."""
    members = 0
    for name in sorted(os.listdir(directory)):
        if not re.match("(class|struct|namespace|group)", name):
            continue
        for compound in xml.etree.ElementTree.parse(os.path.join(directory, name)).getroot().iter("compounddef"):
            if compound.get("prot", "public") != "public":
                continue
            compound_name = text_of(compound.find("compoundname"))
            if compound.get("kind") in ("class", "struct"):
                check(text_of(compound.find("briefdescription")), compound_name + " has no brief description")
            for member in compound.iter("memberdef"):
                if member.get("prot") != "public" or member.get("kind") == "friend":
                    continue
                members += 1
                arguments = text_of(member.find("argsstring"))
                full_name = "%s::%s%s" % (compound_name, text_of(member.find("name")), arguments)
                check(text_of(member.find("briefdescription")), full_name + " has no brief description")
                for value in member.iterfind("enumvalue"):
                    check(text_of(value.find("briefdescription")) or text_of(value.find("detaileddescription")),
                          "%s::%s has no description" % (full_name, text_of(value.find("name"))))
                parameters = text_of(member.find("templateparamlist"))
                declaration = " ".join((parameters, text_of(member.find("type")), arguments))
                check("internal" not in declaration, "%s has an internal type: %s" % (full_name, declaration))
                nameless = [p for p in member.iterfind("templateparamlist/param")
                            if text_of(p.find("type")) in ("class", "typename") and p.find("declname") is None]
                check(not nameless, full_name + " has a template parameter for overload resolution alone")
    check(members > 150, "only %d public entities" % members)


class Page(html.parser.HTMLParser):
    """The addresses and the anchors of a page."""

    def __init__(self, path):
        super().__init__()
        self.addresses = set()
        self.anchors = set()
        self.feed(contents(path))

    def handle_starttag(self, tag, attributes):
        for key, value in attributes:
            if key in ("id", "name"):
                self.anchors.add(value)
            elif key in ("href", "src", "data") and value:
                self.addresses.add(value)


def check_links(directory):
    pages = {name: Page(os.path.join(directory, name)) for name in os.listdir(directory) if name.endswith(".html")}
    check(len(pages) > 40, "only %d pages" % len(pages))
    for name, page in sorted(pages.items()):
        for address in sorted(page.addresses):
            url = urllib.parse.urlparse(address)
            if url.scheme or address.startswith("//") or url.path.startswith("mathjax/"):
                continue
            target = url.path or name
            if check(os.path.exists(os.path.join(directory, target)), "%s refers to %s" % (name, address)) and url.fragment:
                if target in pages:
                    check(url.fragment in pages[target].anchors, "%s refers to %s" % (name, address))


def check_contents(directory):
    """Entries that newcomers need, in the navigation tree and on the pages."""
    tree = contents(os.path.join(directory, "navtreedata.js"))
    places = [tree.find('"%s"' % title) for title in
              ("Introduction", "Quick Start", "Definitions", "Functions", "Exactness", "Performance", "Contributing",
               "Certified Bounds and Their Error Analysis", "Performance Notes", "Benchmarks", "Numbers with Exact Square Roots")]
    check(min(places) >= 0 and places == sorted(places), "the navigation tree is not in order: %s" % places)

    of_class = contents(os.path.join(directory, "classCGAL_1_1Surface__mesh__geodesic__offset.html"))
    check(of_class.count("explicit") > 0 and "<h2 class=\"memtitle\"><span class=\"permalink\"><a href=\"#" in of_class
          and re.search(r"</a></span>Surface_mesh_geodesic_offset\(\)", of_class), "the class has no constructors")
    check(re.search(r"#include\s*&lt;", of_class), "the class has no #include")
    for group in ("Functions", "IO"):
        text = contents(os.path.join(directory, "group__PkgSurfaceMeshGeodesicOffset%s.html" % group))
        functions = len(re.findall(r'<h2 class="memtitle">', text))
        includes = len(re.findall(r"#include\s*&lt;", text))
        check(functions > 3 and includes >= functions, "%s: %d functions, %d #include" % (group, functions, includes))


def settings_for_cgal(doxyfile, source, package, inputs):
    """Doxyfile.in with the variables of CGAL's CMake files; the Doxyfile, with `inputs` if there are any, replaces the defaults of CGAL."""
    text = contents(os.path.join(source, "doc", package, "Doxyfile.in"))
    for name, value in (("CGAL_DOC_PACKAGE_DEFAULTS", doxyfile), ("CGAL_DOC_VERSION", "6.0"), ("CGAL_PACKAGE_DIR", source),
                        ("CGAL_PACKAGE_DOC_DIR", os.path.join(source, "doc", package))):
        text = text.replace("${%s}" % name, value)
    check("${" not in text, "Doxyfile.in uses an unknown variable")
    return text + "\nINPUT = %s\n" % " ".join(os.path.join(source, name) for name in inputs) if inputs else text


def check_bibliography(source):
    folder = os.path.join(source, "doc/Surface_mesh_geodesic_offset")
    keys = re.findall(r"@\w+\{(\w+),", contents(os.path.join(folder, "Surface_mesh_geodesic_offset.bib")))
    texts = ""
    for top in ("doc", "include"):
        for directory, _, names in os.walk(os.path.join(source, top)):
            texts += "".join(contents(os.path.join(directory, name)) for name in names if name.endswith((".txt", ".md", ".h")))
    check(keys, "no publication in the bibliography")
    for key in keys:
        check("\\cgalCite{%s}" % key in texts, key + " is not cited")


def check_names(path, source):
    """Each name of a file in a Markdown text is that of a file of the repository."""
    files = set()
    for directory, folders, names in os.walk(source):
        folders[:] = [f for f in folders if not f.startswith((".", "build"))]
        files.update(os.path.relpath(os.path.join(directory, name), source).replace(os.sep, "/") for name in names)
    text = re.sub(r"```.*?```", "", contents(path), flags=re.DOTALL)
    names = set(re.findall(r"`((?:[\w-]+/)*[\w-]+\.(?:h|cpp|py|sh|md|txt))`", text))
    for name in sorted(names):
        check(any(f == name or f.endswith("/" + name) for f in files), "%s names %s, which does not exist" % (path, name))
    links = set(re.findall(r"\]\(([^):#]+)\)", text))
    check(names or links, "%s names no file" % path)
    for name in sorted(links):
        check(os.path.exists(os.path.join(os.path.dirname(path), name)), "%s refers to %s" % (path, name))


def check_example(source):
    example = contents(os.path.join(source, "examples/Surface_mesh_geodesic_offset/geodesic_offset_curves.cpp"))
    readme = contents(os.path.join(source, "README.md"))
    shown = re.search(r"```cpp\n(.*?)```", readme, re.DOTALL).group(1)
    check(shown in example, "the code in README.md is not that of geodesic_offset_curves.cpp")
    check(readme.count("\n") <= 120, "README.md has %d lines" % readme.count("\n"))
    for name, most in (("geodesic_offset_curves", 12), ("geodesic_offset_object", 20)):
        text = contents(os.path.join(source, "examples/Surface_mesh_geodesic_offset/%s.cpp" % name))
        body = re.search(r"int main.*?\n\{\n(.*?)\n\}", text, re.DOTALL).group(1)
        lines = [line for line in body.split("\n") if line.strip()]
        check(len(lines) <= most and max(map(len, lines)) <= 128, "%s has %d lines" % (name, len(lines)))


def main(doxyfile, source):
    if shutil.which("doxygen") is None:
        print("skipped: Doxygen is not installed")
        return 77
    with tempfile.TemporaryDirectory() as directory:
        warnings = build(contents(doxyfile), directory)
        check(not warnings, "Doxygen warns:\n" + warnings)
        check_declarations(os.path.join(directory, "xml"))
        check_links(os.path.join(directory, "html"))
        check_contents(os.path.join(directory, "html"))
    bibliography = "doc/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_offset.bib"
    for package, title, inputs in (
            ("Surface_mesh_geodesic_offset", "Triangulated Surface Mesh Geodesic Offsets", []),
            ("Radical_number", "Numbers with Exact Square Roots", ["doc/Radical_number", "include/CGAL/Radical_number.h", bibliography])):
        with tempfile.TemporaryDirectory() as directory:
            warnings = build(settings_for_cgal(os.path.abspath(doxyfile), source, package, inputs), directory)
            check(not warnings, "Doxygen warns with Doxyfile.in of %s:\n%s" % (package, warnings))
            check(title in contents(os.path.join(directory, "html/index.html")), "the title of " + package)
    check_bibliography(source)
    check_names(os.path.join(source, "README.md"), source)
    for page in ("comparison", "contributing", "installation", "limits", "programs", "python", "recipes"):
        check_names(os.path.join(source, "doc/Surface_mesh_geodesic_offset/%s.md" % page), source)
    check_example(source)
    print("%d checks, %d failures" % (checks, failures))
    return 1 if failures else 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], sys.argv[2]))
