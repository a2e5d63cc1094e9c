# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of blood vessels and airways, from their triangulated surface: the library Tubular_meshing for Python.

    import tubular_meshing as tm

    surface = tm.read_surface("aorta.stl")
    surface, repairs = tm.repair(surface)
    model = tm.Model(surface)
    mesh = tm.mesh(model, type="hexahedral", points_per_circumference=24, boundary_layer=0.3)
    mesh.write("aorta.vtu")

Lengths are in the unit of the surface. Every option of the program tubular_mesh, but for those of
quadratic elements and of meshes in parts, is a keyword argument of its name, with _
for -, and means the same; help(tm.mesh) lists them.
"""

from . import _core
from ._errors import Error, InputError, MeshingError, OutputError, ParameterError
from ._mesh import Mesh, Patch, Region, mesh
from ._model import Branch, Centerlines, Model, Opening, Sections
from ._options import option_names
from ._surface import Repair, Surface, read_surface, repair

__version__: str = _core.version


def mesh_formats() -> list[str]:
    """The names of the formats that Mesh.write() knows."""
    return _core.mesh_formats()


__all__ = [
    "Branch",
    "Centerlines",
    "Error",
    "InputError",
    "Mesh",
    "MeshingError",
    "Model",
    "Opening",
    "OutputError",
    "ParameterError",
    "Patch",
    "Region",
    "Repair",
    "Sections",
    "Surface",
    "mesh",
    "mesh_formats",
    "option_names",
    "read_surface",
    "repair",
]
