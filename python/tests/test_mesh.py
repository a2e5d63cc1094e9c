# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
import gc
import pathlib

import numpy as np
import pytest
from shapes import tube, volumes

import tubular_meshing as tm

FILES = ["m.vtu", "m.msh", "m.mesh", "m.inp", "m.su2", "m.feb", "m.cas", "m.xdmf", "m.cgns", "m.exo"]


def test_cells_fill_the_lumen(straight_mesh):
    assert np.all(volumes(straight_mesh) > 0)
    assert volumes(straight_mesh).sum() == pytest.approx(8 * 0.5 * 16 * np.sin(2 * np.pi / 16), rel=1e-3)


def test_arrays_are_views(straight_mesh):
    for array in (straight_mesh.points, straight_mesh.cells["tetra"], straight_mesh.facet_patches["triangle"]):
        assert not array.flags.owndata and not array.flags.writeable
    assert straight_mesh.points.dtype == np.float64
    assert straight_mesh.cells["tetra"].dtype == np.uint32
    again = straight_mesh._core.points
    assert again.ctypes.data == straight_mesh.points.ctypes.data


def test_views_outlive_the_mesh(straight):
    mesh = tm.mesh(straight, points_per_circumference=8)
    points, kept = mesh.points, mesh.points.copy()
    del mesh
    gc.collect()
    _ = tm.mesh(straight, points_per_circumference=8)
    assert np.array_equal(points, kept)


def test_patches(straight_mesh):
    assert list(straight_mesh.patches) == ["wall", "inlet", "outlet_1"]
    inlet, outlet = straight_mesh.patches["inlet"], straight_mesh.patches["outlet_1"]
    assert inlet.label == 2 and outlet.label == 3
    assert inlet.area == pytest.approx(0.5 * 16 * np.sin(2 * np.pi / 16), rel=0.01)
    assert abs(inlet.normal @ outlet.normal + 1) < 1e-9
    assert np.ptp(straight_mesh.points[inlet.points][:, 2]) < 1e-9
    assert sum(len(p.triangles) for p in straight_mesh.patches.values()) == len(straight_mesh.facets["triangle"])
    with pytest.raises(KeyError, match="it has wall, inlet, outlet_1"):
        straight_mesh.patches["outlet"]


def test_regions(straight):
    mesh = tm.mesh(straight, points_per_circumference=10, wall=0.2, wall_layers=2)
    assert set(mesh.regions) == {"lumen", "wall"}
    assert set(mesh.regions["lumen"].cells) == {"tetra"} and set(mesh.regions["wall"].cells) == {"wedge"}
    assert len(mesh.regions["wall"].cells["wedge"]) == len(mesh.cells["wedge"])
    assert mesh.regions["lumen"].label == 1


def test_quality(straight_mesh):
    gamma = straight_mesh.quality["gamma_tau"]
    assert gamma.shape == (len(straight_mesh.cells["tetra"]),)
    assert 0 < gamma.min() and gamma.max() <= 1
    report = straight_mesh.report["quality"]["gamma_tau"]
    assert (report["min"], report["max"]) == pytest.approx((gamma.min(), gamma.max()))
    assert len(straight_mesh.quality["aspect"]) == len(gamma)
    assert set(straight_mesh.quality) == {"gamma_T", "gamma_tau", "aspect", "non_orthogonality", "skewness"}
    with pytest.raises(KeyError, match="gamma_tau"):
        straight_mesh.quality["scaled_jacobian"]


def test_quality_in_the_order_of_the_cells(straight_mesh):
    points = straight_mesh.points[straight_mesh.cells["tetra"]]
    edges = [np.linalg.norm(points[:, i] - points[:, j], axis=1) for i in range(4) for j in range(i)]
    faces = [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]
    area = sum(
        np.linalg.norm(np.cross(points[:, b] - points[:, a], points[:, c] - points[:, a]), axis=1) / 2 for a, b, c in faces
    )
    gamma = 2 * np.sqrt(6) * 3 * volumes(straight_mesh) / area / np.max(edges, axis=0)
    assert np.allclose(straight_mesh.quality["gamma_tau"], gamma)


def test_report(straight, straight_mesh):
    report = straight_mesh.report
    assert report["valid"] is True
    assert report["points_per_circumference"] == 10
    assert report["cells"]["tetrahedra"] == len(straight_mesh.cells["tetra"])
    assert [o["name"] for o in report["openings"]] == [o.name for o in straight.openings]
    assert 0 < sum(report["times"].values()) <= 1.01 * report["total_time"]
    assert {"repair", "centerlines", "surface mesh"} <= set(report["times"])
    assert straight_mesh.fallbacks == report["fallbacks"] == []


def test_the_same_is_the_same(straight, straight_mesh):
    again = tm.mesh(straight, points_per_circumference=10)
    assert np.array_equal(again.points, straight_mesh.points)
    assert np.array_equal(again.cells["tetra"], straight_mesh.cells["tetra"])


def test_a_mesh_of_a_file(arch_file, tmp_path):
    mesh = tm.mesh(arch_file, points_per_circumference=8, output=tmp_path / "m.vtu", report=tmp_path / "m.json")
    assert (tmp_path / "m.vtu").exists() and (tmp_path / "m.json").exists()
    assert mesh.report["input"] == str(arch_file)


@pytest.mark.parametrize("name", FILES)
def test_files_by_their_names(straight_mesh, tmp_path, name):
    straight_mesh.write(tmp_path / name)
    assert (tmp_path / name).stat().st_size > 1000


@pytest.mark.parametrize("format", tm.mesh_formats())
def test_files_by_their_formats(straight_mesh, tmp_path, format):
    straight_mesh.write(tmp_path / "mesh.out", format)
    assert (tmp_path / "mesh.out").exists()


@pytest.mark.parametrize("folder", ["polyMesh", "mesh-complete"])
def test_folders(straight_mesh, tmp_path, folder):
    straight_mesh.write(tmp_path / folder)
    assert len(list((tmp_path / folder).iterdir())) > 3


def test_a_surface(straight, tmp_path):
    mesh = tm.mesh(straight, type="surface", surface_elements="quads", points_per_circumference=12)
    assert not mesh.cells and len(mesh.facets["quad"]) > 50
    assert mesh.quality["eta_q"].min() > 0
    for name in ("m.stl", "m.vtp", "m.msh", "m.ply", "m.off", "m.obj", "m.vtk"):
        mesh.write(tmp_path / name)
        assert (tmp_path / name).stat().st_size > 1000
    with pytest.raises(tm.ParameterError):
        mesh.write(tmp_path / "m.vtu")


def test_the_surface_of_a_mesh(straight_mesh, tmp_path):
    straight_mesh.write_surface(tmp_path / "s.vtp")
    written = tm.read_surface(tmp_path / "s.vtp")
    assert len(written.triangles) == len(straight_mesh.facets["triangle"])


def test_what_a_format_changes(straight):
    mesh = tm.mesh(straight, type="anisotropic", points_per_circumference=8)
    assert mesh.point_arrays["metric"].shape == (len(mesh.points), 6)
    assert "Q_tau" in mesh.quality
    assert any("metric" in sentence for sentence in mesh.changes_in("m.su2"))
    assert mesh.changes_in("m.vtu") == []


def test_to_meshio(straight, tmp_path):
    meshio = pytest.importorskip("meshio")
    mesh = tm.mesh(straight, points_per_circumference=10, wall=0.2, wall_layers=1)
    other = mesh.to_meshio()
    assert {c.type: len(c.data) for c in other.cells} == {
        "tetra": len(mesh.cells["tetra"]),
        "wedge": len(mesh.cells["wedge"]),
        "triangle": len(mesh.facets["triangle"]),
        "quad": len(mesh.facets["quad"]),
    }
    mesh.write(tmp_path / "m.vtu")
    written = meshio.read(tmp_path / "m.vtu")
    assert np.array_equal(written.points, other.points)
    assert np.array_equal(written.cells_dict["wedge"], other.cells_dict["wedge"])
    assert np.array_equal(np.concatenate(written.cell_data["region"]), np.concatenate(other.cell_data["region"]))
    assert list(other.field_data["inlet"]) == [2, 2]


def test_to_vtk(straight, tmp_path):
    pytest.importorskip("vtkmodules.vtkCommonDataModel")
    support = pytest.importorskip("vtkmodules.util.numpy_support")
    verdict = pytest.importorskip("vtkmodules.vtkFiltersVerdict")
    mesh = tm.mesh(straight, points_per_circumference=10, wall=0.2, wall_layers=1)
    grid = mesh.to_vtk()
    assert grid.GetNumberOfPoints() == len(mesh.points)
    assert grid.GetNumberOfCells() == sum(map(len, mesh.cells.values())) + sum(map(len, mesh.facets.values()))
    patch = support.vtk_to_numpy(grid.GetCellData().GetArray("patch"))
    assert set(patch) == {0} | {p.label for p in mesh.patches.values()}
    sizes = verdict.vtkCellSizeFilter() if hasattr(verdict, "vtkCellSizeFilter") else None
    if sizes is not None:
        sizes.SetInputData(grid)
        sizes.Update()
        volume = support.vtk_to_numpy(sizes.GetOutput().GetCellData().GetArray("Volume"))
        assert volume.min() >= 0 and volume.sum() == pytest.approx(8 * np.pi * 1.2**2, rel=0.05)


def test_to_pyvista_says_what_is_missing(straight_mesh, monkeypatch):
    import sys

    monkeypatch.setitem(sys.modules, "pyvista", None)
    with pytest.raises(ImportError, match="pip install pyvista"):
        straight_mesh.to_pyvista()


def test_no_leak(straight):
    """Memory is given back: that of two hundred meshes is that of the first twenty."""

    def resident():
        pages = pathlib.Path("/proc/self/statm").read_text().split()[1]
        return int(pages) * 4096

    surface = tube(along=12, length=4)
    sizes = []
    for _ in range(10):
        for _ in range(20):
            mesh = tm.mesh(tm.Model(tm.Surface(*surface)), points_per_circumference=8)
            assert len(mesh.quality["gamma_tau"]) > 0 and mesh.patches["wall"].area > 0
        gc.collect()
        sizes.append(resident())
    assert sizes[-1] < 1.05 * sizes[1]


def test_repr(straight, straight_mesh):
    assert "branches and 2 openings" in repr(straight)
    assert "tetra" in repr(straight_mesh)
