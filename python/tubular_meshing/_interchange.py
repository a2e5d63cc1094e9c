# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects of other packages: surfaces from them, meshes to them. None of these is imported unless it is needed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional

import numpy as np

from ._errors import InputError

if TYPE_CHECKING:
    from ._mesh import Mesh

LABEL_ARRAYS = ("ModelFaceID", "CapID", "CellEntityIds", "patch", "gmsh:physical", "medit:ref")
VTK_TYPES = {"triangle": 5, "quad": 9, "tetra": 10, "hexahedron": 12, "wedge": 13, "pyramid": 14}
VTK_WEDGE = [0, 2, 1, 3, 5, 4]  # VTK counts the triangles of a wedge the other way round


def arrays_of(surface: Any, faces: Optional[str] = None) -> dict[str, Any]:
    """Points, triangles, labels and arrays of an object of VTK or PyVista, meshio or trimesh, by the attributes it has."""
    arrays: dict[str, Any]
    cell_arrays: dict[str, Any]
    if hasattr(surface, "GetPolys") and hasattr(surface, "GetPoints"):
        arrays, cell_arrays = _of_vtk(surface)
    elif hasattr(surface, "points") and hasattr(surface, "cells_dict"):
        arrays, cell_arrays = _of_meshio(surface)
    elif hasattr(surface, "vertices") and hasattr(surface, "faces"):
        arrays, cell_arrays = _of_trimesh(surface)
    elif hasattr(surface, "points") and hasattr(surface, "faces"):
        arrays, cell_arrays = _of_pyvista(surface)
    elif hasattr(surface, "points") and hasattr(surface, "triangles"):
        arrays, cell_arrays = {"points": surface.points, "triangles": surface.triangles}, {}
    else:
        raise TypeError(
            f"a {type(surface).__name__} is no surface: give points and triangles, or an object of VTK, PyVista, meshio "
            "or trimesh"
        )
    arrays["cell_arrays"] = {name: v for name, v in cell_arrays.items() if np.issubdtype(np.asarray(v).dtype, np.number)}
    arrays.update(_labels(cell_arrays, faces))
    return arrays


def _labels(cell_arrays: dict[str, Any], faces: Optional[str]) -> dict[str, Any]:
    if faces is not None and faces not in cell_arrays:
        known = ", ".join(cell_arrays)
        raise InputError(f"The surface has no cell array {faces!r}" + (f"; it has {known}." if known else ", nor any other."))
    for name in [faces] if faces is not None else LABEL_ARRAYS:
        values = np.asarray(cell_arrays.get(name, ()), dtype=float)
        if values.ndim == 1 and values.size and np.all(values == np.floor(values)) and values.min() != values.max():
            return {"labels": values.astype(np.int64), "label_array": name}
    if faces is not None:
        raise InputError(f"The cell array {faces!r} of the surface does not hold two integers or more.")
    return {}


def _of_vtk(surface: Any) -> tuple[dict[str, Any], dict[str, Any]]:
    from vtkmodules.util.numpy_support import vtk_to_numpy

    if surface.GetNumberOfStrips() > 0:
        raise InputError("The surface has triangle strips: pass it through vtkTriangleFilter.")
    if surface.GetNumberOfPolys() == 0:
        raise InputError("The surface has no polygons.")
    polygons = surface.GetPolys()
    offsets = vtk_to_numpy(polygons.GetOffsetsArray()).astype(np.int64)
    corners = vtk_to_numpy(polygons.GetConnectivityArray()).astype(np.int64)
    triangles, polygon = _fans(offsets, corners)
    lines_before = surface.GetNumberOfVerts() + surface.GetNumberOfLines()
    cell_arrays = {
        name: values[lines_before:][polygon] for name, values in _vtk_arrays(surface.GetCellData(), vtk_to_numpy)
    }
    arrays = {
        "points": vtk_to_numpy(surface.GetPoints().GetData()),
        "triangles": triangles,
        "point_arrays": dict(_vtk_arrays(surface.GetPointData(), vtk_to_numpy)),
    }
    return arrays, cell_arrays


def _vtk_arrays(data: Any, to_numpy: Any) -> list[tuple[str, Any]]:
    """Those of one number an element."""
    arrays = [data.GetArray(i) for i in range(data.GetNumberOfArrays())]
    return [(a.GetName(), to_numpy(a)) for a in arrays if a is not None and a.GetNumberOfComponents() == 1 and a.GetName()]


def _fans(offsets: Any, corners: Any) -> tuple[Any, Any]:
    """Polygons, one after another, as triangles round their first corners; and of each triangle its polygon."""
    number = np.maximum(np.diff(offsets) - 2, 0)
    polygon = np.repeat(np.arange(len(number)), number)
    first = offsets[:-1][polygon]
    within = np.arange(len(polygon)) - np.repeat(np.cumsum(number) - number, number)
    return np.stack([corners[first], corners[first + within + 1], corners[first + within + 2]], axis=1), polygon


def _of_meshio(mesh: Any) -> tuple[dict[str, Any], dict[str, Any]]:
    triangles, kept = [], []
    for i, block in enumerate(mesh.cells):
        if block.type in ("triangle", "quad", "polygon") and len(block.data):
            data = np.asarray(block.data)
            fans = [data[:, [0, k, k + 1]] for k in range(1, data.shape[1] - 1)]
            triangles += fans
            kept += [i] * len(fans)
    if not triangles:
        raise InputError("The mesh has no triangles: it is no surface.")
    points = np.asarray(mesh.points, dtype=float)
    if points.shape[1] == 2:
        raise InputError("The points of the mesh lie in a plane: it is no surface in space.")
    cell_arrays = {
        name: np.concatenate([np.asarray(values[i]) for i in kept])
        for name, values in mesh.cell_data.items()
        if all(np.asarray(values[i]).ndim == 1 for i in kept)
    }
    point_arrays = {name: v for name, v in mesh.point_data.items() if np.asarray(v).ndim == 1}
    return {"points": points, "triangles": np.concatenate(triangles), "point_arrays": point_arrays}, cell_arrays


def _of_trimesh(mesh: Any) -> tuple[dict[str, Any], dict[str, Any]]:
    arrays = {
        "points": np.asarray(mesh.vertices),
        "triangles": np.asarray(mesh.faces),
        "point_arrays": _plain(getattr(mesh, "vertex_attributes", {})),
    }
    return arrays, _plain(getattr(mesh, "face_attributes", {}))


def _of_pyvista(mesh: Any) -> tuple[dict[str, Any], dict[str, Any]]:
    """What has the attributes of pyvista.PolyData, and is none of VTK: each face as its number of corners and these."""
    faces = np.asarray(mesh.faces)
    if faces.ndim == 2 and faces.shape[1] == 3:
        triangles, polygon = faces, np.arange(len(faces))
    else:
        starts = _starts(faces.ravel())
        corners = np.delete(faces.ravel(), starts)
        triangles, polygon = _fans(np.append(starts - np.arange(len(starts)), len(corners)), corners)
    if not len(triangles):
        raise InputError("The surface has no polygons.")
    before = int(getattr(mesh, "n_verts", 0)) + int(getattr(mesh, "n_lines", 0))  # cells that are no polygons
    cell_arrays = {name: v[before:][polygon] for name, v in _plain(getattr(mesh, "cell_data", {})).items()}
    arrays = {
        "points": np.asarray(mesh.points),
        "triangles": triangles,
        "point_arrays": _plain(getattr(mesh, "point_data", {})),
    }
    return arrays, cell_arrays


def _starts(padded: Any) -> Any:
    """Where the faces of an array begin that has the number of corners before those of each."""
    if len(padded) and padded[0] > 0 and len(padded) % (padded[0] + 1) == 0 and np.all(padded[:: padded[0] + 1] == padded[0]):
        return np.arange(0, len(padded), padded[0] + 1)  # all alike, as triangles are
    starts, at = [], 0
    while at < len(padded):
        if padded[at] < 0:
            break
        starts.append(at)
        at += int(padded[at]) + 1
    if at != len(padded):
        raise InputError("The faces of the surface are not numbers of corners, each followed by so many corners.")
    return np.array(starts, dtype=np.int64)


def _plain(data: Any) -> dict[str, Any]:
    """Arrays of one number an element."""
    return {str(name): np.asarray(v) for name, v in dict(data).items() if np.asarray(v).ndim == 1}


def _need(module: str, what: str, package: str) -> Any:
    """A module that a function needs, or an ImportError that says so."""
    import importlib

    try:
        return importlib.import_module(module)
    except ImportError as e:
        raise ImportError(f"{what} needs {package}, which is not installed: pip install {package}", name=module) from e


def blocks_of(mesh: "Mesh") -> list[tuple[str, Any, Any, Any]]:
    """Kind, vertices, regions and patches of all cells and facets; 0 where there is no such thing."""
    blocks = []
    for kinds, is_facet in ((mesh.cells, False), (mesh.facets, True)):
        for kind, vertices in kinds.items():
            labels = (mesh.facet_patches if is_facet else mesh.cell_regions)[kind]
            none = np.zeros_like(labels)
            blocks.append((kind, vertices, none if is_facet else labels, labels if is_facet else none))
    return blocks


def to_meshio(mesh: "Mesh") -> Any:
    meshio = _need("meshio", "Mesh.to_meshio()", "meshio")
    blocks = blocks_of(mesh)
    return meshio.Mesh(
        np.array(mesh.points),
        [(kind, vertices.astype(np.int64)) for kind, vertices, _, _ in blocks],
        point_data={name: np.array(values) for name, values in mesh.point_arrays.items()},
        cell_data={"region": [r for _, _, r, _ in blocks], "patch": [p for _, _, _, p in blocks]},
        field_data={
            name: np.array([label, dimension])
            for names, dimension in ((mesh._core.region_names, 3), (mesh._core.patch_names, 2))
            for label, name in names.items()
        },
    )


def to_vtk(mesh: "Mesh") -> Any:
    model = _need("vtkmodules.vtkCommonDataModel", "Mesh.to_vtk()", "vtk")
    core = _need("vtkmodules.vtkCommonCore", "Mesh.to_vtk()", "vtk")
    numpy_support = _need("vtkmodules.util.numpy_support", "Mesh.to_vtk()", "vtk")
    blocks = [(k, v[:, VTK_WEDGE] if k == "wedge" else v, r, p) for k, v, r, p in blocks_of(mesh)]
    points = core.vtkPoints()
    points.SetData(numpy_support.numpy_to_vtk(np.array(mesh.points), deep=True))
    sizes = np.concatenate([np.full(len(v), v.shape[1]) for _, v, _, _ in blocks])
    cells = model.vtkCellArray()
    cells.SetData(
        numpy_support.numpy_to_vtkIdTypeArray(np.concatenate([[0], np.cumsum(sizes)]).astype(np.int64), deep=True),
        numpy_support.numpy_to_vtkIdTypeArray(np.concatenate([v.ravel() for _, v, _, _ in blocks]).astype(np.int64), deep=True),
    )
    types = np.concatenate([np.full(len(v), VTK_TYPES[kind], dtype=np.uint8) for kind, v, _, _ in blocks])
    grid = model.vtkUnstructuredGrid()
    grid.SetPoints(points)
    grid.SetCells(numpy_support.numpy_to_vtk(types, deep=True, array_type=core.vtkUnsignedCharArray().GetDataType()), cells)
    for name, labels in (("region", [r for _, _, r, _ in blocks]), ("patch", [p for _, _, _, p in blocks])):
        array = numpy_support.numpy_to_vtk(np.concatenate(labels), deep=True)
        array.SetName(name)
        grid.GetCellData().AddArray(array)
    for name, values in mesh.point_arrays.items():
        array = numpy_support.numpy_to_vtk(np.array(values, dtype=float), deep=True)
        array.SetName(name)
        grid.GetPointData().AddArray(array)
    return grid


def to_pyvista(mesh: "Mesh") -> Any:
    pyvista = _need("pyvista", "Mesh.to_pyvista()", "pyvista")
    return pyvista.UnstructuredGrid(to_vtk(mesh))
