# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a BibTeX file as a page for Doxygen, to the standard output: bibliography.py FILE

A filter of Doxyfile_without_CGAL.in: the bibliography of Doxygen itself would need BibTeX. Each entry has the anchor
geodesic_offset_KEY. An entry that this script cannot read is an error.
"""

import re
import sys

ENTRY = re.compile(r"@\w+\{(\w+),\n((?:  \w+ = \{.*\},?\n)+)\}\n")
FIELD = re.compile(r"  (\w+) = \{(.*)\},?\n")


def line_of(key, fields):
    text = {name: value.replace("{", "").replace("}", "").replace("--", "-") for name, value in fields}
    place = "<em>%s</em>" % (text.get("journal") or text["booktitle"])
    if "volume" in text:
        place += " %s(%s)" % (text["volume"], text["number"])
    rest = [place, text["year"]] + [text[name] for name in ("pages", "note") if name in text]
    return r"- \anchor geodesic_offset_%s [%s] %s. %s. %s." % (
        key, key, text["author"].replace(" and ", ", "), text["title"], ", ".join(rest))


def page_of(content):
    entries = ENTRY.findall(content)
    if len(entries) != content.count("@"):
        sys.exit("%d of %d entries are in the form that this script reads" % (len(entries), content.count("@")))
    lines = [line_of(key, FIELD.findall(fields)) for key, fields in entries]
    return "/*!\n\\page geodesic_offset_bibliography Bibliography\n\n%s\n*/\n" % "\n".join(lines)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    with open(sys.argv[1], encoding="utf-8") as file:
        print(page_of(file.read()))
