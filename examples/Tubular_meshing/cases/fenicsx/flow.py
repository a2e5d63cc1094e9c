#!/usr/bin/env python3
"""Steady laminar flow by dolfinx (FEniCSx), from the mesh beside this file: python3 flow.py

Quadratic velocities and linear pressures (of hexahedra, too); Newton's method, from the Stokes flow on. case.json has the
fluid and the patches, in metres, kilograms, seconds and pascals. Velocity, pressure and the shear stress
at the walls go to flow.xdmf, for ParaView.

Exit status: 0 done, 1 no convergence, 77 there is no dolfinx (Debian: python3-dolfinx)."""

import json
import pathlib
import sys

import numpy as np

try:
    import dolfinx
    import ufl
    from dolfinx import fem
    import dolfinx.fem.petsc
    from dolfinx.fem.petsc import LinearProblem
    from mpi4py import MPI
except ImportError as missing:
    print(f"Skipped: {missing}")
    sys.exit(77)

FOLDER = pathlib.Path(__file__).resolve().parent


def element(kind, cell, degree):
    """Lagrange's, of a scalar or a vector, in dolfinx of any year; of degree 0 constants of cells."""
    family = "Lagrange" if degree > 0 else "DG"
    if hasattr(ufl, "VectorElement"):
        return (ufl.VectorElement if kind == "vector" else ufl.FiniteElement)(family, cell, degree)
    import basix.ufl

    return basix.ufl.element(family, cell.cellname(), degree, shape=(3,) if kind == "vector" else ())


def mixed(*parts):
    if hasattr(ufl, "MixedElement"):
        return ufl.MixedElement(*parts)
    import basix.ufl

    return basix.ufl.mixed_element(list(parts))


def space_of(domain, form):
    return getattr(fem, "functionspace", getattr(fem, "FunctionSpace", None))(domain, form)


def profile(inlet):
    """A velocity into the lumen, 1 - (r / R)² with R the distance to the rim in the direction of r."""
    center, inward = np.array(inlet["center"]), np.array(inlet["inward"])
    axes, rim = np.array(inlet["axes"]), np.array(inlet["rim"])
    angles = 2 * np.pi * np.arange(len(rim)) / len(rim)

    def velocity(x):
        u, v = axes @ (x.T - center).T
        radius = np.interp(np.arctan2(v, u), angles, rim, period=2 * np.pi)
        return np.outer(inward, np.clip(1 - (u**2 + v**2) / radius**2, 0, None))

    return velocity


class NotConverged(Exception):
    """The flow may not be steady."""


class Flow:
    """The mesh with the tags of its facets, the velocity and the pressure, in SI units."""

    def __init__(self, case, domain, tags, velocity, pressure):
        self.case, self.domain, self.tags = case, domain, tags
        self.velocity, self.pressure = velocity, pressure
        self.ds, self.normal = ufl.Measure("ds", domain=domain, subdomain_data=tags), ufl.FacetNormal(domain)

    def integral(self, form):
        return self.domain.comm.allreduce(fem.assemble_scalar(fem.form(form)), op=MPI.SUM)

    def shear_stress(self):
        """The force of the flow along the walls, over their area: a vector a cell, the mean over its facets there; 0 in
        cells without one."""
        flat = space_of(self.domain, element("vector", self.domain.ufl_cell(), 0))
        test, stress = ufl.TestFunction(flat), fem.Function(flat, name="wall_shear_stress")
        u, n = self.velocity, self.normal
        force = -self.case["viscosity"] * ufl.dot(ufl.grad(u) + ufl.grad(u).T, n)
        along = force - ufl.dot(force, n) * n
        walls = [self.ds(wall["label"]) for wall in self.case["walls"]]
        forces = fem.petsc.assemble_vector(fem.form(sum(ufl.inner(along, test) * w for w in walls))).array
        one = fem.Constant(self.domain, (1.0, 1.0, 1.0))
        areas = fem.petsc.assemble_vector(fem.form(sum(ufl.inner(one, test) * w for w in walls))).array
        stress.x.array[: len(forces)] = np.divide(forces, areas, out=np.zeros_like(forces), where=areas > 0)
        return stress


def solve():
    """The flow of the case. Raises NotConverged."""
    case = json.loads((FOLDER / "case.json").read_text())
    with dolfinx.io.XDMFFile(MPI.COMM_WORLD, str(FOLDER / "mesh.xdmf"), "r") as file:
        domain = file.read_mesh(name="mesh")
        domain.topology.create_connectivity(2, 0)
        domain.topology.create_connectivity(2, 3)
        tags = file.read_meshtags(domain, name="facet_tags")
    vector, scalar = element("vector", domain.ufl_cell(), 2), element("scalar", domain.ufl_cell(), 1)
    space = space_of(domain, mixed(vector, scalar))
    velocities, _ = space.sub(0).collapse()
    ds, normal = ufl.Measure("ds", domain=domain, subdomain_data=tags), ufl.FacetNormal(domain)

    def integral(form):
        return domain.comm.allreduce(fem.assemble_scalar(fem.form(form)), op=MPI.SUM)

    conditions = []

    def impose(value, label):
        dofs = fem.locate_dofs_topological((space.sub(0), velocities), 2, tags.find(label))
        conditions.append(fem.dirichletbc(value, dofs, space.sub(0)))

    at_rest = fem.Function(velocities)
    for inlet in case["inlets"]:
        value = fem.Function(velocities)
        value.interpolate(profile(inlet))
        for wall in case["walls"]:
            value.x.array.reshape(-1, 3)[fem.locate_dofs_topological(velocities, 2, tags.find(wall["label"]))] = 0
        value.x.array[:] *= case["flow_rate"] / integral(-ufl.inner(value, normal) * ds(inlet["label"]))
        impose(value, inlet["label"])
    for wall in case["walls"]:
        impose(at_rest, wall["label"])

    mu, rho = case["viscosity"], case["density"]
    (u, p), (v, q) = ufl.TrialFunctions(space), ufl.TestFunctions(space)
    solution = fem.Function(space)
    w = ufl.split(solution)[0]
    inertia = fem.Constant(domain, 0.0)
    left = mu * ufl.inner(ufl.grad(u), ufl.grad(v)) * ufl.dx - p * ufl.div(v) * ufl.dx - q * ufl.div(u) * ufl.dx
    left += inertia * rho * ufl.inner(ufl.dot(ufl.grad(u), w) + ufl.dot(ufl.grad(w), u), v) * ufl.dx
    right = inertia * rho * ufl.inner(ufl.dot(ufl.grad(w), w), v) * ufl.dx
    for outlet in case["outlets"]:
        right -= fem.Constant(domain, float(outlet["pressure"])) * ufl.inner(normal, v) * ds(outlet["label"])
    options = {"ksp_type": "preonly", "pc_type": "lu", "pc_factor_mat_solver_type": "mumps"}
    problem = LinearProblem(left, right, conditions, petsc_options=options)
    change = 1.0
    for step in range(20):
        following = problem.solve()
        size = np.linalg.norm(following.x.array)
        change = np.linalg.norm(following.x.array - solution.x.array) / size if size > 0 else 0.0
        solution.x.array[:] = following.x.array
        print(f"step {step}: change {change:.3g}")
        if change < 1e-6:
            break
        inertia.value = 1.0
    if not change < 1e-6:
        raise NotConverged()
    return Flow(case, domain, tags, solution.sub(0).collapse(), solution.sub(1).collapse())


def main():
    try:
        flow = solve()
    except NotConverged:
        print("The flow has not converged: it may not be steady.")
        return 1
    case, domain, velocity, pressure = flow.case, flow.domain, flow.velocity, flow.pressure
    ds, normal, integral = flow.ds, flow.normal, flow.integral
    for opening in case["inlets"] + case["outlets"]:
        area = integral(fem.Constant(domain, 1.0) * ds(opening["label"]))
        print(f"{opening['name']}: mean pressure {integral(pressure * ds(opening['label'])) / area:.6g} Pa")
        print(f"{opening['name']}: {integral(ufl.inner(velocity, normal) * ds(opening['label'])):.6g} m3/s")
    degree = getattr(domain.ufl_domain().ufl_coordinate_element(), "degree", 1)
    degree = degree() if callable(degree) else degree
    shown = fem.Function(space_of(domain, element("vector", domain.ufl_cell(), degree)), name="velocity")
    shown.interpolate(velocity)
    pressures = fem.Function(space_of(domain, element("scalar", domain.ufl_cell(), degree)), name="pressure")
    pressures.interpolate(pressure)
    with dolfinx.io.XDMFFile(domain.comm, str(FOLDER / "flow.xdmf"), "w") as out:
        out.write_mesh(domain)
        out.write_function(shown)
        out.write_function(pressures)
        out.write_function(flow.shear_stress())
    return 0


if __name__ == "__main__":
    sys.exit(main())
