#!/usr/bin/env python3
# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Steady flow through a straight pipe and through a bend, as `tubular_mesh --case` sets it up, by OpenFOAM, FEniCSx and
FreeFEM on meshes of each type; prints tables for reading.

    flow_study.py pipe TUBULAR_MESH SCRATCH [--only SOLVER...]
    flow_study.py bend TUBULAR_MESH SCRATCH [--only SOLVER...] [--fine]

pipe: radius 1 mm, length 8 mm, Reynolds number 19. In the middle fifth: the axial shear stress at each facet of the wall,
over 4 mu Q / (pi a^3): its mean, its standard deviation and the largest deviation from its mean, in percent of the mean;
and the gradient of the pressure over that of Poiseuille.

bend: the same pipe with half a circle of radius 8 mm between straight ends of 2 and 4 mm; Reynolds number 100, Dean
number 35. From 110 to 165 degrees: the gradient of the pressure along the axis over that of a straight pipe, beside the
correlations of White (1929) and Ito (1959) for the friction factor of curved pipes.

Needs numpy, and dolfinx for FEniCSx; what is not installed is left out. What is in SCRATCH from an earlier run is used
again. --fine adds the finest meshes, which take up to half an hour."""

import argparse
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

import numpy as np

RADIUS, VISCOSITY, DENSITY = 1e-3, 0.004, 1060.0
AROUND = 96  # points of the surface, whose facets are finer than those of the meshes
LAYERS = ["--boundary-layer-prisms", "4", "--first-height", "0.04"]
HEXAHEDRA = ["-t", "hexahedral"]
MIXED = ["-t", "mixed"] + LAYERS  # quads on the wall, hexahedra on these, pyramids and tetrahedra inside


class Pipe:
    """Straight, along z."""
    length, reynolds = 8e-3, 19.0
    window = (0.4 * length, 0.6 * length)  # where the flow is looked at, along the axis

    def axis(self, s):
        """The point and the direction at s from the inlet."""
        return np.array([0, 0, s]), np.array([0.0, 0, 1])

    def abscissa(self, x):
        return x[:, 2]

    def direction(self, x):
        return np.broadcast_to([0.0, 0, 1], x.shape)

    runs = [("openfoam", "tetrahedra", 24, []), ("openfoam", "prisms and tetrahedra", 20, LAYERS),
            ("openfoam", "hexahedral layers and tetrahedra", 20, MIXED),
            ("openfoam", "hexahedra", 24, HEXAHEDRA), ("openfoam", "hexahedra with layers", 24, HEXAHEDRA + LAYERS),
            ("fenicsx", "tetrahedra", 12, []), ("fenicsx", "tetrahedra", 16, []), ("fenicsx", "hexahedra", 16, HEXAHEDRA),
            ("fenicsx", "tetrahedra of order 2", 12, ["--order", "2"]),
            ("fenicsx", "tetrahedra of order 2", 16, ["--order", "2"])]
    fine = [("openfoam", "tetrahedra", 40, []), ("openfoam", "prisms and tetrahedra", 32, LAYERS),
            ("openfoam", "prisms and tetrahedra", 48, LAYERS), ("openfoam", "hexahedral layers and tetrahedra", 24, MIXED),
            ("fenicsx", "tetrahedra", 24, []), ("fenicsx", "hexahedra", 24, HEXAHEDRA),
            ("fenicsx", "tetrahedra of order 2", 24, ["--order", "2"])]


class Bend:
    """In the plane of x and z; begins along z, turns towards x."""
    bend_radius, before, after, reynolds = 8e-3, 2e-3, 4e-3, 100.0
    arc = math.pi * bend_radius
    length = before + arc + after
    window = (before + math.radians(110) * bend_radius, before + math.radians(165) * bend_radius)

    def axis(self, s):
        R = self.bend_radius
        if s <= self.before:
            return np.array([0, 0, s]), np.array([0.0, 0, 1])
        turn = min((s - self.before) / R, math.pi)
        point = np.array([R - R * math.cos(turn), 0, self.before + R * math.sin(turn)])
        direction = np.array([math.sin(turn), 0, math.cos(turn)])
        return point + max(0.0, s - self.before - self.arc) * direction, direction

    def abscissa(self, x):
        turn = np.arctan2(x[:, 2] - self.before, self.bend_radius - x[:, 0])
        s = self.before + self.bend_radius * turn
        below = x[:, 2] < self.before
        s[below] = np.where(x[below, 0] < self.bend_radius, x[below, 2], self.before + self.arc + self.before - x[below, 2])
        return s

    runs = [("openfoam", "tetrahedra", 24, []), ("openfoam", "prisms and tetrahedra", 20, LAYERS),
            ("openfoam", "hexahedral layers and tetrahedra", 20, MIXED),
            ("openfoam", "hexahedra with layers", 16, HEXAHEDRA + LAYERS),
            ("openfoam", "hexahedra with layers", 24, HEXAHEDRA + LAYERS),
            ("fenicsx", "tetrahedra", 12, []), ("fenicsx", "hexahedra", 8, HEXAHEDRA),
            ("fenicsx", "tetrahedra of order 2", 12, ["--order", "2"]), ("freefem", "tetrahedra", 12, [])]
    fine = [("openfoam", "tetrahedra", 40, []), ("openfoam", "prisms and tetrahedra", 32, LAYERS),
            ("openfoam", "hexahedra with layers", 40, HEXAHEDRA + LAYERS), ("fenicsx", "tetrahedra", 20, []),
            ("fenicsx", "hexahedra", 16, HEXAHEDRA), ("fenicsx", "tetrahedra of order 2", 16, ["--order", "2"]),
            ("freefem", "tetrahedra", 16, [])]


def flow_rate(shape):
    return math.pi * RADIUS ** 2 * shape.reynolds * VISCOSITY / DENSITY / (2 * RADIUS)


def write_surface(shape, file):
    """Open, in millimetres, its triangles turned outward."""
    along = int(shape.length / RADIUS * AROUND / (2 * math.pi))
    rings = []
    for j in range(along + 1):
        point, direction = shape.axis(shape.length * j / along)
        e2 = np.array([0.0, 1, 0])
        e1 = np.cross(e2, direction)
        angles = 2 * math.pi * np.arange(AROUND) / AROUND
        rings.append(1e3 * (point + RADIUS * (np.outer(np.cos(angles), e1) + np.outer(np.sin(angles), e2))))
    with open(file, "w") as out:
        out.write("solid wall\n")
        for below, above in zip(rings, rings[1:]):
            for i in range(AROUND):
                k = (i + 1) % AROUND
                for triangle in ((below[i], below[k], above[k]), (below[i], above[k], above[i])):
                    out.write("facet normal 0 0 0\nouter loop\n")
                    for p in triangle:
                        out.write("vertex %.17g %.17g %.17g\n" % tuple(p))
                    out.write("endloop\nendfacet\n")
        out.write("endsolid wall\n")


class Result:
    """Of cells the center, the volume and the pressure; of the wall's facets the center, the area and the shear stress;
    all in SI units. The latter are missing where a solver does not tell them."""

    def __init__(self, centers, volumes, pressures, facet_centers=None, areas=None, stresses=None):
        self.centers, self.volumes, self.pressures = centers, volumes, pressures
        self.facet_centers, self.areas, self.stresses = facet_centers, areas, stresses

    def save(self, file):
        np.savez(file, **{k: v for k, v in vars(self).items() if v is not None})

    @staticmethod
    def load(file):
        return Result(**np.load(file))


# --- OpenFOAM ---

def foam_list(file, after="", wanted=float):
    """The entries of a list in a file, each a row of numbers."""
    text = pathlib.Path(file).read_text()
    text = text[text.index(after):] if after else text[text.index("}") + 1:]
    body = re.search(r"\n\s*(\d+)\s*\n\(\n(.*?)\n\)", text, re.S)
    return [[wanted(x) for x in line.replace("(", " ").replace(")", " ").split()] for line in body.group(2).split("\n")]


def openfoam_result(case):
    mesh = case / "constant" / "polyMesh"
    points = np.array(foam_list(mesh / "points"))
    faces = [f[1:] for f in foam_list(mesh / "faces", wanted=int)]
    owner = np.array(foam_list(mesh / "owner", wanted=int)).ravel()
    neighbour = np.array(foam_list(mesh / "neighbour", wanted=int)).ravel()
    area, center = np.zeros((len(faces), 3)), np.zeros((len(faces), 3))
    for k, f in enumerate(faces):
        p = points[f]
        middle = p.mean(axis=0)
        half = np.cross(p - middle, np.roll(p, -1, axis=0) - middle) / 2
        size = np.linalg.norm(half, axis=1)
        area[k] = half.sum(axis=0)
        center[k] = ((p + np.roll(p, -1, axis=0) + middle) / 3 * size[:, None]).sum(axis=0) / size.sum()
    cells = max(owner.max(), neighbour.max()) + 1
    count = np.bincount(owner, minlength=cells) + np.bincount(neighbour, minlength=cells)
    middles, volumes = np.zeros((cells, 3)), np.zeros(cells)
    for k in range(3):
        middles[:, k] = (np.bincount(owner, center[:, k], cells) +
                         np.bincount(neighbour, center[: len(neighbour), k], cells)) / count
    for cell, sign, n in ((owner, 1, len(faces)), (neighbour, -1, len(neighbour))):
        volumes += np.bincount(cell, sign * np.einsum("ij,ij->i", area[:n], center[:n] - middles[cell]) / 3, cells)
    last = max((d.name for d in case.iterdir() if d.name.isdigit()), key=int)
    pressures = DENSITY * np.array(foam_list(case / last / "p", "internalField")).ravel()
    boundary = (mesh / "boundary").read_text()
    wall = re.search(r"\n\s*wall\s*\{[^}]*nFaces\s+(\d+);\s*startFace\s+(\d+);", boundary)
    n, first = int(wall.group(1)), int(wall.group(2))
    text = (case / last / "wallShearStress").read_text()
    entry = text[text.index("boundaryField"):]
    # OpenFOAM's is the force on the fluid
    stress = -DENSITY * np.array(
        [[float(x) for x in line.strip("()").split()] for line in
         re.search(r"\n\s*wall\s*\{[^}]*?List<vector>\s*\d+\s*\(\n(.*?)\n\)", entry, re.S).group(1).split("\n")])
    return Result(middles, volumes, pressures, center[first: first + n], np.linalg.norm(area[first: first + n], axis=1),
                  stress)


# --- FEniCSx: in a process of its own, with the flow.py of the case ---

def fenicsx_inside(case):
    sys.path.insert(0, str(case))
    import flow  # of the case
    import ufl
    from dolfinx import fem

    f = flow.solve()
    domain, wall = f.domain, f.ds(f.case["walls"][0]["label"])
    flat = flow.space_of(domain, flow.element("scalar", domain.ufl_cell(), 0))
    test, x = ufl.TestFunction(flat), ufl.SpatialCoordinate(domain)

    def moments(value, measure):
        return fem.petsc.assemble_vector(fem.form(value * test * measure)).array.copy()

    one = fem.Constant(domain, 1.0)
    volumes, areas = moments(one, ufl.dx), moments(one, wall)
    there = areas > 0
    centers = np.array([moments(x[k], ufl.dx) / volumes for k in range(3)]).T
    facets = np.array([moments(x[k], wall)[there] / areas[there] for k in range(3)]).T
    stress = f.shear_stress().x.array.reshape(-1, 3)[: len(volumes)][there]
    Result(centers, volumes, moments(f.pressure, ufl.dx) / volumes, facets, areas[there], stress).save(case / "result.npz")


# --- FreeFEM: what it computes, cell by cell ---

FREEFEM_CELLS = """
fespace Cells(Th, P0);
Cells cx = x, cy = y, cz = z, cv = volume, cp = p;
{
  ofstream out("cells.txt");
  out.precision(12);
  for (int i = 0; i < Th.nt; ++i)
    out << cx[][i] << " " << cy[][i] << " " << cz[][i] << " " << cv[][i] << " " << cp[][i] << endl;
}
"""


def freefem_result(case):
    cells = np.loadtxt(case / "cells.txt")
    return Result(cells[:, :3], cells[:, 3], cells[:, 4])


def compute(solver, case):
    """Runs the solver, and returns the seconds that it took; None where it is not there."""
    begin = time.monotonic()
    if solver == "fenicsx":
        run = subprocess.run([sys.executable, __file__, "inside", str(case), str(case)], stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, universal_newlines=True)
    else:
        if solver == "freefem":
            with open(case / "flow.edp", "a") as script:
                script.write(FREEFEM_CELLS)
        run = subprocess.run([str(case / "Allrun")], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                             universal_newlines=True)
    if run.returncode == 77:
        return None
    if run.returncode != 0:
        raise RuntimeError("%s: %s" % (case, run.stdout[-2000:]))
    if solver != "fenicsx":
        (openfoam_result if solver == "openfoam" else freefem_result)(case).save(case / "result.npz")
    return time.monotonic() - begin


def result_of(tool, shape, surface, scratch, run):
    solver, kind, points, options = run
    case = scratch / "_".join([type(shape).__name__.lower(), solver, kind.replace(" ", "_"), str(points)])
    told = case / "told.json"
    if not told.exists():
        shutil.rmtree(case, ignore_errors=True)
        subprocess.run([tool, str(surface), "-q", "--inlet", "0,0,0", "-n", str(points), "-o", str(case), "--case", solver, "--flow-rate",
                        repr(flow_rate(shape) * 1e6), "--length-unit", "mm", "--viscosity", str(VISCOSITY), "--density",
                        str(DENSITY)] + options, check=True)
        seconds = compute(solver, case)
        if seconds is None:
            return None
        told.write_text(json.dumps({"seconds": seconds}))
    return Result.load(case / "result.npz"), json.loads(told.read_text())["seconds"]


def gradient(shape, result):
    """Of the pressure along the axis, by least squares over the cells in the window."""
    s = shape.abscissa(result.centers)
    inside = (s > shape.window[0]) & (s < shape.window[1])
    s, p, w = s[inside], result.pressures[inside], result.volumes[inside]
    s, p = s - np.average(s, weights=w), p - np.average(p, weights=w)
    return -np.sum(w * s * p) / np.sum(w * s * s) / (8 * VISCOSITY * flow_rate(shape) / (math.pi * RADIUS ** 4))


def stress_round(shape, result):
    """The mean over the exact one; the standard and the largest deviation, relative to the mean."""
    s = shape.abscissa(result.facet_centers)
    inside = (s > shape.window[0]) & (s < shape.window[1])
    axial = np.einsum("ij,ij->i", result.stresses, shape.direction(result.facet_centers))[inside]
    area = result.areas[inside]
    mean = np.average(axial, weights=area)
    deviation = math.sqrt(np.average((axial - mean) ** 2, weights=area))
    exact = 4 * VISCOSITY * flow_rate(shape) / (math.pi * RADIUS ** 3)
    return mean / exact, deviation / mean, np.abs(axial - mean).max() / mean


NAMES = {"openfoam": "OpenFOAM", "fenicsx": "FEniCSx", "freefem": "FreeFEM"}


def study(shape, a):
    a.scratch.mkdir(parents=True, exist_ok=True)
    surface = a.scratch / (type(shape).__name__.lower() + ".stl")
    write_surface(shape, surface)
    is_pipe = isinstance(shape, Pipe)
    if is_pipe:
        print("| solver | mesh | N | cells | mean | standard deviation | largest deviation | pressure gradient | s |")
        print("|---|---|---|---|---|---|---|---|---|")
    else:
        dean = shape.reynolds * math.sqrt(RADIUS / shape.bend_radius)
        white = 1 / (1 - (1 - (11.6 / dean) ** 0.45) ** 2.22)
        ito = 21.5 * dean / (1.56 + math.log10(dean)) ** 5.73
        print("Dean number %.1f; White: %.3f, Ito: %.3f\n" % (dean, white, ito))
        print("| solver | mesh | N | cells | pressure gradient | s |\n|---|---|---|---|---|---|")
    for run in shape.runs + (shape.fine if a.fine else []):
        if a.only and run[0] not in a.only:
            continue
        found = result_of(a.tool, shape, surface, a.scratch, run)
        if found is None:
            print("%s is not here" % NAMES[run[0]], file=sys.stderr)
            continue
        result, seconds = found
        row = "| %s | %s | %d | %s |" % (NAMES[run[0]], run[1], run[2], format(len(result.volumes), ","))
        if is_pipe:
            row += " %.3f | %.1f %% | %.1f %% |" % tuple(f * x for f, x in zip((1, 100, 100), stress_round(shape, result)))
        print(row + " %.3f | %.0f |" % (gradient(shape, result), seconds), flush=True)


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("shape", choices=["pipe", "bend", "inside"])
    arguments.add_argument("tool")
    arguments.add_argument("scratch", type=pathlib.Path)
    arguments.add_argument("--only", nargs="*", choices=list(NAMES))
    arguments.add_argument("--fine", action="store_true")
    a = arguments.parse_args()
    if a.shape == "inside":
        try:
            fenicsx_inside(a.scratch)
        except ImportError:
            return 77
    else:
        study(Pipe() if a.shape == "pipe" else Bend(), a)
    return 0


if __name__ == "__main__":
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    sys.exit(main())
