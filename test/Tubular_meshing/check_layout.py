#!/usr/bin/env python3
# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks the layout of the headers: the order of the folders, whose internal/ is included by whom, include guards."""

import pathlib
import re
import sys

# A folder may include the headers of those before it.
ORDER = ["base", "Centerlines", "Fields", "Quality", "Rims", "Repair", "Openings", "Plane", "Patches", "Quads", "Layers",
         "Volume", "Hexahedra", "Quadratic", "Partition", "IO", "Generators", "Pipelines"]


def defects(root):
    package = root / "CGAL" / "Tubular_meshing"
    for folder in sorted(p.name for p in package.iterdir() if p.name not in ORDER):
        yield f"{folder}: not among the folders that are there"
    for header in sorted(package.rglob("*.h")):
        path = header.relative_to(package)
        text = header.read_text(encoding="utf-8")
        folder = path.parts[0]
        for include in re.findall(r"#include <CGAL/Tubular_meshing/([^>]+)>", text):
            other = include.split("/")[0]
            if not (package / include).is_file():
                yield f"{path}: includes {include}, which is not there"
            elif other != folder and "internal" in include.split("/"):
                yield f"{path}: includes {include}, internal to another folder"
            elif ORDER.index(other) > ORDER.index(folder):
                yield f"{path}: includes {include}, of a folder that comes after its own"
        guard = "CGAL_TUBULAR_MESHING_" + re.sub(r"[/.]", "_", str(path)).upper()
        if path.name != "parameter_names.h" and f"#ifndef {guard}\n#define {guard}\n" not in text:
            yield f"{path}: its include guard is not {guard}"


def main():
    found = list(defects(pathlib.Path(sys.argv[1])))
    print("\n".join(found) if found else "The layout is as it should be.")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
