# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the documentation shows, as it stands there."""

import pytest

import tubular_meshing as tm


@pytest.mark.parametrize("name", ["aorta.stl"])
def test_the_example_of_the_manual(name, arch_file, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / name).write_bytes(arch_file.read_bytes())

    surface = tm.read_surface("aorta.stl")
    surface, repairs = tm.repair(surface)
    model = tm.Model(surface)
    assert [o.name for o in model.openings] == ["inlet", "outlet_1", "outlet_2", "outlet_3", "outlet_4"]
    assert model.openings[0].radius == pytest.approx(14, rel=0.02)
    assert len(model.branches) == 7
    assert len(model.centerlines.lines) == 7
    assert len(model.sections().area) > 50
    mesh = tm.mesh(model, type="hexahedral", points_per_circumference=16, boundary_layer=0.3)
    assert repairs == []
    assert mesh.points.shape[1] == 3
    assert mesh.cells["hexahedron"].shape[1] == 8
    assert mesh.patches["inlet"].area == pytest.approx(model.openings[0].area, rel=0.01)
    assert mesh.quality["scaled_jacobian"].min() > 0
    assert len(mesh.quality["scaled_jacobian"]) == len(mesh.cells["hexahedron"])
    mesh.write("aorta.vtu")
    assert (tmp_path / "aorta.vtu").stat().st_size > 10000


def test_it_imports_fast():
    import subprocess
    import sys

    code = (
        "import time, numpy; t = time.perf_counter(); import tubular_meshing; print(time.perf_counter() - t);"
        "import sys; print([m for m in ('vtkmodules', 'meshio', 'pyvista', 'trimesh') if m in sys.modules])"
    )
    runs = [subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True) for _ in range(3)]
    seconds = min(float(run.stdout.split()[0]) for run in runs)
    assert seconds < 0.2
    assert runs[0].stdout.splitlines()[1] == "[]"
