# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
import pathlib

import numpy as np
import pytest
from shapes import tube

import tubular_meshing as tm


def test_the_classes():
    for error in (tm.InputError, tm.ParameterError, tm.MeshingError, tm.OutputError):
        assert issubclass(error, tm.Error)
    assert issubclass(tm.InputError, ValueError) and issubclass(tm.ParameterError, ValueError)
    assert issubclass(tm.OutputError, OSError) and issubclass(tm.MeshingError, RuntimeError)


def test_a_file_that_is_not_there(tmp_path):
    with pytest.raises(tm.InputError) as caught:
        tm.read_surface(tmp_path / "none.stl")
    assert caught.value.file == str(tmp_path / "none.stl")
    assert "cannot be opened" in caught.value.sentence


def test_a_line_that_is_wrong(tmp_path):
    (tmp_path / "bad.stl").write_text("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 x\n")
    with pytest.raises(tm.InputError) as caught:
        tm.read_surface(tmp_path / "bad.stl")
    assert (caught.value.file, caught.value.line) == (str(tmp_path / "bad.stl"), 4)


def test_a_face_and_a_vertex_that_are_wrong(tmp_path):
    (tmp_path / "bad.off").write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n")
    with pytest.raises(tm.InputError) as caught:
        tm.read_surface(tmp_path / "bad.off")
    assert (caught.value.face, caught.value.vertex) == (0, 7)


def test_a_place(straight):
    with pytest.raises(tm.Error) as caught:
        tm.mesh(straight, refine=((50, 0, 0), 1, 2))
    assert isinstance(caught.value, tm.ParameterError)
    assert caught.value.place == pytest.approx((50, 0, 0))
    assert caught.value.places == [caught.value.place]


@pytest.mark.parametrize(
    "options, sentence",
    [
        ({"points_per_circumference": 2}, "points_per_circumference: 2 is not a number from 3 to 10000."),
        ({"points_per_circumference": float("nan")}, "points_per_circumference: nan is not a number from 3 to 10000."),
        ({"type": "cubes"}, 'There is no type of mesh named "cubes"; the types are: isotropic, anisotropic, mixed,'),
        ({"min_size": 2, "max_size": 1}, "min_size is larger than max_size."),
        ({"elements": 1000, "points_per_circumference": 10}, "cannot go with"),
        ({"wall_layers": 2}, "wall_layers needs a wall: add wall, wall_thickness,"),
        ({"refine": (1, 2, 3)}, "X,Y,Z,RADIUS,FACTOR"),
        ({"refine_branch": {7: 2}}, "There is no branch 7 to refine: there are 1, counted from 0."),
        ({"rename": {"none": "other"}}, "There is no patch called"),
        ({"output": "mesh.xyz"}, 'The mesh cannot be written to "mesh.xyz"'),
        ({"threads": "many"}, "threads"),
        ({"smooth": 3}, "smooth is True or False, not 3."),
        ({"wall": True}, "wall is not True or False: give a number or a name."),
        ({"surface_mesher": "mesh_3", "volume_mesher": "tetgen"}, "volume_mesher tetgen fills the surface mesh"),
        ({"type": "surface", "wall": 0.2}, "A surface has no cells, hence no wall"),
    ],
)
def test_options_that_are_wrong(straight, options, sentence):
    of_surface = {"smooth"}
    model = tm.Surface(*tube()) if of_surface & set(options) else straight
    with pytest.raises(tm.ParameterError) as caught:
        tm.mesh(model, **options)
    assert sentence in caught.value.sentence
    assert "--" not in caught.value.sentence
    assert caught.value.file == options.get("output")


def test_wrong_options_are_found_before_any_work():
    stages = []
    with pytest.raises(tm.ParameterError):
        tm.mesh(tm.Surface(*tube()), type="cubes", progress=stages.append)
    assert stages == []


def test_a_surface_that_is_no_vessel():
    points, triangles = tube()
    with pytest.raises(tm.InputError):
        tm.Model(tm.Surface(points, triangles[:1]))


def test_too_few_openings():
    with pytest.raises(tm.InputError, match="The surface has 2 openings, not 3"):
        tm.Model(tm.Surface(*tube()), openings=3)


def test_an_output_that_cannot_be_written(straight_mesh, tmp_path):
    with pytest.raises(tm.ParameterError):
        straight_mesh.write(tmp_path / "none" / "mesh.vtu")
    assert not (tmp_path / "none").exists()
    with pytest.raises(tm.ParameterError):
        straight_mesh.write(tmp_path / "mesh.xyz")


def test_a_full_disk(straight_mesh):
    if not pathlib.Path("/dev/full").exists():
        pytest.skip("there is no /dev/full")
    with pytest.raises(tm.OutputError) as caught:
        straight_mesh.write("/dev/full", "gmsh")
    assert caught.value.file == "/dev/full"


def test_a_format_that_cannot_hold_the_mesh(straight, tmp_path):
    mesh = tm.mesh(straight, points_per_circumference=10, wall=0.2, wall_layers=1)
    with pytest.raises(tm.Error):
        mesh.write(tmp_path / "m.xdmf")
    assert list(tmp_path.iterdir()) == []


def test_errors_can_be_pickled(tmp_path):
    import pickle

    with pytest.raises(tm.InputError) as caught:
        tm.read_surface(tmp_path / "none.stl")
    again = pickle.loads(pickle.dumps(caught.value))
    assert again.sentence == caught.value.sentence and again.file == caught.value.file


def test_a_surface_that_crosses_itself():
    points, triangles = tube()
    points[16 * 12] = [-2, 0.1, 4]  # out through the wall on the other side
    with pytest.raises(tm.InputError, match="intersects itself") as caught:
        tm.Model(tm.Surface(points, triangles), repair="off")
    assert np.linalg.norm(np.subtract(caught.value.place, (-1, 0, 4))) < 0.5
