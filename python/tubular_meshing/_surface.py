# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces, as they come and repaired."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, NoReturn, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._errors import InputError, ParameterError
from ._options import Path, Point, Progress, arguments_of, array_of, check_known, given, has_options, points_as_seeds


@dataclass(frozen=True)
class Repair:
    """One kind of repair that was done, or of a finding that is only reported."""

    defect: str  #: what was wrong, such as ``"pinholes"``
    count: int  #: of the points, triangles, edges, gaps, holes, islands or handles concerned
    size: float  #: the largest extent concerned, in the unit of the surface; 0 if it has none
    place: Optional[NDArray[np.float64]]  #: of the first or largest one, of shape (3,), in that unit
    sentence: str  #: what was done


class Surface:
    """The triangles of a vessel or airway tree, open at its ends or closed; lengths are in any unit.

    Parameters
    ----------
    points : array of shape (n, 3)
        Or an object that has it all: of VTK or PyVista (a vtkPolyData), of meshio, or of trimesh; or a Surface.
    triangles : array of integers of shape (m, 3)
        Indices of points, from 0.
    labels : array of integers of shape (m,), optional
        Which face is which end of a vessel, as files have it in ``ModelFaceID`` and the like.
    label_names : dict from labels to names, optional
    label_array : str, optional
        The array whose conventions the labels follow: ``ModelFaceID``, ``CapID``, ``CellEntityIds`` or ``patch``.
    point_arrays : dict from names to arrays of shape (n,), optional
        Values at the points, for ``size_array``, ``wall_thickness_array`` and ``material_array``.
    cell_arrays : dict from names to arrays of shape (m,), optional
        Values of the triangles, for the latter two.
    faces : str, optional
        Of an object that has it all: its cell array that is to be the labels.
    """

    def __init__(
        self,
        points: Any,
        triangles: Optional[ArrayLike] = None,
        *,
        labels: Optional[ArrayLike] = None,
        label_names: Optional[Mapping[int, str]] = None,
        label_array: Optional[str] = None,
        point_arrays: Optional[Mapping[str, ArrayLike]] = None,
        cell_arrays: Optional[Mapping[str, ArrayLike]] = None,
        faces: Optional[str] = None,
    ) -> None:
        self._core: _core.Surface
        self._source = ""
        self._options: dict[str, object] = {}
        if isinstance(points, Surface):
            self._core = points._core
            self._source, self._options = points._source, points._options
            return
        if triangles is None:
            from ._interchange import arrays_of

            given_arrays = arrays_of(points, faces)
        else:
            given_arrays = {"points": points, "triangles": triangles}
        if labels is not None:
            given_arrays.update(labels=labels, label_array=label_array, label_names=label_names)
        if point_arrays is not None:
            given_arrays["point_arrays"] = point_arrays
        if cell_arrays is not None:
            given_arrays["cell_arrays"] = cell_arrays
        self._core = _surface_of_arrays(**given_arrays)

    @classmethod
    def _of(cls, core: _core.Surface, source: str, options: dict[str, object]) -> Surface:
        surface = cls.__new__(cls)
        surface._core, surface._source, surface._options = core, source, options
        return surface

    @property
    def points(self) -> NDArray[np.float64]:
        """Coordinates, of shape (n, 3), in the unit of the surface; read-only, and no copy unless it is repaired."""
        return self._core.points

    @property
    def triangles(self) -> NDArray[np.uint64]:
        """Indices of points, of shape (m, 3); read-only, and no copy unless it is repaired."""
        return self._core.triangles

    @property
    def labels(self) -> Optional[NDArray[np.int32]]:
        """Of each triangle, of shape (m,); None where there are none, or the triangles are those of a repair."""
        return self._core.labels

    @property
    def label_names(self) -> dict[int, str]:
        """The names of labels that have one."""
        return self._core.label_names

    @property
    def point_arrays(self) -> dict[str, NDArray[np.float64]]:
        """Values at the points as they came, each of shape (n,)."""
        return {name: np.asarray(values) for name, values in self._core.point_arrays.items()}

    @property
    def cell_arrays(self) -> dict[str, NDArray[np.float64]]:
        """Values of the triangles as they came, each of shape (m,)."""
        return {name: np.asarray(values) for name, values in self._core.cell_arrays.items()}

    @property
    def notes(self) -> list[str]:
        """A sentence for each kind of thing in the file that was skipped."""
        return self._core.notes

    @property
    def is_repaired(self) -> bool:
        """Whether it comes from repair()."""
        return self._core.is_repaired

    def __repr__(self) -> str:
        return f"<tubular_meshing.Surface of {len(self.points)} points and {len(self.triangles)} triangles>"


def _surface_of_arrays(
    points: ArrayLike,
    triangles: ArrayLike,
    labels: Optional[ArrayLike] = None,
    label_array: Optional[str] = None,
    label_names: Optional[Mapping[int, str]] = None,
    point_arrays: Optional[Mapping[str, ArrayLike]] = None,
    cell_arrays: Optional[Mapping[str, ArrayLike]] = None,
) -> _core.Surface:
    points = array_of(points, 3, "The points of a surface", float)
    triangles = array_of(triangles, 3, "The triangles of a surface", int)
    out_of_range = np.argwhere((triangles < 0) | (triangles >= len(points)))
    if len(out_of_range):
        face, corner = out_of_range[0]
        point = triangles[face, corner]
        raise InputError(f"Triangle {face} refers to point {point}, but there are only the points 0 to {len(points) - 1}.")
    infinite = np.flatnonzero(~np.isfinite(points.astype(float)).all(axis=1))
    if len(infinite):
        raise InputError(f"Point {infinite[0]} of the surface has a coordinate that is not finite.")
    if labels is not None:
        labels = np.asarray(labels)
        if labels.shape != (len(triangles),) or not np.issubdtype(labels.dtype, np.integer):
            raise ParameterError(f"The labels of {len(triangles)} triangles are as many integers.")
        if len(labels) == 0 or labels.min() == labels.max():
            labels = None  # they tell nothing apart
    arrays = {name: np.asarray(values, dtype=float) for name, values in (point_arrays or {}).items()}
    for name, values in arrays.items():
        if values.shape != (len(points),):
            raise ParameterError(f"The point array {name!r} has one number for each of the {len(points)} points.")
    of_cells = {name: np.asarray(values, dtype=float) for name, values in (cell_arrays or {}).items()}
    for name, values in of_cells.items():
        if values.shape != (len(triangles),):
            raise ParameterError(f"The cell array {name!r} has one number for each of the {len(triangles)} triangles.")
    return _core.surface_of_arrays(
        points, triangles, labels, label_array or "", dict(label_names or {}), _wall_of(labels, label_array), arrays, of_cells
    )


def _wall_of(labels: Optional[NDArray[Any]], array: Optional[str]) -> Optional[int]:
    """What the convention of an array says about the wall: the smallest of VMTK's labels, this package's first."""
    if labels is None:
        return None
    smallest = int(labels.min())
    is_vmtk = array in ("CellEntityIds", "CapID") and smallest <= 1
    return smallest if is_vmtk or (array == "patch" and smallest == 1) else None


def read_surface(file: Path, *, faces: Optional[str] = None, progress: Optional[Progress] = None) -> Surface:
    """Reads a surface: .stl .off .obj .ply .vtp .vtu .vtk .msh .mesh, in the unit of the file.

    `faces` names the cell array whose integers say which face is the wall and which are ends; where it is not given,
    ``ModelFaceID``, ``CapID``, ``CellEntityIds`` or ``patch``, solids of .stl, groups of .obj and .msh do.

    `progress` is called with the name of the stage, ``"read"``.
    """
    name = os.fspath(file)
    options: dict[str, object] = {} if faces is None else {"faces": faces}
    return Surface._of(_core.read_surface(name, faces or "", progress), name, options)


@has_options("progress")
def repair(
    surface: Union[Surface, Path, Any],
    *,
    repair: Optional[str] = None,
    parts: Union[str, int, None] = None,
    fill: Union[Point, Sequence[Point], None] = None,
    smooth: Optional[bool] = None,
    inlet: Optional[Point] = None,
    outlet: Union[Point, Sequence[Point], None] = None,
    seeds: Union[Path, ArrayLike, None] = None,
    progress: Optional[Progress] = None,
    **unknown: NoReturn,
) -> tuple[Surface, list[Repair]]:
    """Makes a surface clean: connected, manifold, turned outward, without triangles that cross; all else stays.

    Returns the surface and what was done, in order; nothing, where nothing was wrong. Openings at the points `inlet`,
    `outlet` and `seeds` are kept however small, and are the ends of the Model then.

    `progress` is called with the name of the stage, ``"repair"``.

    Raises InputError where a defect cannot be repaired, with its place.
    """
    options = dict(locals())
    check_known(_repair, unknown)
    surface = surface_of(options.pop("surface"))
    options = points_as_seeds(given(options, ("progress", "unknown")))
    if surface.is_repaired:
        raise ParameterError("The surface is repaired already: repair the one that was read.")
    options = {**surface._options, **options}
    core = _core.repair(surface._core, arguments_of(options), progress)
    return Surface._of(core, surface._source, options), [Repair(*r) for r in core.repairs]


_repair = repair


def surface_of(surface: Any) -> Surface:
    """A Surface of whatever stands for one: a file, another package's object."""
    if isinstance(surface, Surface):
        return surface
    if isinstance(surface, (str, os.PathLike)):
        return read_surface(surface)
    if isinstance(surface, tuple) and len(surface) == 2:
        return Surface(*surface)
    return Surface(surface)
