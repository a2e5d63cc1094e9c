#!/usr/bin/env python3
# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Has tubular_mesh write a case of a surface, and its solver compute it.

    run_case.py SOLVER SHAPE FOLDER --tool PROGRAM [option of tubular_mesh...]

SHAPE is a straight tube, whose pressure drop must be Poiseuille's within 2 %, or whose wall must move as Lame says; or
the surface that is shipped, through which as much must flow out as in. Prints "Skipped: " and why, where the solver is not
there."""

import argparse
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys

RADIUS, LENGTH = 1e-3, 5e-3  # of the tube, in metres; it begins at the origin and leads along z
VISCOSITY, DENSITY = 0.004, 1060.0
SOLVERS = ["openfoam", "freefem", "fenicsx", "calculix"]


def skip(why):
    print("Skipped: " + why)
    sys.exit(0)


def fail(why):
    print(why)
    sys.exit(1)


def run_solver(solver, case):
    run = subprocess.run([str(case / "Allrun")], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
    print(run.stdout[-3000:])
    if run.returncode == 77:
        skip(solver + " does not run here")
    if "Load error" in run.stdout:
        skip("FreeFEM lacks its modules (Debian: libfreefem++)")
    if run.returncode != 0:
        fail("%s ended with %d" % (solver, run.returncode))
    return run.stdout


def write_tube(file):
    """In millimetres, open, its triangles turned outward."""
    around, along = 96, 80
    point = lambda i, j: (math.cos(2 * math.pi * i / around), math.sin(2 * math.pi * i / around), 1e3 * LENGTH * j / along)  # noqa: E731
    with open(file, "w") as out:
        out.write("solid tube\n")
        for i in range(around):
            for j in range(along):
                a, b, c, d = point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)
                for triangle in ((a, b, c), (a, c, d)):
                    out.write("facet normal 0 0 0\nouter loop\n")
                    for p in triangle:
                        out.write("vertex %.17g %.17g %.17g\n" % p)
                    out.write("endloop\nendfacet\n")
        out.write("endsolid tube\n")


def openfoam_gradient(case, density):
    """Of the pressure along the tube, in its middle, by least squares over the cells: an inlet where the gradient of the
    pressure is 0 has the pressure of the cells behind it."""
    def entries(file):
        text = (case / file).read_text()
        return re.search(r"\n(\d+)\s*\n\(\n(.*?)\n\)", text, re.S).group(2).split("\n")

    mesh = "constant/polyMesh/"
    heights = [float(line.strip("()").split()[2]) for line in entries(mesh + "points")]
    centers = []
    for line in entries(mesh + "faces"):
        corners = [heights[int(v)] for v in line[line.index("(") + 1:].rstrip(")").split()]
        centers.append(sum(corners) / len(corners))
    cells = {}
    for sides in ("owner", "neighbour"):
        for center, cell in zip(centers, entries(mesh + sides)):
            cells.setdefault(int(cell), []).append(center)
    time = max((d.name for d in case.iterdir() if d.name.isdigit()), key=int)
    pressure = [density * float(p) for p in entries(time + "/p")]
    pairs = [(sum(c) / len(c), pressure[i]) for i, c in cells.items()]
    pairs = [(z, p) for z, p in pairs if 0.25 * LENGTH < z < 0.75 * LENGTH]
    z, p = (sum(x) / len(pairs) for x in zip(*pairs))
    return sum((a - z) * (b - p) for a, b in pairs) / sum((a - z) ** 2 for a, _ in pairs)


def values(text, unit):
    pattern = r"^(\S+): (?:mean pressure )?(\S+) " + unit + "$"
    return {m.group(1): float(m.group(2)) for m in re.finditer(pattern, text, re.M)}


def check_flow(text, case, solver, shape, flow_rate, pressure):
    """Pressures at the openings, flows through them."""
    pressures, flows = values(text, "Pa"), values(text, "m3/s")
    if "inlet" not in pressures or len(pressures) != len(flows):
        fail("The solver does not tell the pressures and flows.")
    balance = sum(flows.values()) / flow_rate
    print("in %.5g of what is wanted; balance %.2g" % (-flows["inlet"] / flow_rate, balance))
    if abs(flows["inlet"] / flow_rate + 1) > 0.005 or abs(balance) > 0.01:
        fail("The flow is not what it should be.")
    outlets = [p for name, p in pressures.items() if name != "inlet"]
    if shape == "tube":
        drop = pressures["inlet"] - outlets[0]
        if solver == "openfoam":
            drop = -LENGTH * openfoam_gradient(case, DENSITY)
        drop /= 8 * VISCOSITY * LENGTH * flow_rate / (math.pi * RADIUS**4)
        print("pressure drop: %.4f times that of Poiseuille" % drop)
        if abs(drop - 1) > 0.02:
            fail("That is not Poiseuille's.")
    if any(abs(p - pressure) > 0.02 * max(abs(pressures["inlet"] - pressure), 1e-9) for p in outlets):
        fail("The pressures at the outlets are not those that were given: %s" % outlets)
    if pressures["inlet"] <= pressure:
        fail("The pressure does not fall.")


def nodes_of(deck):
    """Coordinates, and the nodes of sets."""
    nodes, sets, keyword, name = {}, {}, "", ""
    for line in deck.read_text().splitlines():
        fields = [f.strip() for f in line.split(",")]
        if line.startswith("*"):
            keyword = fields[0]
            name = dict(f.split("=", 1) for f in fields[1:] if "=" in f).get("NSET", "")
        elif keyword == "*NODE":
            nodes[int(fields[0])] = tuple(float(x) for x in fields[1:4])
        elif keyword == "*NSET":
            sets.setdefault(name, []).extend(int(f) for f in fields if f)
    return nodes, sets


def check_wall(case, shape, pressure, young, poisson):
    nodes, sets = nodes_of(case / "mesh.inp")
    moved = {}
    for line in (case / "wall.dat").read_text().splitlines():
        fields = line.split()
        if len(fields) == 4 and fields[0].isdigit():
            moved[int(fields[0])] = tuple(float(x) for x in fields[1:])
    if sorted(moved) != sorted(sets["wall"]) or not all(math.isfinite(x) for u in moved.values() for x in u):
        fail("CalculiX does not tell how all of the inside moves.")
    largest = max(math.sqrt(sum(x * x for x in u)) for u in moved.values())
    extent = max(max(p[k] for p in nodes.values()) - min(p[k] for p in nodes.values()) for k in range(3))
    print("%d nodes; the inside moves by %.3g m at most" % (len(nodes), largest))
    if not 0 < largest < 0.2 * extent:
        fail("That is not plausible.")
    if shape != "tube":
        return
    # the axis is that of z, from the origin
    inner = [(math.hypot(*nodes[n][:2]), sum(moved[n][k] * nodes[n][k] for k in (0, 1)) / math.hypot(*nodes[n][:2]))
             for n in sets["wall"] if 0.4 * LENGTH < nodes[n][2] < 0.6 * LENGTH]
    a = sum(r for r, _ in inner) / len(inner)
    b = [math.hypot(*nodes[n][:2]) for n in sets["outer_wall"]]
    b = sum(b) / len(b)
    lame = (1 + poisson) / young * pressure * a * a / (b * b - a * a) * ((1 - 2 * poisson) * a + b * b / a)
    ratio = sum(u for _, u in inner) / len(inner) / lame
    print("the wall moves outward %.4f times as far as by Lame" % ratio)
    if abs(ratio - 1) > 0.05:
        fail("That is not Lame's.")


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("solver", choices=SOLVERS)
    arguments.add_argument("shape")
    arguments.add_argument("folder", type=pathlib.Path)
    arguments.add_argument("--tool", required=True)
    a, options = arguments.parse_known_args()
    shutil.rmtree(a.folder, ignore_errors=True)
    a.folder.mkdir(parents=True)
    surface = a.shape
    if a.shape == "tube":
        surface = str(a.folder / "tube.stl")
        write_tube(surface)
    # slow in the tube, of Reynolds number 19: the velocity at the inlet, as it is on a mesh, is soon that of the tube
    flow_rate = 1e-7 if a.shape == "tube" else 10e-6
    young, poisson, wall_pressure, outlet_pressure = 1e6, 0.3, 10000., 10.
    if a.solver == "calculix":
        own = ["--wall-pressure", str(wall_pressure), "--youngs-modulus", str(young), "--poissons-ratio", str(poisson)]
    else:
        own = ["--flow-rate", str(flow_rate * 1e6), "--outlet-pressure", str(outlet_pressure)]
    case = a.folder / "case"
    run = subprocess.run([a.tool, surface, "-q", "-o", str(case), "--case", a.solver, *own, *options],
                         stderr=subprocess.PIPE, universal_newlines=True)
    if "built without" in run.stderr or "need a mesher that keeps" in run.stderr:
        skip(run.stderr)
    if run.returncode != 0:
        fail(run.stderr)
    text = run_solver(a.solver, case)
    if a.solver == "calculix":
        if "*ERROR" in text:
            fail("CalculiX does not take the case.")
        check_wall(case, a.shape, wall_pressure, young, poisson)
    else:
        check_flow(text, case, a.solver, a.shape, flow_rate, outlet_pressure)
    return 0


if __name__ == "__main__":
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    sys.exit(main())
