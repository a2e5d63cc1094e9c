# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
import sys

import numpy as np
import pytest
from shapes import cap_labels, tube

import tubular_meshing as tm


def ends_of(surface):
    return sorted(round(float(o.center[2]), 6) for o in tm.Model(surface).openings)


def test_arrays_come_back_without_a_copy():
    points, triangles = tube()
    surface = tm.Surface(points, triangles)
    assert np.array_equal(surface.points, points)
    assert np.array_equal(surface.triangles, triangles)
    assert not surface.points.flags.owndata and not surface.points.flags.writeable
    assert surface.points.ctypes.data == surface.points.ctypes.data


def test_views_outlive_the_surface():
    points, triangles = tube()
    view = tm.Surface(points, triangles).points
    _ = [np.ones(1000) for _ in range(1000)]
    assert np.array_equal(view, points)


def test_integers_and_singles_will_do():
    points, triangles = tube()
    surface = tm.Surface(points.astype(np.float32), triangles.astype(np.int32).tolist())
    assert np.allclose(surface.points, points, atol=1e-6)


@pytest.mark.parametrize(
    "points, triangles, sentence",
    [
        ([[0, 0]], [[0, 0, 0]], "The points of a surface are an array of numbers of shape (n, 3)."),
        (np.zeros((3, 3)), [[0.0, 1.0, 2.0]], "The triangles of a surface are an array of integers of shape (n, 3)."),
        (np.zeros((3, 3)), [[0, 1], [1, 2, 0]], "The triangles of a surface are an array of integers of shape (n, 3)."),
        ("abc", [[0, 1, 2]], "The points of a surface are an array of numbers of shape (n, 3)."),
    ],
)
def test_wrong_shapes_are_refused(points, triangles, sentence):
    with pytest.raises(tm.ParameterError) as caught:
        tm.Surface(points, triangles)
    assert caught.value.sentence == sentence


@pytest.mark.parametrize("index", [-1, 1000000])
def test_indices_out_of_range_are_refused(index):
    points, triangles = tube()
    triangles[5, 1] = index
    with pytest.raises(tm.InputError) as caught:
        tm.Surface(points, triangles)
    assert (caught.value.face, caught.value.vertex) == (5, index if index > 0 else None)


def test_coordinates_that_are_not_finite_are_refused():
    points, triangles = tube()
    points[7, 2] = np.nan
    with pytest.raises(tm.InputError) as caught:
        tm.Surface(points, triangles)
    assert caught.value.vertex == 7


def test_repairs_have_their_places():
    points, triangles = tube()
    hole = np.abs(points[triangles].mean(axis=1) - [1, 0, 4]).sum(axis=1).argmin()
    surface, repairs = tm.repair(tm.Surface(points, np.delete(triangles, hole, axis=0)))
    assert [r.defect for r in repairs] == ["pinholes"]
    assert np.linalg.norm(repairs[0].place - [1, 0, 4]) < 0.5
    assert repairs[0].sentence.endswith(".")
    assert surface.is_repaired and len(surface.triangles) == len(triangles)
    with pytest.raises(tm.ParameterError):
        tm.repair(surface)


def test_labels_name_the_ends():
    points, triangles = tube(ends="capped")
    names = {1: "wall", 2: "pulmonary", 3: "caval"}
    surface = tm.Surface(points, triangles, labels=cap_labels(), label_names=names)
    assert np.array_equal(surface.labels, cap_labels())
    model = tm.Model(surface, inlet="caval")
    assert [o.name for o in model.openings] == ["caval", "pulmonary"]
    assert model.openings[0].center == pytest.approx([0, 0, 8], abs=1e-9)


def test_labels_have_one_value_a_triangle():
    points, triangles = tube(ends="capped")
    with pytest.raises(tm.ParameterError):
        tm.Surface(points, triangles, labels=[1, 2])


def test_size_array_of_points():
    points, triangles = tube()
    surface = tm.Surface(points, triangles, point_arrays={"size": np.full(len(points), 0.3)})
    fine, coarse = (tm.mesh(surface, size_array=a, points_per_circumference=8) for a in ("size", None))
    assert len(fine.points) > 2 * len(coarse.points)
    with pytest.raises(tm.InputError, match="it has size"):
        tm.mesh(surface, size_array="other")
    with pytest.raises(tm.ParameterError):
        tm.Surface(points, triangles, point_arrays={"size": [1.0]})


class Tracked(np.ndarray):
    """As trimesh's TrackedArray: an array of a class of its own."""


class Trimesh:
    """What trimesh.Trimesh has."""

    def __init__(self, vertices, faces, face_attributes=(), vertex_attributes=()):
        self.vertices, self.faces = vertices.view(Tracked), faces.view(Tracked)
        self.face_attributes, self.vertex_attributes = dict(face_attributes), dict(vertex_attributes)


def test_from_trimesh():
    assert ends_of(Trimesh(*tube())) == [0, 8]


def test_from_trimesh_with_attributes():
    points, triangles = tube(ends="capped")
    sizes, colors = np.full(len(points), 0.3), np.zeros((len(triangles), 4))
    attributes = {"ModelFaceID": cap_labels(), "colors": colors}
    surface = tm.Surface(Trimesh(points, triangles, attributes, {"size": sizes}))
    assert np.array_equal(surface.labels, cap_labels())
    assert ends_of(surface) == [0, 8]
    assert len(tm.mesh(surface, size_array="size", points_per_circumference=8).points) > 0


class PolyData:
    """What pyvista.PolyData has of its own; the real one is a vtkPolyData, too."""

    def __init__(self, points, faces, cell_data=(), point_data=(), n_lines=0):
        self.points, self.faces = points, faces
        self.cell_data, self.point_data = dict(cell_data), dict(point_data)
        self.n_verts, self.n_lines = 0, n_lines

    @property
    def regular_faces(self):
        return self.faces.reshape(-1, 4)[:, 1:]


def padded(*blocks):
    return np.concatenate([np.insert(b, 0, b.shape[1], axis=1).ravel() for b in blocks])


def test_from_pyvista():
    points, triangles = tube(ends="capped")
    mesh = PolyData(points, padded(triangles), {"CapID": cap_labels()}, {"size": np.ones(len(points))})
    surface = tm.Surface(mesh)
    assert np.array_equal(surface.triangles, mesh.regular_faces)
    assert np.array_equal(surface.labels, cap_labels())
    assert ends_of(surface) == [0, 8]


def test_from_pyvista_with_lines_before_the_faces():
    points, triangles = tube(ends="capped")
    labels = np.concatenate([[7, 7], cap_labels()])
    surface = tm.Surface(PolyData(points, padded(triangles), {"ModelFaceID": labels}, n_lines=2))
    assert np.array_equal(surface.labels, cap_labels())


def test_from_pyvista_of_triangles_and_quads():
    points, triangles = tube()
    half = len(triangles) // 2
    quads = np.stack([triangles[:half, 0], triangles[:half, 1], triangles[:half, 2], triangles[half:, 2]], axis=1)
    mixed = padded(quads[:10], triangles[10:half], triangles[half + 10 :])
    data = {"ModelFaceID": np.repeat([1, 2], [10, len(triangles) - 20])}
    surface = tm.Surface(PolyData(points, mixed, data))
    assert len(surface.triangles) == len(triangles)
    assert (surface.labels == 1).sum() == 20
    assert ends_of(PolyData(points, padded(quads))) == [0, 8]


@pytest.mark.parametrize("faces", [[3, 0, 1], [3, 0, 1, 2, 3, 0], [-1, 0, 1, 2]])
def test_faces_that_are_not_padded_are_refused(faces):
    with pytest.raises(tm.InputError, match="followed by so many corners"):
        tm.Surface(PolyData(np.zeros((3, 3)), np.array(faces)))


def test_from_pyvista_without_faces():
    with pytest.raises(tm.InputError, match="no polygons"):
        tm.Surface(PolyData(np.zeros((3, 3)), np.array([], dtype=int)))


def test_from_a_pair_of_arrays():
    assert ends_of(tube()) == [0, 8]


def test_from_nothing_of_the_kind():
    with pytest.raises(TypeError, match="a dict is no surface"):
        tm.Surface({})


def test_from_meshio():
    meshio = pytest.importorskip("meshio")
    points, triangles = tube(ends="capped")
    labels = cap_labels()
    mesh = meshio.Mesh(points, [("triangle", triangles)], cell_data={"ModelFaceID": [labels]})
    surface = tm.Surface(mesh)
    assert np.array_equal(surface.labels, labels)
    assert ends_of(surface) == [0, 8]
    with pytest.raises(tm.InputError, match="it has ModelFaceID"):
        tm.Surface(mesh, faces="other")


def test_from_meshio_in_quads():
    meshio = pytest.importorskip("meshio")
    points, triangles = tube()
    half = len(triangles) // 2
    quads = np.stack([triangles[:half, 0], triangles[:half, 1], triangles[:half, 2], triangles[half:, 2]], axis=1)
    surface = tm.Surface(meshio.Mesh(points, [("quad", quads)]))
    assert len(surface.triangles) == len(triangles)
    assert ends_of(surface) == [0, 8]


def vtk_polydata(points, triangles, labels):
    data = pytest.importorskip("vtkmodules.vtkCommonDataModel")
    core = pytest.importorskip("vtkmodules.vtkCommonCore")
    support = pytest.importorskip("vtkmodules.util.numpy_support")
    poly, cells, places = data.vtkPolyData(), data.vtkCellArray(), core.vtkPoints()
    places.SetData(support.numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    offsets = support.numpy_to_vtkIdTypeArray(np.arange(0, 3 * len(triangles) + 1, 3), deep=True)
    cells.SetData(offsets, support.numpy_to_vtkIdTypeArray(triangles.ravel().astype(np.int64), deep=True))
    poly.SetPoints(places)
    poly.SetPolys(cells)
    array = support.numpy_to_vtk(labels, deep=True)
    array.SetName("CapID")
    poly.GetCellData().AddArray(array)
    return poly


def test_from_vtk():
    points, triangles = tube(ends="capped")
    surface = tm.Surface(vtk_polydata(points, triangles, cap_labels()))
    assert np.array_equal(surface.points, points)
    assert np.array_equal(surface.labels, cap_labels())
    assert ends_of(surface) == [0, 8]


def test_of_a_file_and_its_arrays(arch_file):
    surface = tm.read_surface(arch_file)
    again = tm.Surface(surface.points, surface.triangles)
    assert len(tm.Model(again).branches) == len(tm.Model(arch_file).branches)


def test_other_packages_are_not_imported():
    assert "pyvista" not in sys.modules and "trimesh" not in sys.modules
