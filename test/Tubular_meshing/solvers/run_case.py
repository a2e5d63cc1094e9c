#!/usr/bin/env python3
# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Has tubular_mesh write a case of a surface, and its solver compute it.

    run_case.py SOLVER SHAPE FOLDER --tool PROGRAM --generator PROGRAM [option of tubular_mesh...]

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

RADIUS, LENGTH = 1e-3, 10e-3  # of the generated tube, in metres
VISCOSITY = 0.0035
COMMANDS = {"openfoam": ["./Allrun"], "freefem": ["FreeFem++", "-nw", "-v", "0", "flow.edp"],
            "fenicsx": [shutil.which("python3", path="/usr/bin") or "python3", "flow.py"], "calculix": ["ccx", "wall"]}


def skip(why):
    print("Skipped: " + why)
    sys.exit(0)


def fail(why):
    print(why)
    sys.exit(1)


def run_solver(solver, case):
    command = COMMANDS[solver]
    program = {"openfoam": "simpleFoam"}.get(solver, command[0])
    if not shutil.which(program):
        skip("there is no " + program + " here")
    run = subprocess.run(command, cwd=case, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
    print(run.stdout[-3000:])
    if run.returncode == 77 or "Skipped: " in run.stdout:
        skip(solver + " does not run here")
    if run.returncode != 0:
        fail("%s ended with %d" % (solver, run.returncode))
    return run.stdout


def values(text, unit):
    pattern = r"^(\S+): (?:mean pressure )?(\S+) " + unit + "$"
    return {m.group(1): float(m.group(2)) for m in re.finditer(pattern, text, re.M)}


def check_flow(text, shape, flow_rate, pressure):
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
        exact = 8 * VISCOSITY * LENGTH * flow_rate / (math.pi * RADIUS**4)
        drop = (pressures["inlet"] - outlets[0]) / exact
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
    arguments.add_argument("solver", choices=sorted(COMMANDS))
    arguments.add_argument("shape")
    arguments.add_argument("folder", type=pathlib.Path)
    arguments.add_argument("--tool", required=True)
    arguments.add_argument("--generator", required=True)
    a, options = arguments.parse_known_args()
    shutil.rmtree(a.folder, ignore_errors=True)
    a.folder.mkdir(parents=True)
    surface = a.shape
    if a.shape == "tube":
        surface = str(a.folder / "tube.stl")
        subprocess.run([a.generator, "tube", "--resolution", "48", "-o", surface], check=True)
    flow_rate = 1e-6 if a.shape == "tube" else 10e-6
    young, poisson, wall_pressure, outlet_pressure = 1e6, 0.3, 10000., 100.
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
        check_flow(text, a.shape, flow_rate, outlet_pressure)
    return 0


if __name__ == "__main__":
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    sys.exit(main())
