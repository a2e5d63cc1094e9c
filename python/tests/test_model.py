# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
import numpy as np
import pytest
from shapes import tube

import tubular_meshing as tm


def test_openings_have_their_figures(straight):
    inlet, outlet = straight.openings
    assert inlet.name == "inlet" and outlet.name == "outlet_1"
    assert (inlet.patch, outlet.patch) == (2, 3)
    polygon = 0.5 * 16 * np.sin(2 * np.pi / 16)
    for o in straight.openings:
        assert o.area == pytest.approx(polygon)
        assert o.radius == pytest.approx(np.sqrt(polygon / np.pi))
        assert np.linalg.norm(o.normal) == pytest.approx(1)
        assert o.branch == 0


def test_branches_have_their_figures(straight):
    (branch,) = straight.branches
    assert branch.length == pytest.approx(8, rel=1e-3)
    assert branch.points.shape == (len(branch.radii), 3)
    assert branch.abscissa[0] == 0 and branch.abscissa[-1] == pytest.approx(branch.length)
    assert 0.95 < branch.min_radius <= branch.max_radius < 1.05
    assert branch.parents == [] and branch.children == []


def test_branches_are_linked(arch):
    root = [b for b in arch.branches if not b.parents]
    assert len(root) == 1
    for i, b in enumerate(arch.branches):
        for child in b.children:
            assert i in arch.branches[child].parents
            assert np.array_equal(arch.branches[child].points[0], b.points[-1])


def test_centerlines_are_views(arch):
    lines = arch.centerlines
    assert lines.points.shape == (len(lines.radii), 3)
    assert not lines.points.flags.owndata and not lines.points.flags.writeable
    for line, branch in zip(lines.lines, arch.branches):
        assert np.array_equal(lines.points[line.astype(int)], branch.points)


@pytest.mark.parametrize("bend", [0, 1.5])
@pytest.mark.parametrize("spacing", [0.2, 0.5, 2])
def test_sections_of_a_tube_are_its_polygon(bend, spacing):
    model = tm.Model(tm.Surface(*tube(length=12, bend=bend)))
    sections = model.sections(spacing)
    polygon = 0.5 * 16 * np.sin(2 * np.pi / 16)
    # a plane across the line cuts the sheared tube in its ring, seen at an angle
    slope = bend * np.pi / 12 * np.cos(np.pi * sections.points[:, 2] / 12)
    inside = (sections.abscissa > 1.5) & (sections.abscissa < 10.5)
    assert np.allclose((sections.area * np.sqrt(1 + slope**2))[inside], polygon, rtol=0.06)
    assert np.allclose(sections.radius, np.sqrt(sections.area / np.pi))
    assert len(sections.area) == pytest.approx(12 / spacing, rel=0.15, abs=1)
    if bend == 0:
        assert np.allclose(sections.area, polygon, rtol=1e-3)
        assert np.allclose(sections.centers[:, :2], 0, atol=1e-2)
        assert np.allclose(sections.perimeter, 2 * 16 * np.sin(np.pi / 16), rtol=1e-3)
        assert np.all(sections.eccentricity < 0.05)
        assert np.all(sections.curvature < 1e-3)
        assert np.all(sections.torsion == 0)
    assert np.allclose(sections.hydraulic_diameter, 4 * sections.area / sections.perimeter)


def test_sections_of_a_helix_and_of_a_slit():
    turns, slope = 1.0, 2.0  # per unit of angle; the radius of the axis is 3
    t = np.linspace(0, 2 * np.pi * turns, 160)
    axis = np.column_stack([3 * np.cos(t), 3 * np.sin(t), slope * t])
    along = np.gradient(axis, axis=0)
    along /= np.linalg.norm(along, axis=1)[:, None]
    normal = np.column_stack([-np.cos(t), -np.sin(t), 0 * t])
    angles = 2 * np.pi * np.arange(24) / 24
    rings = axis[:, None] + 0.5 * (np.cos(angles)[:, None] * normal[:, None] +
                                   0.6 * np.sin(angles)[:, None] * np.cross(along, normal)[:, None])
    i, j = np.meshgrid(np.arange(24), np.arange(159))
    a, b = j * 24 + i, j * 24 + (i + 1) % 24
    triangles = np.concatenate([np.stack([a, b, b + 24], -1).reshape(-1, 3), np.stack([a, b + 24, a + 24], -1).reshape(-1, 3)])
    sections = tm.Model(tm.Surface(rings.reshape(-1, 3), triangles)).sections()
    inside = slice(len(sections.area) // 4, -(len(sections.area) // 4))
    assert np.allclose(sections.curvature[inside], 3 / (3**2 + slope**2), rtol=0.05)
    torsion = sections.torsion[inside] * (3**2 + slope**2) / slope
    assert np.allclose(torsion, 1, atol=0.25) # third derivatives of a computed line: it goes up and down
    assert torsion.mean() == pytest.approx(1, abs=0.03)
    assert np.allclose(sections.eccentricity[inside], 0.8, atol=0.03)
    assert np.allclose(sections.area[inside], np.pi * 0.5 * 0.3, rtol=0.03)


def test_sections_do_not_depend_on_threads(arch):
    one, two = arch.sections(threads=1), arch.sections(threads=2)
    assert all(np.array_equal(a, b) for a, b in zip(one, two))


def test_sections_of_every_branch(arch):
    sections = arch.sections()
    assert set(sections.branch) == set(range(len(arch.branches)))
    assert np.all(sections.area > 0)
    assert np.all(sections.radius > 0.8 * sections.inscribed_radius)


def test_no_sections_too_many(straight):
    with pytest.raises(tm.ParameterError):
        straight.sections(0)


def test_the_inlet_is_where_it_is_wanted():
    surface = tm.Surface(*tube())
    for z in (0, 8):
        for point in ((0, 0, z), np.array([0, 0, z]), f"0,0,{z}"):
            assert tm.Model(surface, inlet=point).openings[0].center[2] == pytest.approx(z, abs=1e-9)


def test_centerlines_can_be_given(arch, arch_file, tmp_path):
    arch.write_centerlines(tmp_path / "lines.vtp")
    for lines in (tmp_path / "lines.vtp", arch.centerlines, [np.column_stack([b.points, b.radii]) for b in arch.branches]):
        again = tm.Model(arch_file, centerlines=lines)
        assert len(again.branches) == len(arch.branches)
        assert sum(b.length for b in again.branches) == pytest.approx(sum(b.length for b in arch.branches), rel=0.02)


@pytest.mark.parametrize("lines", [[], [[[0, 0, 0]]], [np.zeros((3, 2))], [np.full((2, 3), np.nan)]])
def test_centerlines_that_are_none(straight, lines):
    with pytest.raises(tm.ParameterError):
        tm.Model(tm.Surface(*tube()), centerlines=lines)


def test_seeds_as_points_and_as_a_file(tmp_path):
    surface = tm.Surface(*tube())
    seeds = [[0, 0, 8], [0, 0, 0]]
    (tmp_path / "seeds.txt").write_text("0 0 8\n0 0 0\n")
    for given in (seeds, tmp_path / "seeds.txt"):
        assert tm.Model(surface, seeds=given).openings[0].center[2] == pytest.approx(8, abs=1e-9)


def test_seeds_go_from_repair_to_the_model():
    surface, _ = tm.repair(tm.Surface(*tube()), seeds=[[0, 0, 8], [0, 0, 0]])
    assert tm.Model(surface).openings[0].center[2] == pytest.approx(8, abs=1e-9)
    assert tm.Model(surface, inlet=(0, 0, 0)).openings[0].center[2] == pytest.approx(0, abs=1e-9)


def test_several_vessels():
    points, triangles = tube()
    both = np.concatenate([points, points + [10, 0, 0]])
    model = tm.Model(tm.Surface(both, np.concatenate([triangles, triangles + len(points)])))
    assert model.number_of_vessels == 2
    assert [o.name for o in model.openings] == ["inlet", "outlet_1", "inlet_2", "outlet_2"]
    assert len(model.branches) == 2
    meshes = [tm.mesh(model, points_per_circumference=10) for _ in range(2)]
    assert set(meshes[0].patches) == {"wall", "inlet", "outlet_1", "inlet_2", "outlet_2"}
    assert np.array_equal(meshes[0].points, meshes[1].points)
    fine = tm.mesh(model, points_per_circumference=10, refine=((10, 0, 4), 2, 3))
    assert len(fine.points) > 1.3 * len(meshes[0].points)
    assert np.sum(fine.points[:, 0] > 5) > 1.5 * np.sum(fine.points[:, 0] < 5)


def test_the_closed_surface(straight, tmp_path):
    points, triangles, patches = straight.surface
    assert set(patches) == {1, 2, 3} and len(patches) == len(triangles)
    p, q, r = (points[triangles[:, i]] for i in range(3))
    volume = np.einsum("ij,ij->i", np.cross(p, q), r).sum() / 6
    assert volume == pytest.approx(8 * 0.5 * 16 * np.sin(2 * np.pi / 16))
    straight.write_surface(tmp_path / "closed.vtp")
    assert tm.read_surface(tmp_path / "closed.vtp").labels is not None


def test_repair_is_said_once():
    surface, _ = tm.repair(tm.Surface(*tube()))
    with pytest.raises(tm.ParameterError, match="repaired already"):
        tm.Model(surface, smooth=True)


def test_faces_are_said_to_the_reader(arch_file):
    with pytest.raises(tm.ParameterError, match="read_surface"):
        tm.Model(tm.read_surface(arch_file), faces="ModelFaceID")
    with pytest.raises(tm.InputError):
        tm.Model(arch_file, faces="ModelFaceID")
