#!/usr/bin/env python3
# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whole runs of tubular_mesh, and the same inputs through gmsh and tetgen where these are installed.

    whole_runs.py [-b BUILD] [-s SHARED_DATA] [-n N] [--only NAME...] [--own] [--markdown] [--keep DIR]

Inputs are the surfaces with centerlines of the project's data/ and of SHARED_DATA/paper, and shapes made by
generate_tubular_surface. The other programs get the closed surface that tubular_mesh hands to its mesher
(--write-surface) and, at each point, the size of its result there (mean length of the edges at a vertex), so that the
three are asked for the same mesh:

- gmsh classifies and reparametrizes the surface, remeshes it, and fills it (Delaunay, its default optimization);
- tetgen keeps the surface's facets, refines them where it must, and fills it (-pq1.4m).

Quality is computed here for all three, equation (13) of the paper: gamma = 2 sqrt(6) inradius / longest edge. Times are
wall-clock times of the whole program, files included; `stages` are what the program itself reports. Standard library
only.
"""

import argparse
import itertools
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]


# ---------------------------------------------------------------------------------------------------------------------
# running


class Run:
    """A finished program: status, output, seconds, and peak memory in bytes."""

    def __init__(self, command, directory, limit):
        start = time.monotonic()
        log = pathlib.Path(directory) / "log.txt"
        with open(log, "w") as out:
            child = subprocess.Popen(["timeout", str(limit)] + [str(c) for c in command], cwd=directory, stdout=out,
                                     stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL)
            _, status, usage = os.wait4(child.pid, 0)
            child.returncode = os.waitstatus_to_exitcode(status)
        self.status = child.returncode
        self.seconds = time.monotonic() - start
        self.memory = usage.ru_maxrss * 1024
        self.output = log.read_text(errors="replace")

    def failure(self):
        if self.status == 124:
            return "time limit"
        lines = [line.strip() for line in self.output.splitlines() if line.strip()]
        telling = [line for line in lines if re.search(r"error|fail|intersect", line, re.I)]
        return f"status {self.status}: {(telling or lines or ['no output'])[-1][:70]}"


# ---------------------------------------------------------------------------------------------------------------------
# files


def lines_of(file):
    for line in pathlib.Path(file).read_text().splitlines():
        words = line.split("#")[0].split()
        if words:
            yield words


def read_medit(file):
    """Vertices and the index quadruples (from 0) of the tetrahedra of a MEDIT ASCII file, one element a line. Counts
    are not relied on: those of tetgen are wrong."""
    points, tetrahedra, section = [], [], None
    for words in lines_of(file):
        if words[0][0].isalpha():
            section = words[0]
        elif section == "Vertices" and len(words) == 4:
            points.append(tuple(map(float, words[:3])))
        elif section == "Tetrahedra" and len(words) == 5:
            tetrahedra.append(tuple(int(i) - 1 for i in words[:4]))
    return points, tetrahedra


def read_off(file):
    """Vertices and triangles of an OFF file."""
    words = itertools.chain.from_iterable(lines_of(file))
    next(words)
    n, m = int(next(words)), int(next(words))
    next(words)
    points = [tuple(float(next(words)) for _ in range(3)) for _ in range(n)]
    triangles = [tuple(int(next(words)) for _ in range(int(next(words)))) for _ in range(m)]
    return points, triangles


def write_stl(file, points, triangles):
    with open(file, "w") as out:
        out.write("solid closed\n")
        for triangle in triangles:
            out.write("facet normal 0 0 0\nouter loop\n")
            out.writelines("vertex %.17g %.17g %.17g\n" % points[i] for i in triangle)
            out.write("endloop\nendfacet\n")
        out.write("endsolid closed\n")


def write_size_view(file, points, tetrahedra, sizes):
    """Sizes as a post-processing view of gmsh, linear in each tetrahedron."""
    with open(file, "w") as out:
        out.write('View "size" {\n')
        for tetrahedron in tetrahedra:
            at = ",".join("%.9g,%.9g,%.9g" % points[i] for i in tetrahedron)
            out.write("SS(%s){%s};\n" % (at, ",".join("%.6g" % sizes[i] for i in tetrahedron)))
        out.write("};\n")


# ---------------------------------------------------------------------------------------------------------------------
# measures


def gamma(a, b, c, d):
    """Equation (13): 1 for a regular tetrahedron, negative for an inverted one."""
    def minus(p, q):
        return (p[0] - q[0], p[1] - q[1], p[2] - q[2])

    def cross(u, v):
        return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])

    def squared(u):
        return u[0] * u[0] + u[1] * u[1] + u[2] * u[2]

    ab, ac, ad, bc, bd, cd = minus(b, a), minus(c, a), minus(d, a), minus(c, b), minus(d, b), minus(d, c)
    n = cross(ab, ac)
    six_volumes = n[0] * ad[0] + n[1] * ad[1] + n[2] * ad[2]
    two_areas = sum(math.sqrt(squared(v)) for v in (n, cross(ab, ad), cross(ac, ad), cross(bc, bd)))
    longest = math.sqrt(max(map(squared, (ab, ac, ad, bc, bd, cd))))
    return 2 * math.sqrt(6) * six_volumes / (two_areas * longest) if two_areas > 0 else 0.0


def quality(points, tetrahedra):
    values = [gamma(*(points[i] for i in t)) for t in tetrahedra]
    if values and sum(values) < 0:  # another convention of orientation
        values = [-v for v in values]
    return {"tetrahedra": len(values), "min": min(values, default=None),
            "mean": sum(values) / len(values) if values else None}


def vertex_sizes(points, tetrahedra):
    """The mean length of the edges at each vertex (inner edges count once a tetrahedron)."""
    total, count = [0.0] * len(points), [0] * len(points)
    for t in tetrahedra:
        for i in range(4):
            for j in range(i):
                length = math.dist(points[t[i]], points[t[j]])
                for v in (t[i], t[j]):
                    total[v] += length
                    count[v] += 1
    return [s / c if c else None for s, c in zip(total, count)]


class Nearest_value:
    """The value of the nearest of many points, by a uniform grid of about one point a cell of the surface."""

    def __init__(self, points, values):
        self.points, self.values = points, values
        lower = [min(p[k] for p in points) for k in range(3)]
        diagonal = math.dist(lower, [max(p[k] for p in points) for k in range(3)])
        self.width = diagonal / max(1.0, math.sqrt(len(points)))
        self.cells = {}
        for i, p in enumerate(points):
            if values[i] is not None:
                self.cells.setdefault(self.cell(p), []).append(i)

    def cell(self, p):
        return tuple(math.floor(x / self.width) for x in p)

    def __call__(self, p):
        x, y, z = self.cell(p)
        best, value, ring = math.inf, None, 0
        while best > (ring - 1) * self.width:  # cells of ring k are at least (k - 1) widths away
            for i in range(-ring, ring + 1):
                for j in range(-ring, ring + 1):
                    step = 1 if ring in (abs(i), abs(j)) else max(1, 2 * ring)
                    for k in range(-ring, ring + 1, step):
                        for q in self.cells.get((x + i, y + j, z + k), ()):
                            distance = math.dist(p, self.points[q])
                            if distance < best:
                                best, value = distance, self.values[q]
            ring += 1
        return value


# ---------------------------------------------------------------------------------------------------------------------
# the programs


def row(case, program, run, mesh_file, stages=None, **more):
    result = {"input": case, "program": program, "seconds": run.seconds, "memory": run.memory, "stages": stages or {}}
    mesh = quality(*read_medit(mesh_file)) if run.status == 0 and mesh_file.exists() else {"tetrahedra": 0}
    result.update(mesh if mesh["tetrahedra"] else {"failure": run.failure()})
    result.update(more)
    return result


def dig(tree, *keys):
    for key in keys:
        tree = tree.get(key) if isinstance(tree, dict) else None
    return tree


def own_row(case, name, options, directory, extra):
    mesh_file, report_file = directory / f"{name}.mesh", directory / f"{name}.json"
    command = [options.tool, case.surface, "-c", case.centerlines, "-o", mesh_file.name, "-n", case.n,
               "--report", report_file.name, *extra]
    run = Run(command, directory, options.limit)
    report = json.loads(report_file.read_text()) if report_file.exists() else {}
    own = row(case.name, "tubular_mesh" if name == "own" else name, run, mesh_file, dig(report, "times"), n=case.n)
    own["memory"] = dig(report, "peak_memory_bytes") or own["memory"]
    return own, mesh_file


def run_parametric(case, _, options, directory):
    """The same program with its parametric surface mesher, and TetGen where it is built in."""
    return own_row(case, "parametric", options, directory, ["--surface-mesher", "parametric"])[0]


def run_tubular_mesh(case, options, directory):
    """Its row, and what the other programs need: closed surface, mesh, sizes; None if it failed."""
    own, mesh_file = own_row(case, "own", options, directory, ["--write-surface", "closed.off"])
    if "failure" in own or not (directory / "closed.off").exists():
        return own, None
    points, tetrahedra = read_medit(mesh_file)
    return own, (read_off(directory / "closed.off"), points, tetrahedra, vertex_sizes(points, tetrahedra))


GEO = """Merge "closed.stl";
ClassifySurfaces{40 * Pi / 180, 1, 1, Pi};
CreateGeometry;
Surface Loop(1) = Surface{:};
Volume(1) = {1};
Merge "size.pos";
Field[1] = PostView;
Field[1].ViewIndex = 0;
Background Field = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeFromCurvature = 0;
"""


def run_gmsh(case, own, options, directory):
    (points, triangles), mesh_points, tetrahedra, sizes = own
    write_stl(directory / "closed.stl", points, triangles)
    write_size_view(directory / "size.pos", mesh_points, tetrahedra, sizes)
    (directory / "case.geo").write_text(GEO)
    run = Run(["gmsh", "case.geo", "-3", "-nt", "1", "-format", "mesh", "-o", "gmsh.mesh"], directory, options.limit)
    stages = {stage.lower(): float(seconds)
              for stage, seconds in re.findall(r"Done (meshing \w+|optimizing mesh) \(Wall ([0-9.]+)s", run.output)}
    return row(case.name, "gmsh", run, directory / "gmsh.mesh", stages)


def run_tetgen(case, own, options, directory):
    (points, triangles), mesh_points, tetrahedra, sizes = own
    size = Nearest_value(mesh_points, sizes)
    with open(directory / "case.node", "w") as out:
        out.write("%d 3 0 0\n" % len(points))
        out.writelines("%d %.17g %.17g %.17g\n" % (i, *p) for i, p in enumerate(points))
    with open(directory / "case.smesh", "w") as out:
        out.write("0 3 0 0\n%d 0\n" % len(triangles))
        out.writelines("3 %d %d %d\n" % t for t in triangles)
        out.write("0\n0\n")
    with open(directory / "case.mtr", "w") as out:
        out.write("%d 1\n" % len(points))
        out.writelines("%.9g\n" % size(p) for p in points)
    run = Run(["tetgen", "-pq1.4mgEFN", "case.smesh"], directory, options.limit)
    stages = {stage.lower(): float(seconds)
              for stage, seconds in re.findall(r"^(\w[\w ]*?) seconds:\s+([0-9.]+)", run.output, re.M)}
    return row(case.name, "tetgen", run, directory / "case.1.mesh", stages)


# ---------------------------------------------------------------------------------------------------------------------
# inputs


class Case:
    def __init__(self, name, surface, centerlines, n):
        self.name, self.surface, self.centerlines, self.n = name, surface, centerlines, n


def centerlines_beside(surface):
    """NAME_centerlines.* (this project's habit), or centerlinesNAME.* (the paper's)."""
    for pattern in (f"{surface.stem}_centerlines.*", f"centerlines{surface.stem.upper()}.*"):
        for file in sorted(surface.parent.glob(pattern)):
            return file
    return None


def files_with_centerlines(folder, n):
    for surface in sorted(folder.glob("*.stl")):
        centerlines = centerlines_beside(surface)
        if centerlines:
            yield Case(f"{folder.name}/{surface.stem}", surface, centerlines, n)


def generated(options, directory):
    """Shapes of the project's generator: a Y, a loop, and the paper's count of bronchial branches."""
    if not options.generator:
        return
    for name, arguments in (("y", ["y"]), ("willis", ["willis"]), ("tree_305", ["tree", "--branches", "305"])):
        surface, centerlines = directory / f"{name}.stl", directory / f"{name}_centerlines.vtk"
        run = Run([options.generator, *arguments, "-o", surface, "--centerlines", centerlines], directory, options.limit)
        if run.status == 0:
            yield Case(f"generated/{name}", surface, centerlines, options.n)
        else:
            print(f"generated/{name}: {run.failure()}", file=sys.stderr)


# ---------------------------------------------------------------------------------------------------------------------
# the table


def cells_of(result):
    def number(value, form):
        return "-" if value is None else form % value

    # The stages that count: a twentieth of the run or more; tetgen lists its total among them.
    stages = ", ".join("%s %.2f" % (k, v) for k, v in result["stages"].items()
                       if isinstance(v, (int, float)) and v >= result["seconds"] / 20 and "total" not in k)
    head = [result["input"], result["program"], number(result.get("n"), "%d")]
    if "failure" in result:
        return head + ["-", "-", "-", "%.2f" % result["seconds"], "%.0f" % (result["memory"] / 1e6), result["failure"]]
    return head + ["%d" % result["tetrahedra"], number(result["min"], "%.3f"), number(result["mean"], "%.3f"),
                   "%.2f" % result["seconds"], "%.0f" % (result["memory"] / 1e6), stages]


TITLES = ["input", "program", "n", "tetrahedra", "gamma min", "gamma mean", "total s", "MB", "stages (s)"]


def print_table(results, markdown):
    rows = [TITLES] + [cells_of(r) for r in results]
    widths = [max(len(r[k]) for r in rows) for k in range(len(TITLES))]
    bar = " | " if markdown else "  "
    for i, cells in enumerate(rows):
        text = bar.join(c.rjust(w) if 2 <= k < 8 else c.ljust(w) for k, (c, w) in enumerate(zip(cells, widths)))
        print(f"| {text} |" if markdown else text.rstrip())
        if i == 0 and markdown:
            print("|" + "|".join("-" * (w + 2) for w in widths) + "|")


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-b", "--build", type=pathlib.Path, default=ROOT / "build", help="build directory")
    parser.add_argument("-s", "--shared-data", type=pathlib.Path, default=ROOT.parent / "shared" / "data")
    parser.add_argument("-n", type=int, default=20, help="points per circumference (20)")
    parser.add_argument("--only", nargs="+", default=[], metavar="NAME", help="inputs whose name contains one of these")
    parser.add_argument("--own", action="store_true", help="tubular_mesh only")
    parser.add_argument("--markdown", action="store_true", help="print a Markdown table")
    parser.add_argument("--json", type=pathlib.Path, help="also write the results to this file")
    parser.add_argument("--keep", type=pathlib.Path, help="work in this directory and leave everything there")
    parser.add_argument("--limit", type=int, default=600, help="seconds one program may take (600)")
    options = parser.parse_args()
    programs = options.build.resolve() / "examples" / "Tubular_meshing"
    options.tool = programs / "tubular_mesh"
    if not options.tool.exists():
        parser.error(f"there is no tubular_mesh in {programs}: build it first (scripts/run.sh does)")
    options.generator = programs / "generate_tubular_surface"
    if not options.generator.exists():
        options.generator = None
    return options


def run_all(options, work):
    cases = list(files_with_centerlines(ROOT / "data", options.n))
    if options.shared_data.is_dir():
        cases += files_with_centerlines(options.shared_data / "paper", options.n)
    cases += generated(options, work)
    others = [("parametric", run_parametric)]
    if not options.own:
        others += [(name, run) for name, run in (("gmsh", run_gmsh), ("tetgen", run_tetgen)) if shutil.which(name)]
    for case in cases:
        if options.only and not any(name in case.name for name in options.only):
            continue
        directory = work / case.name.replace("/", "_")
        directory.mkdir(parents=True, exist_ok=True)
        print(f"{case.name} ...", file=sys.stderr)
        result, own = run_tubular_mesh(case, options, directory)
        yield result
        for _, run in others if own else []:
            yield run(case, own, options, directory)


def main():
    options = parse_options()
    with tempfile.TemporaryDirectory() as temporary:
        work = options.keep.resolve() if options.keep else pathlib.Path(temporary)
        work.mkdir(parents=True, exist_ok=True)
        results = list(run_all(options, work))
    print_table(results, options.markdown)
    if options.json:
        options.json.write_text(json.dumps(results, indent=1) + "\n")
    return 0 if results and not any("failure" in r and r["program"] == "tubular_mesh" for r in results) else 1


if __name__ == "__main__":
    sys.exit(main())
