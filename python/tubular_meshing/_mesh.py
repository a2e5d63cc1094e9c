# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes: how they are made, and what they have."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple, NoReturn, Optional, TypeVar, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._errors import ParameterError
from ._model import Model
from ._options import Path, Point, Progress, arguments_of, check_known, given, has_options, keywords_of
from ._surface import Surface

Value = TypeVar("Value")
CELLS = ("tetra", "pyramid", "wedge", "hexahedron")
FACETS = ("triangle", "quad")


class Lazy(Mapping[str, Value]):
    """A mapping whose values are made when they are first asked for."""

    def __init__(self, what: str, names: Sequence[str], make: Callable[[str], Value]) -> None:
        self._what, self._names, self._make = what, list(names), make
        self._made: dict[str, Value] = {}

    def __getitem__(self, name: str) -> Value:
        if name not in self._made:
            if name not in self._names:
                raise KeyError(f"the mesh has no {self._what} {name!r}: it has {', '.join(self._names) or 'none'}")
            self._made[name] = self._make(name)
        return self._made[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)

    def __repr__(self) -> str:
        return f"<{self._what}: {', '.join(self._names) or 'none'}>"


class Patch(NamedTuple):
    """The facets of a mesh with one label: the wall, an opening."""

    name: str
    label: int
    triangles: NDArray[np.uint32]  #: indices of points, of shape (m, 3)
    quads: NDArray[np.uint32]  #: indices of points, of shape (m, 4)
    points: NDArray[np.uint32]  #: the indices of all its points, sorted
    area: float  #: in the square of the unit of the surface
    normal: NDArray[np.float64]  #: the sum of its facets' area vectors, as a unit vector out of the lumen, of shape (3,)


class Region(NamedTuple):
    """The cells of a mesh with one label: the lumen, the wall."""

    name: str
    label: int
    cells: dict[str, NDArray[np.int64]]  #: of each kind their numbers among the cells of this kind


class Mesh:
    """A mesh of cells with its boundary, or a surface mesh. Arrays are read-only views of the mesh, not copies.

    Attributes
    ----------
    points : array of shape (n, 3)
        Coordinates, in the unit of the surface.
    cells : mapping
        By kind, as meshio calls them (``tetra``, ``pyramid``, ``wedge``, ``hexahedron``), the indices of the points of
        each cell, of shape (m, 4), (m, 5), (m, 6) or (m, 8). Their order makes volumes positive: the first face turns
        counterclockwise seen from the rest of the cell. It is that of Gmsh and meshio; to_vtk() has VTK's, whose wedges differ.
    facets : mapping
        Likewise those of the boundary and of interfaces between regions: ``triangle`` and ``quad``.
    cell_regions, facet_patches : mapping
        Of each kind the labels of the cells, and of the facets, of shape (m,).
    patches, regions : mapping
        By name, see Patch and Region.
    quality : mapping
        By measure, the values of all elements that it is a measure of, in their order: ``gamma_tau`` of tetrahedra,
        ``scaled_jacobian`` and ``zeta_H`` of hexahedra, ``gamma_T`` of triangles, ``eta_q`` of quads,
        ``prism_jacobian``, ``pyramid_jacobian``, ``Q_tau`` in a metric, ``aspect`` of cells (of all kinds, in the order of
        `cells`), ``non_orthogonality`` (degrees) and ``skewness`` of faces between cells.
    point_arrays : dict
        Values at the points by name, each of shape (n, number of components).
    cell_arrays : dict
        Values of cells by name, of all kinds in the order of `cells`, each of shape (m, number of components): with
        ``fibres=True``, ``circumferential`` and ``longitudinal``, which are 0 in the lumen.
    report : dict
        What ``tubular_mesh --report`` writes.
    fallbacks : list of str
        A sentence each time another way was taken than the one chosen, and why.
    """

    def __init__(self, core: _core.Mesh) -> None:
        self._core = core
        self._report: Optional[dict[str, Any]] = None
        self.points: NDArray[np.float64] = core.points
        elements = {kind: core.elements(kind) for kind in CELLS + FACETS}
        there = {kind: pair for kind, pair in elements.items() if len(pair[0])}
        cells, facets = [k for k in CELLS if k in there], [k for k in FACETS if k in there]
        self.cells: Mapping[str, NDArray[np.uint32]] = Lazy("cells", cells, lambda k: there[k][0])
        self.facets: Mapping[str, NDArray[np.uint32]] = Lazy("facets", facets, lambda k: there[k][0])
        self.cell_regions: Mapping[str, NDArray[np.int32]] = Lazy("cells", cells, lambda k: there[k][1])
        self.facet_patches: Mapping[str, NDArray[np.int32]] = Lazy("facets", facets, lambda k: there[k][1])
        self.patches: Mapping[str, Patch] = Lazy("patch", list(core.patch_names.values()), self._patch)
        self.regions: Mapping[str, Region] = Lazy("region", list(core.region_names.values()), self._region)
        self.quality: Mapping[str, NDArray[np.float64]] = Lazy("measure of quality", core.measures, core.quality)
        self.point_arrays: dict[str, NDArray[np.float64]] = core.point_arrays
        self.cell_arrays: dict[str, NDArray[np.float64]] = core.cell_arrays
        self.fallbacks: list[str] = core.fallbacks

    @property
    def report(self) -> dict[str, Any]:
        if self._report is None:
            self._report = json.loads(self._core.json_report())
        return self._report

    def print_summary(self, verbose: bool = False) -> None:
        """Prints what tubular_mesh prints."""
        self._core.print_summary(verbose)

    def write(self, file: Path, format: Optional[str] = None) -> None:
        """Writes the mesh in the format that the name of the file, or folder, tells, or that is given.

        Of cells: .vtu .msh .mesh .inp .su2 .feb .cas .xdmf .cgns .exo, a folder polyMesh or mesh-complete, or one of
        ``tubular_meshing.mesh_formats()``. Of a surface: .stl .vtp .msh .ply .off .obj .vtk. The file is written whole,
        or not at all. changes_in() says what a format changes.
        """
        self._core.write(os.fspath(file), format or "")

    def write_surface(self, file: Path) -> None:
        """Writes the closed, labelled surface that was meshed, or, if that was not kept, as it came."""
        self._core.write_surface(os.fspath(file))

    def changes_in(self, file: Path, format: Optional[str] = None) -> list[str]:
        """What a format changes of the mesh or leaves out, a sentence each."""
        return self._core.changes_in(os.fspath(file), format or "")

    def to_meshio(self) -> Any:
        """As a meshio.Mesh, with cell data ``region`` and ``patch``; needs meshio."""
        from ._interchange import to_meshio

        return to_meshio(self)

    def to_vtk(self) -> Any:
        """As a vtkUnstructuredGrid, with cell arrays ``region`` and ``patch``; needs VTK."""
        from ._interchange import to_vtk

        return to_vtk(self)

    def to_pyvista(self) -> Any:
        """As a pyvista.UnstructuredGrid, with cell arrays ``region`` and ``patch``; needs PyVista."""
        from ._interchange import to_pyvista

        return to_pyvista(self)

    def _patch(self, name: str) -> Patch:
        label = next(label for label, n in self._core.patch_names.items() if n == name)
        parts = []
        for kind, columns in (("triangle", 3), ("quad", 4)):
            facets = self.facets.get(kind, np.empty((0, columns), dtype=np.uint32))
            parts.append(facets[self.facet_patches[kind] == label] if len(facets) else facets)
        triangles, quads = parts
        halves = np.concatenate([triangles, quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
        p, q, r = (self.points[halves[:, i]] for i in range(3))
        vectors = np.cross(q - p, r - p) / 2
        normal = vectors.sum(axis=0)
        length = np.linalg.norm(normal)
        area = float(np.linalg.norm(vectors, axis=1).sum())
        points = np.unique(np.concatenate([triangles.ravel(), quads.ravel()]))
        return Patch(name, label, triangles, quads, points, area, normal / length if length > 1e-9 * area else 0 * normal)

    def _region(self, name: str) -> Region:
        label = next(label for label, n in self._core.region_names.items() if n == name)
        numbers = {kind: np.flatnonzero(self.cell_regions[kind] == label) for kind in self.cells}
        return Region(name, label, {kind: n for kind, n in numbers.items() if len(n)})

    def __repr__(self) -> str:
        kinds = {**self.cells} or {**self.facets}
        counts = ", ".join(f"{len(v)} {kind}" for kind, v in kinds.items())
        return f"<tubular_meshing.Mesh of {len(self.points)} points, {counts}>"


@has_options("progress")
def mesh(
    model: Union[Model, Surface, Path, Any],
    *,
    type: Optional[str] = None,
    surface_elements: Optional[str] = None,
    points_per_circumference: Optional[float] = None,
    elements: Optional[float] = None,
    min_size: Optional[float] = None,
    max_size: Optional[float] = None,
    gradation: Optional[float] = None,
    refine: Union[Sequence[Any], str, None] = None,
    refine_branch: Union[Mapping[int, float], Sequence[Any], str, None] = None,
    size_array: Optional[str] = None,
    preserve_volume: Optional[bool] = None,
    surface_mesher: Optional[str] = None,
    volume_mesher: Optional[str] = None,
    hex_method: Optional[str] = None,
    hex_fallback: Optional[str] = None,
    wall: Optional[float] = None,
    wall_thickness: Optional[float] = None,
    wall_thickness_array: Optional[str] = None,
    wall_thickness_table: Optional[Path] = None,
    wall_layers: Optional[int] = None,
    wall_growth: Optional[float] = None,
    wall_elements: Optional[str] = None,
    second_wall: Optional[float] = None,
    second_wall_thickness: Optional[float] = None,
    second_wall_layers: Optional[int] = None,
    second_wall_growth: Optional[float] = None,
    material_array: Optional[str] = None,
    fibres: Optional[bool] = None,
    boundary_layer_prisms: Optional[int] = None,
    boundary_layer: Optional[float] = None,
    first_height: Optional[float] = None,
    growth: Optional[float] = None,
    smoothing_ratio: Optional[float] = None,
    curvature_points: Optional[float] = None,
    rename: Union[Mapping[str, str], Sequence[str], str, None] = None,
    output: Optional[Path] = None,
    format: Optional[str] = None,
    report: Union[Path, Sequence[Path], None] = None,
    report_budget: Optional[float] = None,
    picture: Optional[Path] = None,
    clip: Union[str, Sequence[float], None] = None,
    picture_view: Optional[Point] = None,
    picture_color: Optional[str] = None,
    picture_size: Union[str, Sequence[int], None] = None,
    write_surface: Optional[Path] = None,
    write_centerlines: Optional[Path] = None,
    write_blocks: Optional[Path] = None,
    threads: Optional[int] = None,
    verbose: Optional[bool] = None,
    quiet: Optional[bool] = None,
    centerlines: Union[Path, Sequence[ArrayLike], None] = None,
    inlet: Optional[Point] = None,
    outlet: Union[Point, Sequence[Point], None] = None,
    seeds: Union[Path, ArrayLike, None] = None,
    cut_ends: Optional[bool] = None,
    keep_end: Union[Point, Sequence[Point], None] = None,
    openings: Optional[int] = None,
    allow_single_opening: Optional[bool] = None,
    loops: Optional[bool] = None,
    no_loops: Optional[bool] = None,
    flow_extensions: Optional[float] = None,
    faces: Optional[str] = None,
    repair: Optional[str] = None,
    parts: Union[str, int, None] = None,
    fill: Union[Point, Sequence[Point], None] = None,
    smooth: Optional[bool] = None,
    progress: Optional[Progress] = None,
    **unknown: NoReturn,
) -> Mesh:
    """Makes a mesh of a model; or of a surface, of which a Model is made first, by the options of that class.

    A mesh is a function of the surface and the options: the same again is the same mesh. Files that options name
    (`output`, `report`, …) are written all or none. Nothing is printed unless `verbose` is true or `quiet` is false.

    Python's lock is released meanwhile: other threads run on, and make other meshes, of the same model too. `progress`
    is called with the name of each stage as it begins; what it raises ends the work, and so does Ctrl-C in the main
    thread, as KeyboardInterrupt.

    Raises ParameterError for options that are wrong, InputError where the surface cannot be used, MeshingError where no
    valid mesh comes out, OutputError where a file cannot be written; a misspelt option is a TypeError.
    """
    options = dict(locals())
    check_known(_mesh, unknown)
    own = given(options, ("model", "progress", "unknown"))
    of_model: dict[str, Any] = {name: own.pop(name) for name in keywords_of(Model.__init__) if name in own and name != "threads"}
    if isinstance(model, Model):
        if of_model:
            raise ParameterError(f"The model is made already: give {next(iter(of_model))} to Model().")
    else:
        _core.check_options(arguments_of(_of_tool(own)), output is not None)  # before any work
        model = Model(model, progress=progress, threads=threads, **of_model)
    prints = bool(verbose) or quiet is False
    arguments = arguments_of(_of_tool({**model._options, **own}))
    return Mesh(_core.mesh(model._core, arguments, model._source, prints, progress))


_mesh = mesh


def _of_tool(options: dict[str, object]) -> dict[str, object]:
    """Without what stands for the default: to be quiet, or not to be."""
    return {name: value for name, value in options.items() if name != "quiet"}
