# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
import ast
import inspect
import pathlib

import numpy as np
import pytest
from shapes import tube

import tubular_meshing as tm
from tubular_meshing import _core
from tubular_meshing._options import arguments_of, keywords_of

# A value for each option, one that it has not got by default.
VALUES = {
    "centerlines": [[[0, 0, 0], [0, 0, 4], [0, 0, 8]]],
    "inlet": (0, 0, 8),
    "outlet": [(0, 0, 0)],
    "seeds": [(0, 0, 8), (0, 0, 0)],
    "cut_ends": True,
    "keep_end": [(5, 5, 5)],
    "openings": 2,
    "allow_single_opening": True,
    "loops": True,
    "no_loops": True,
    "flow_extensions": 2,
    "repair": "off",
    "parts": 1,
    "fill": None,  # see below
    "smooth": True,
    "type": "anisotropic",
    "surface_elements": "quads",
    "points_per_circumference": 8,
    "elements": 2000,
    "min_size": 1.0,
    "max_size": 0.4,
    "gradation": 1.05,
    "refine": [((0, 0, 4), 1, 2), "0,0,2,0.5,1.5"],
    "refine_branch": {0: 1.5},
    "size_array": "size",
    "preserve_volume": False,
    "surface_mesher": "mesh_3",
    "volume_mesher": "mesh_3",
    "hex_method": "subdivision",
    "hex_fallback": "none",
    "wall": 0.2,
    "wall_thickness": 0.15,
    "wall_thickness_array": "thickness",
    "wall_thickness_table": "thickness.csv",
    "wall_layers": 2,
    "wall_growth": 1.5,
    "wall_elements": "tetrahedra",
    "second_wall": 0.1,
    "second_wall_thickness": 0.1,
    "second_wall_layers": 1,
    "second_wall_growth": 1.2,
    "material_array": "material",
    "fibres": True,
    "boundary_layer_prisms": 2,
    "boundary_layer": 0.2,
    "first_height": 0.05,
    "growth": 1.5,
    "smoothing_ratio": 1.2,
    "curvature_points": 15,
    "rename": {"wall": "vessel"},
    "output": "mesh.vtu",
    "format": "gmsh",
    "report": "report.json",
    "report_budget": 0.001,
    "picture": "mesh.png",
    "clip": (0, 0, 4, 1, 0, 0),
    "picture_view": (1, 1, 0),
    "picture_color": "quality",
    "picture_size": (320, 200),
    "write_surface": "surface.vtp",
    "write_centerlines": "lines.vtp",
    "write_blocks": "blocks.vtu",
    "threads": 1,
    "verbose": True,
    "quiet": False,
    "faces": "ends",
}
# What an option needs to go with it.
COMPANIONS = {
    "gradation": {"refine": ((0.5, 0, 4), 0.3, 5)},
    "outlet": {"inlet": (0, 0, 8)},
    "surface_elements": {"type": "surface"},
    "hex_method": {"type": "hexahedral"},
    "hex_fallback": {"type": "hexahedral"},
    "write_blocks": {"type": "hexahedral"},
    "wall_layers": {"wall": 0.2},
    "wall_growth": {"wall": 0.2},
    "wall_elements": {"wall": 0.2},
    "second_wall": {"wall": 0.2},
    "second_wall_thickness": {"wall": 0.2},
    "material_array": {"wall": 0.2},
    "fibres": {"wall": 0.2},
    "second_wall_layers": {"wall": 0.2, "second_wall": 0.1},
    "second_wall_growth": {"wall": 0.2, "second_wall": 0.1},
    "smoothing_ratio": {"type": "anisotropic"},
    "curvature_points": {"type": "anisotropic"},
    "first_height": {"boundary_layer_prisms": 2},
    "growth": {"boundary_layer_prisms": 2},
    "boundary_layer": {"boundary_layer_prisms": 2},
    "format": {"output": "mesh.out"},
    "report_budget": {"report": "report.html"},
    "clip": {"picture": "mesh.png"},
    "picture_view": {"picture": "mesh.png"},
    "picture_color": {"picture": "mesh.png"},
    "picture_size": {"picture": "mesh.png"},
}
FUNCTIONS = (tm.mesh, tm.Model.__init__, tm.repair)


def test_every_option_of_the_tool_is_a_keyword():
    assert set(tm.option_names()) == set(VALUES)
    assert set(keywords_of(tm.mesh)) - {"progress"} == set(tm.option_names())
    assert set(keywords_of(tm.Model.__init__)) - {"progress"} < set(tm.option_names())
    assert set(keywords_of(tm.repair)) - {"progress"} < set(tm.option_names())


@pytest.mark.parametrize("function", FUNCTIONS)
def test_every_option_is_documented(function):
    documentation = inspect.getdoc(function)
    descriptions = {o["name"].replace("-", "_"): o["description"] for o in _core.options()}
    for name in keywords_of(function):
        if name != "progress":
            assert f"{name}: {descriptions[name]}" in documentation


@pytest.mark.parametrize("name", sorted(VALUES))
def test_every_option_does_something(name, tmp_path, monkeypatch, capfd):
    """Either the mesh is another one, or there is a file, or what the option asks for is to be seen."""
    monkeypatch.chdir(tmp_path)
    points, triangles = tube(bend=0.5, around=16, along=16)
    surface = tm.Surface(
        points,
        triangles,
        point_arrays={"size": np.full(len(points), 0.5), "thickness": 0.1 + 0.01 * points[:, 2]},
        cell_arrays={"material": (points[triangles].mean(axis=1)[:, 2] > 4).astype(int)},
    )
    (tmp_path / "thickness.csv").write_text("0,0.15\n")
    companions = {"points_per_circumference": 9, **COMPANIONS.get(name, {})}
    if name == "elements":
        del companions["points_per_circumference"]
    value = VALUES[name]
    if name == "fill":
        hole = [i for i, t in enumerate(triangles) if np.linalg.norm(points[t].mean(axis=0) - [1.5, 0, 4]) > 0.75]
        surface, value = tm.Surface(points, triangles[hole]), [(1.5, 0, 4)]
    if name == "faces":
        surface, value = labelled_file(tmp_path), "ends"
    if name == "parts":
        twice = np.concatenate([points, 0.9 * points + [9, 0, 0]])
        surface = tm.Surface(twice, np.concatenate([triangles, triangles + len(points)]))
    mesh = tm.mesh(surface, **{**companions, name: value})
    if name == "preserve_volume":
        assert mesh.report["volume"]["preserved"] is False
    if name in ("output", "format", "report", "picture", "write_surface", "write_centerlines", "write_blocks"):
        assert [p.name for p in tmp_path.iterdir() if p.stat().st_size > 500] == [companions.get("output", value)]
    elif name == "material_array":
        assert set(mesh.regions) == {"lumen", "wall", "material_1"}
    elif name == "fibres":
        lengths = np.linalg.norm(mesh.cell_arrays["longitudinal"], axis=1)
        assert set(mesh.cell_arrays) == {"longitudinal", "circumferential"}
        assert np.allclose(lengths[len(mesh.cells["tetra"]) :], 1) and not lengths[: len(mesh.cells["tetra"])].any()
    elif name in ("report_budget", "clip", "picture_view", "picture_color", "picture_size"):
        file = tmp_path / (companions.get("report") or companions["picture"])
        with_it = file.read_bytes()
        tm.mesh(surface, **companions)
        assert len(with_it) != len(file.read_bytes())
    elif name in ("verbose", "quiet"):
        printed = capfd.readouterr().out
        assert "tetrahedra, gamma_tau" in printed and ("\nbranch " in printed) == (name == "verbose")
    elif name == "rename":
        assert "vessel" in mesh.patches and "wall" not in mesh.patches
    elif name in ("outlet", "openings", "allow_single_opening", "loops", "no_loops", "keep_end", "cut_ends", "threads", "repair"):
        assert mesh.report["valid"]  # of a plain tube it is the same mesh
    elif name == "hex_fallback":
        assert set(mesh.cells) == {"hexahedron"}
    elif name == "faces":
        assert "caval" in mesh.patches or {o["label"] for o in mesh.report["openings"]} == {2, 3}
    else:
        other = tm.mesh(surface, **companions)
        assert mesh.points.shape != other.points.shape or not np.array_equal(mesh.points, other.points) or any(
            not np.array_equal(mesh.cells.get(k, ()), other.cells.get(k, ())) for k in {**mesh.cells, **other.cells}
        )


def labelled_file(folder):
    """A capped tube with an integer a triangle, in an array of no known name."""
    from shapes import cap_labels

    points, triangles = tube(ends="capped")
    lines = ["# vtk DataFile Version 3.0", "tube", "ASCII", "DATASET POLYDATA", f"POINTS {len(points)} double"]
    lines += [" ".join(map(repr, p.tolist())) for p in points]
    lines += [f"POLYGONS {len(triangles)} {4 * len(triangles)}"] + ["3 %d %d %d" % tuple(t) for t in triangles]
    lines += [f"CELL_DATA {len(triangles)}", "SCALARS ends int 1", "LOOKUP_TABLE default"]
    lines += [str(label) for label in cap_labels()]
    (folder / "labelled.vtk").write_text("\n".join(lines) + "\n")
    return folder / "labelled.vtk"


def test_values_as_arguments():
    assert arguments_of({"inlet": np.array([1, 2.5, -3])}) == ["--inlet=1.0,2.5,-3.0"]
    assert arguments_of({"inlet": "caval"}) == ["--inlet=caval"]
    assert arguments_of({"fill": (1, 2, 3)}) == ["--fill=1,2,3"]
    assert arguments_of({"fill": [(1, 2, 3), "4,5,6"]}) == ["--fill=1,2,3", "--fill=4,5,6"]
    assert arguments_of({"refine": ((0, 0, 4), 1, 2)}) == ["--refine=0,0,4,1,2"]
    assert arguments_of({"refine": [0, 0, 4, 1, 2]}) == ["--refine=0,0,4,1,2"]
    assert arguments_of({"refine_branch": {3: 2}}) == ["--refine-branch=3,2"]
    assert arguments_of({"rename": {"inlet": "aorta"}}) == ["--rename=inlet=aorta"]
    assert arguments_of({"preserve_volume": True}) == ["--preserve-volume"]
    assert arguments_of({"preserve_volume": False}) == ["--no-preserve-volume"]
    assert arguments_of({"smooth": False}) == []
    assert arguments_of({"report": pathlib.Path("a.html")}) == ["--report=a.html"]
    assert arguments_of({"report": ["a.html", pathlib.Path("a.json")]}) == ["--report=a.html", "--report=a.json"]
    assert arguments_of({"picture_size": (320, 200), "clip": "-x"}) == ["--picture-size=320,200", "--clip=-x"]
    assert arguments_of({"output": pathlib.Path("a b.vtu")}) == ["--output=a b.vtu"]
    assert arguments_of({"max_size": np.float32(0.5), "threads": np.int64(2)}) == ["--max-size=0.5", "--threads=2"]


def test_a_misspelt_option_names_the_nearest(straight):
    with pytest.raises(TypeError, match="did you mean 'points_per_circumference'"):
        tm.mesh(straight, points_per_circumfrence=10)
    with pytest.raises(TypeError, match="did you mean 'inlet'"):
        tm.Model(tm.Surface(*tube()), inlett=(0, 0, 0))
    with pytest.raises(TypeError, match="did you mean 'smooth'"):
        tm.repair(tm.Surface(*tube()), smoth=True)
    with pytest.raises(TypeError, match="no option 'xyzzy'."):
        tm.mesh(straight, xyzzy=10)


def test_options_of_a_model_that_is_made(straight):
    with pytest.raises(tm.ParameterError, match="give inlet to Model"):
        tm.mesh(straight, inlet=(0, 0, 0))


def test_the_package_has_no_other_public_names():
    tree = ast.parse(pathlib.Path(tm.__file__).read_text())
    imported = {a.asname or a.name for n in tree.body if isinstance(n, ast.ImportFrom) for a in n.names}
    assert imported - {"_core"} | {"mesh_formats"} == set(tm.__all__)
