# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The presets: a build preset with a list of targets builds the programs of all tests of the test preset with its name.

    test_presets.py CTESTTESTFILE CMAKEPRESETS

CTESTTESTFILE is the file in which CMake lists the tests for ctest. Each name in the filter of a test preset must be that of
a test.
"""

import json
import os
import re
import sys

ENTRY = re.compile(r'^ *add_test\((?:\[=*\[)?(\w[\w.]*)(?:\]=*\])? +"([^"]*)"', re.MULTILINE)
FILTER = re.compile(r"\^test_\(([\w|]+)\)")


def errors_of(presets, programs):
    """`programs`: the file name of the program of each test"""
    targets = {preset["name"]: preset["targets"] for preset in presets["buildPresets"] if "targets" in preset}
    errors = []
    for preset in presets["testPresets"]:
        name = preset["name"]
        if name not in targets:
            continue
        match = FILTER.fullmatch(preset.get("filter", {}).get("include", {}).get("name", ""))
        if not match:
            errors.append("the filter of the test preset '%s' is not a list ^test_(name|...|name)" % name)
            continue
        for part in match.group(1).split("|"):
            found = [test for test in programs if test.startswith("test_" + part)]
            if not found:
                errors.append("the test preset '%s' names test_%s, which is no test" % (name, part))
            for test in found:
                # cmake prints why a test is skipped
                if programs[test] not in targets[name] + ["cmake"]:
                    errors.append("the test preset '%s' runs %s, and the build preset does not build its program %s"
                                  % (name, test, programs[test]))
    return errors


def check_checks(presets, programs):
    """Each kind of error is found in presets that have it."""
    tested = {preset["name"] for preset in presets["testPresets"]}
    checked = [preset for preset in presets["buildPresets"] if "targets" in preset and preset["name"] in tested]
    assert checked, "no preset has both a list of targets and tests"
    for preset in checked:
        for target in preset["targets"]:
            preset["targets"] = [other for other in preset["targets"] if other != target]
            assert errors_of(presets, programs), "a missing target %s was not found" % target
            preset["targets"].append(target)
        first = next(test for test in presets["testPresets"] if test["name"] == preset["name"])["filter"]["include"]
        whole = first["name"]
        for wrong in (whole.replace("(", "(no_test|"), "closed_forms"):
            first["name"] = wrong
            assert errors_of(presets, programs), "the filter %s was not found" % wrong
        first["name"] = whole


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        programs = {name: os.path.splitext(os.path.basename(program))[0] for name, program in ENTRY.findall(file.read())}
    with open(sys.argv[2], encoding="utf-8") as file:
        presets = json.load(file)
    errors = errors_of(presets, programs)
    if not errors:
        check_checks(presets, programs)
    print("\n".join(errors) if errors else "%d tests" % len(programs))
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
