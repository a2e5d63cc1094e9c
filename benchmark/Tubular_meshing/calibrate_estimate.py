#!/usr/bin/env python3
# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the coefficients of Mesh_estimate: the numbers of elements of meshes of generated shapes, as linear functions of
the integrals that `tubular_mesh --dry-run` reports.

    calibrate_estimate.py FOLDER_OF_PROGRAMS SCRATCH [--check SURFACE...] [--types TYPE...]

FOLDER_OF_PROGRAMS has tubular_mesh and generate_tubular_surface. What is in SCRATCH from an earlier run is used again.
With --check, nothing is fitted: the estimates of the given surfaces are compared with their meshes."""

import argparse
import itertools
import json
import os
import subprocess
import sys

import numpy as np

SHAPES = {
    "tube": ["tube"], "curved": ["curved"], "y": ["y"], "arch": ["arch"], "willis": ["willis"],
    "tree": ["tree", "--branches", "15"], "rough": ["y", "--noise", "0.05"],
}
POINTS = [8, 12, 16, 20, 24, 32]
LAYERS = [["--boundary-layer-prisms", "3", "--first-height", "0.02"],
          ["--boundary-layer-prisms", "4", "--first-height", "0.05"],
          ["--boundary-layer-prisms", "5", "--first-height", "0.06", "--growth", "1.2"]]
TYPES = {
    "isotropic": [[]],
    "layers": LAYERS,
    "mixed": [["-t", "mixed"]],
    "mixed_layers": [["-t", "mixed"] + layers for layers in LAYERS],
    "anisotropic": [["-t", "anisotropic"], ["-t", "anisotropic", "--first-height", "0.05"],
                    ["-t", "anisotropic", "--boundary-layer", "0.2"]],
    "blocks": [["-t", "hexahedral"], ["-t", "hexahedral"] + LAYERS[0]],
    "subdivision": [["-t", "hexahedral", "--hex-method", "subdivision"],
                    ["-t", "hexahedral", "--hex-method", "subdivision"] + LAYERS[1]],
    "surface": [["-t", "surface"]],
    "quads": [["-t", "surface", "--surface-elements", "quads"]],
    "anisotropic_surface": [["-t", "surface", "--surface-elements", "anisotropic"]],
}


def run(tool, scratch, surface, points, options):
    """The report of a dry run, and that of the mesh; None where there is no mesh."""
    name = "_".join([os.path.splitext(os.path.basename(surface))[0], str(points)] + [o.strip("-") for o in options])
    reports = []
    for dry in (True, False):
        report = os.path.join(scratch, name + ("_dry" if dry else "") + ".json")
        if not os.path.exists(report):
            output = os.path.join(scratch, "mesh" + (".stl" if "surface" in options else ".vtu"))
            command = [tool, surface, "-q", "-n", str(points), "--report", report] + options
            command += ["--dry-run"] if dry else ["-o", output]
            done = subprocess.run(command, stderr=subprocess.PIPE, universal_newlines=True)
            if done.returncode != 0:
                print("%s: %s" % (name, done.stderr.strip()[-200:]), file=sys.stderr)
                return None
        with open(report) as file:
            reports.append(json.load(file))
    return name, reports[0], reports[1]


def fit(columns, wanted):
    """Least squares of the relative errors; the worst of these comes along."""
    a, y = np.array(columns, float), np.array(wanted, float)
    x = np.linalg.lstsq(a / y[:, None], np.ones(len(y)), rcond=None)[0]
    errors = a @ x / y - 1
    return x, errors


def show(title, names, columns, wanted, labels):
    x, errors = fit(columns, wanted)
    worst = int(np.argmax(np.abs(errors)))
    print("%-32s %s   worst %+.1f %% (%s), root mean square %.1f %%" % (
        title, "  ".join("%s %.4f" % p for p in zip(names, x)), 100 * errors[worst], labels[worst],
        100 * np.sqrt(np.mean(errors ** 2))))
    return x


def boundary(mesh):
    """Facets on the wall and on the openings."""
    caps = {k: sum(o[k] for o in mesh["openings"]) for k in ("triangles", "quads")}
    return {k: (mesh["facets"][k] - caps[k], caps[k]) for k in caps}


def fit_all(results):
    for kind, runs in results.items():
        if not runs:
            continue
        labels = [r[0] for r in runs]
        integrals = [r[1]["estimate"]["integrals"] for r in runs]
        tetrahedra = [r[2]["cells"]["tetrahedra"] for r in runs]
        facets = [boundary(r[2]) for r in runs]
        metric = kind.startswith("anisotropic")
        cubes = [n["metric_cubes" if metric else "inner_cubes"] for n in integrals]
        squares = [n["metric_wall" if metric else "wall_squares"] for n in integrals]
        caps = [n["metric_caps" if metric else "cap_squares"] for n in integrals]
        rims = [n["rims"] for n in integrals]
        layers = [n["layer_thickness"] for n in integrals]
        one = [[s] for s in squares]
        if kind in ("mixed", "mixed_layers", "quads"):
            show(kind + ": quads on the wall", ["square"], one, [f["quads"][0] for f in facets], labels)
        elif kind in ("isotropic", "layers", "anisotropic", "surface", "anisotropic_surface"):
            show(kind + ": triangles on the wall", ["square"], one, [f["triangles"][0] for f in facets], labels)
        if metric:
            show(kind + ": on openings", ["square"], [[c] for c in caps], [f["triangles"][1] for f in facets], labels)
        elif kind in ("isotropic", "layers", "mixed", "mixed_layers", "quads", "surface"):
            show(kind + ": on openings", ["square", "rim"], list(zip(caps, rims)), [f["triangles"][1] for f in facets], labels)
        if kind == "anisotropic":
            show("anisotropic: tetrahedra", ["cube"], [[c] for c in cubes], tetrahedra, labels)
        elif kind == "isotropic":
            show("isotropic: tetrahedra", ["cube", "square of wall", "square of openings"], list(zip(cubes, squares, caps)),
                 tetrahedra, labels)
        elif kind == "mixed":
            show("mixed: tetrahedra", ["cube", "square"], list(zip(cubes, squares)), tetrahedra, labels)
        elif kind in ("layers", "mixed_layers"):
            power = 2 if kind == "layers" else 1
            show(kind + ": tetrahedra", ["cube", "square", "square and thickness"],
                 [[c, s, s * t ** power] for c, s, t in zip(cubes, squares, layers)], tetrahedra, labels)


def compare(results):
    worst = 0.
    for runs in results.values():
        for name, dry, mesh in runs:
            surface = mesh["type"] == "surface"
            guess, truth = dry["estimate"]["facets" if surface else "cells"], mesh["facets" if surface else "cells"]
            guess, truth = sum(guess.values()), sum(truth.values())
            by_kind = ", ".join("%s %d of %d" % (k, v, mesh["facets" if surface else "cells"][k]) for k, v in
                                dry["estimate"]["facets" if surface else "cells"].items() if v or mesh["facets" if surface else "cells"][k])
            error = guess / truth - 1
            worst = max(worst, abs(error))
            print("%-70s %+6.1f %%  %s   %.0f s of %.0f, %.0f MB of %.0f" % (
                name, 100 * error, by_kind, dry["estimate"]["seconds"] + dry["total_time"], mesh["total_time"],
                dry["estimate"]["memory_bytes"] / 1e6, mesh["peak_memory_bytes"] / 1e6))
    print("worst: %.1f %%" % (100 * worst))
    return 0 if worst <= 0.15 else 1


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("programs")
    arguments.add_argument("scratch")
    arguments.add_argument("--check", nargs="+", metavar="SURFACE")
    arguments.add_argument("--types", nargs="+", default=list(TYPES), choices=list(TYPES))
    arguments.add_argument("--points", nargs="+", type=int, default=POINTS)
    a = arguments.parse_args()
    os.makedirs(a.scratch, exist_ok=True)
    tool = os.path.join(a.programs, "tubular_mesh")
    surfaces = a.check or []
    if not a.check:
        for name, shape in SHAPES.items():
            surfaces.append(os.path.join(a.scratch, name + ".stl"))
            if not os.path.exists(surfaces[-1]):
                subprocess.run([os.path.join(a.programs, "generate_tubular_surface")] + shape + ["-o", surfaces[-1]], check=True)
    results = {}
    for kind in a.types:
        runs = [run(tool, a.scratch, s, n, o) for s, n, o in itertools.product(surfaces, a.points, TYPES[kind])]
        results[kind] = [r for r in runs if r]
    if a.check:
        return compare(results)
    fit_all(results)
    compare(results)
    return 0


if __name__ == "__main__":
    sys.exit(main())
