# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""A vessel or airway tree, ready to be meshed."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any, NamedTuple, NoReturn, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._errors import ParameterError
from ._options import Path, Point, Progress, arguments_of, check_known, given, has_options, points_as_seeds
from ._surface import Repair, Surface, surface_of

REPAIR_OPTIONS = ("repair", "parts", "fill", "smooth")


class Opening(NamedTuple):
    """An end of a vessel through which fluid enters or leaves; lengths in the unit of the surface."""

    name: str  #: of its patch in meshes: ``"inlet"``, ``"outlet_1"``, …, or as the surface has it
    patch: int  #: the label of that patch
    center: NDArray[np.float64]  #: centroid of its area, of shape (3,)
    normal: NDArray[np.float64]  #: unit, out of the lumen, of shape (3,)
    area: float
    perimeter: float
    radius: float  #: of the disk of the same area
    branch: Optional[int]  #: the branch that ends here, if one does


class Branch(NamedTuple):
    """A vessel between two bifurcations or ends, directed away from the inlet; lengths in the unit of the surface."""

    points: NDArray[np.float64]  #: of its centerline, of shape (n, 3)
    radii: NDArray[np.float64]  #: at these, of shape (n,)
    abscissa: NDArray[np.float64]  #: length of the centerline from its beginning to each point, of shape (n,)
    length: float
    min_radius: float
    max_radius: float
    parents: list[int]  #: branches that end where this one begins
    children: list[int]  #: branches that begin where this one ends


class Centerlines(NamedTuple):
    """All branches, with the points in which they meet shared."""

    points: NDArray[np.float64]  #: of shape (n, 3), in the unit of the surface
    radii: NDArray[np.float64]  #: at these, of shape (n,)
    lines: list[NDArray[np.uint64]]  #: of each branch its points, by index


class Sections(NamedTuple):
    """What planes across the branches cut out of the lumen, n of them; lengths in the unit of the surface."""

    branch: NDArray[np.uint64]  #: of shape (n,)
    abscissa: NDArray[np.float64]  #: along the branch, from its beginning, of shape (n,)
    points: NDArray[np.float64]  #: of the centerline there, of shape (n, 3)
    normals: NDArray[np.float64]  #: unit, along the branch, of shape (n, 3)
    centers: NDArray[np.float64]  #: centroids of the areas, of shape (n, 3)
    area: NDArray[np.float64]  #: of shape (n,); 0 where the plane meets no closed loop of the wall
    perimeter: NDArray[np.float64]  #: of shape (n,)
    inscribed_radius: NDArray[np.float64]  #: of the largest ball in the lumen round the point, of shape (n,)
    hydraulic_diameter: NDArray[np.float64]  #: 4 area / perimeter, of shape (n,); 0 where there is no section
    eccentricity: NDArray[np.float64]  #: of the ellipse of the same second moments: 0 of a disk, below 1, of shape (n,)
    curvature: NDArray[np.float64]  #: of the centerline, 1 / length, of shape (n,)
    torsion: NDArray[np.float64]  #: of the centerline, 1 / length, of shape (n,); positive of a right-handed helix

    @property
    def radius(self) -> NDArray[np.float64]:
        """Of the disks of the same areas, of shape (n,)."""
        radius: NDArray[np.float64] = np.sqrt(self.area / np.pi)
        return radius


class Model:
    """A surface with its openings and centerlines; one model makes as many meshes as one likes.

    Parameters
    ----------
    surface : Surface, file name, or object of VTK, PyVista, meshio or trimesh
        Where repair() has not been called, it is repaired first, by the options of that function.
    centerlines : file name, or list of arrays of shape (n, 3) or (n, 4)
        The lines from the inlet to the outlets, with the local radius as fourth column; else they are computed.
    seeds : file name, or array of shape (n, 3)
        Points where vessels end, the inlet first.
    progress : callable
        Receives the name of each stage as it begins. What it raises ends the work, and so does Ctrl-C.

    Raises InputError where the surface cannot be used, with the place; ParameterError for options that are wrong.
    """

    def __init__(
        self,
        surface: Union[Surface, Path, Any],
        *,
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
        threads: Optional[int] = None,
        progress: Optional[Progress] = None,
        **unknown: NoReturn,
    ) -> None:
        options = dict(locals())
        check_known(Model.__init__, unknown)
        own = given(options, ("self", "surface", "progress", "unknown"))
        lines: list[NDArray[np.float64]] = []
        if centerlines is not None and not isinstance(centerlines, (str, os.PathLike)):
            lines = _lines_of(own.pop("centerlines"))
            _refuse_with_lines(own)
        if faces is not None and isinstance(surface, (str, os.PathLike)):
            from ._surface import read_surface

            surface = read_surface(surface, faces=faces)
            del own["faces"]
        elif faces is not None and not isinstance(surface, Surface):
            surface = Surface(surface, faces=faces)
            del own["faces"]
        surface = surface_of(surface)
        if "faces" in own:
            raise ParameterError("faces says how a file is read: give it to read_surface().")
        if surface.is_repaired and any(name in own for name in REPAIR_OPTIONS):
            raise ParameterError("The surface is repaired already: give repair, parts, fill and smooth to repair().")
        self._source = surface._source
        ends = ("inlet", "outlet", "seeds")
        before = given(surface._options, ends if any(name in own for name in ends) else ())
        self._options = points_as_seeds({**before, **own})
        self._core = _core.Model(surface._core, arguments_of(self._options), lines, surface._source, progress)
        self._surface = surface

    @property
    def openings(self) -> list[Opening]:
        """The inlet first, then the outlets."""
        return [Opening(*o) for o in self._core.openings]

    @property
    def branches(self) -> list[Branch]:
        """In the order by which `refine_branch` counts them."""
        return [Branch(*b) for b in self._core.branches]

    @property
    def centerlines(self) -> Centerlines:
        """The branches as one graph; read-only arrays, and no copies."""
        return Centerlines(*self._core.centerlines)

    @property
    def surface(self) -> tuple[NDArray[np.float64], NDArray[np.uint32], NDArray[np.int32]]:
        """The closed surface: points of shape (n, 3), triangles of shape (m, 3), and the patch of each, of shape (m,)."""
        return self._core.surface

    @property
    def number_of_vessels(self) -> int:
        """How many separate ones there are; each is meshed by itself."""
        return self._core.number_of_vessels

    def sections(self, spacing: float = 0.5, *, threads: int = 0) -> Sections:
        """Cuts the lumen by planes across its branches, `spacing` local radii apart.

        In and near a bifurcation a plane cuts several vessels where they are one: sections are large there.
        """
        return Sections(*self._core.sections(spacing, threads))

    def write_centerlines(self, file: Path) -> None:
        """Writes the branches and their radii: .vtp .vtk."""
        self._core.write_centerlines(os.fspath(file))

    def write_surface(self, file: Path) -> None:
        """Writes the closed surface with its patches: .stl .vtp .msh .ply .off .obj .vtk."""
        self._core.write_surface(os.fspath(file))

    def __repr__(self) -> str:
        openings, branches = len(self._core.openings), len(self._core.branches)
        return f"<tubular_meshing.Model of {branches} branches and {openings} openings>"


has_options("progress")(Model.__init__)
Model.__doc__ = (Model.__doc__ or "") + "\n" + (Model.__init__.__doc__ or "")


def _lines_of(lines: Any) -> list[NDArray[np.float64]]:
    if isinstance(lines, Centerlines):
        rows = np.column_stack([lines.points, lines.radii])
        return [rows[line.astype(np.int64)] for line in lines.lines]
    arrays = [np.asarray(line, dtype=float) for line in lines]
    if not arrays or any(a.ndim != 2 or len(a) < 2 or a.shape[1] not in (3, 4) for a in arrays):
        raise ParameterError("centerlines are a file, or arrays of shape (n, 3), or (n, 4) with radii, of two points each.")
    if len({a.shape[1] for a in arrays}) > 1:
        raise ParameterError("Either all centerlines have radii or none has.")
    if any(not np.all(np.isfinite(a)) for a in arrays):
        raise ParameterError("The points and the radii of centerlines are finite numbers.")
    return arrays


def _refuse_with_lines(options: dict[str, object]) -> None:
    """What the tool refuses where centerlines are given."""
    for name in ("outlet", "seeds", "loops", "no_loops", "flow_extensions"):
        if name in options:
            raise ParameterError(f"{name} cannot go with centerlines.")


__all__ = ["Branch", "Centerlines", "Model", "Opening", "Repair", "Sections"]
