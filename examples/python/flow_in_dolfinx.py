#!/usr/bin/env python3
# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""From a folder of surfaces to the flow in each of them, by dolfinx (FEniCSx).

    flow_in_dolfinx.py FOLDER [--output FOLDER] [-n N] [--viscosity MU] [--flow-rate Q]

Each .stl file of FOLDER is repaired, meshed by tetrahedra, and given to dolfinx as arrays, without a file in between. The
flow is a slow one (Stokes): quadratic velocities and linear pressures, a velocity at the inlet that is normal to it and
falls off to 0 at the wall, no traction at the outlets, no slip at the wall. For each vessel the pressure drop and the flow
through each outlet are printed, and NAME.xdmf, for ParaView, has velocity and pressure.

Units are those of the surface: with millimetres, a viscosity in Pa s and a flow rate in mm³/s, pressures are in Pa.

Exit status: 0 done, 1 some surfaces could not be meshed, 77 there is no dolfinx (Debian: python3-dolfinx).
"""

import argparse
import pathlib
import sys

import numpy as np

import tubular_meshing as tm

try:
    import dolfinx.io.utils
    import ufl
    from dolfinx import fem
    from dolfinx.fem.petsc import LinearProblem
    from mpi4py import MPI
except ImportError as missing:
    print(f"Skipped: {missing}")
    sys.exit(77)


def to_dolfinx(mesh):
    """The tetrahedra of a mesh and the patches of its boundary, as dolfinx has them."""
    cells = mesh.cells["tetra"].astype(np.int64)
    shape = ufl.Mesh(ufl.VectorElement("Lagrange", "tetrahedron", 1))
    domain = dolfinx.mesh.create_mesh(MPI.COMM_SELF, cells, np.array(mesh.points), shape)
    facets, patches = mesh.facets["triangle"].astype(np.int64), np.array(mesh.facet_patches["triangle"])
    entities, values = dolfinx.io.utils.distribute_entity_data(domain, 2, facets, patches)
    domain.topology.create_connectivity(2, 0)
    domain.topology.create_connectivity(2, 3)
    adjacency = dolfinx.cpp.graph.AdjacencyList_int32(entities)
    return domain, dolfinx.mesh.meshtags_from_entities(domain, 2, adjacency, values)


def profile(opening, rim):
    """A velocity into the lumen, 1 - (r / R)² with R the distance to the rim in the direction of r."""
    axes = np.linalg.svd(opening.normal[None, :])[2][1:]  # of the opening's plane
    angle = lambda x: np.arctan2(*((x - opening.center) @ axes.T).T)  # noqa: E731
    order = np.argsort(angle(rim))
    at, radius = angle(rim)[order], np.linalg.norm(rim - opening.center, axis=1)[order]

    def velocity(x):
        r = np.linalg.norm(x.T - opening.center, axis=1)
        share = np.clip(r / np.interp(angle(x.T), at, radius, period=2 * np.pi), 0, 1)
        return -np.outer(opening.normal, 1 - share**2)

    return velocity


def solve(mesh, openings, viscosity, flow_rate):
    """Velocity and pressure; the pressure drop from the inlet, and the flow out of each outlet, by its name."""
    domain, tags = to_dolfinx(mesh)
    quadratic = ufl.VectorElement("Lagrange", domain.ufl_cell(), 2)
    linear = ufl.FiniteElement("Lagrange", domain.ufl_cell(), 1)
    space = fem.FunctionSpace(domain, ufl.MixedElement(quadratic, linear))
    velocities, _ = space.sub(0).collapse()
    normal, ds = ufl.FacetNormal(domain), ufl.Measure("ds", domain=domain, subdomain_data=tags)

    inlet = openings[0]
    rim = np.intersect1d(mesh.patches[inlet.name].points, mesh.patches["wall"].points)
    at_inlet, at_wall = fem.Function(velocities), fem.Function(velocities)
    at_inlet.interpolate(profile(inlet, mesh.points[rim]))
    wall = tags.find(mesh.patches["wall"].label)
    at_inlet.x.array.reshape(-1, 3)[fem.locate_dofs_topological(velocities, 2, wall)] = 0  # the rim is at rest
    through_inlet = fem.assemble_scalar(fem.form(-ufl.inner(at_inlet, normal) * ds(inlet.patch)))
    at_inlet.x.array[:] *= flow_rate / through_inlet
    conditions = []
    for value, facets in ((at_inlet, tags.find(inlet.patch)), (at_wall, wall)):
        dofs = fem.locate_dofs_topological((space.sub(0), velocities), 2, facets)
        conditions.append(fem.dirichletbc(value, dofs, space.sub(0)))

    (u, p), (v, q) = ufl.TrialFunctions(space), ufl.TestFunctions(space)
    a = viscosity * ufl.inner(ufl.grad(u), ufl.grad(v)) * ufl.dx - p * ufl.div(v) * ufl.dx - q * ufl.div(u) * ufl.dx
    right = ufl.inner(fem.Constant(domain, np.zeros(3)), v) * ufl.dx
    options = {"ksp_type": "preonly", "pc_type": "lu", "pc_factor_mat_solver_type": "mumps"}
    solution = LinearProblem(a, right, conditions, petsc_options=options).solve()

    velocity, pressure = solution.sub(0).collapse(), solution.sub(1).collapse()
    integral = lambda f, o: fem.assemble_scalar(fem.form(f * ds(o.patch)))  # noqa: E731
    area = {o.name: integral(fem.Constant(domain, 1.0), o) for o in openings}
    mean = {o.name: integral(pressure, o) / area[o.name] for o in openings}
    flow = {o.name: integral(ufl.inner(velocity, normal), o) for o in openings[1:]}
    drop = {name: mean[inlet.name] - mean[name] for name in flow}
    return velocity, pressure, drop, flow


def write(file, velocity, pressure):
    """At the vertices of the mesh, which is what ParaView shows."""
    domain = velocity.function_space.mesh
    shown = fem.Function(fem.VectorFunctionSpace(domain, ("Lagrange", 1)), name="velocity")
    shown.interpolate(velocity)
    pressure.name = "pressure"
    with dolfinx.io.XDMFFile(domain.comm, str(file), "w") as out:
        out.write_mesh(domain)
        out.write_function(shown)
        out.write_function(pressure)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("."))
    parser.add_argument("-n", "--points-per-circumference", type=float, default=12)
    parser.add_argument("--viscosity", type=float, default=0.0035)
    parser.add_argument("--flow-rate", type=float, default=1000)
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)

    failed = 0
    for file in sorted(arguments.folder.glob("*.stl")):
        try:
            surface, repairs = tm.repair(file)
            model = tm.Model(surface)
            mesh = tm.mesh(model, points_per_circumference=arguments.points_per_circumference)
        except tm.Error as e:
            print(f"{file.name}: {e}")
            failed += 1
            continue
        for repair in repairs:
            print(f"{file.name}: {repair.sentence}")
        velocity, pressure, drop, flow = solve(mesh, model.openings, arguments.viscosity, arguments.flow_rate)
        print(f"{file.name}: {len(mesh.cells['tetra'])} tetrahedra, flow in {arguments.flow_rate:g}")
        for name in flow:
            print(f"  {name}: flow {flow[name]:.6g}, pressure drop {drop[name]:.6g}")
        write(arguments.output / f"{file.stem}.xdmf", velocity, pressure)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
