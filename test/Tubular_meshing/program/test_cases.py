# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The folders that --case writes, without their solvers: what is in them, and what is refused."""

import json
import os
import re
import unittest
import xml.etree.ElementTree

from program import TOOL, ProgramTest

FLOW = ["--flow-rate", "1"]
WALL = ["--wall", "0.2", "--wall-pressure", "1e4"]
FILES = {
    "openfoam": {"Allrun", "0/U", "0/p", "constant/transportProperties", "constant/turbulenceProperties",
                 "system/controlDict", "system/fvSchemes", "system/fvSolution", "constant/polyMesh/points",
                 "constant/polyMesh/faces", "constant/polyMesh/owner", "constant/polyMesh/neighbour",
                 "constant/polyMesh/boundary"},
    "svmultiphysics": {"Allrun", "solver.xml", "mesh-complete/mesh-complete.mesh.vtu", "mesh-complete/mesh-surfaces/inlet.vtp",
                       "mesh-complete/mesh-surfaces/outlet_1.vtp", "mesh-complete/mesh-surfaces/outlet_2.vtp",
                       "mesh-complete/mesh-surfaces/wall.vtp"},
    "fenicsx": {"Allrun", "flow.py", "case.json", "mesh.xdmf", "mesh.h5"},
    "freefem": {"Allrun", "flow.edp", "case.edp", "mesh.mesh"},
    "calculix": {"Allrun", "wall.inp", "mesh.inp"},
}


class Case(ProgramTest):
    def case(self, solver, *options, shape="y"):
        own = WALL if solver == "calculix" else FLOW
        run = self.run_tool(self.surface(shape), "-n", "10", "-q", "-o", "case", "--case", solver, *own, *options)
        if "was built without" in run.stderr:
            self.skipTest(run.stderr)
        self.assertEqual(run.returncode, 0, run.stderr)
        return self.out / "case"

    def files_of(self, folder):
        return {str(f.relative_to(folder)) for f in folder.rglob("*") if f.is_file()}

    def test_has_all_that_a_solver_needs_and_no_word_is_left(self):
        for solver, files in FILES.items():
            with self.subTest(solver):
                folder = self.case(solver)
                self.assertLessEqual(files, self.files_of(folder))
                for file in files:
                    if not file.startswith(("mesh", "constant/polyMesh")):
                        self.assertNotRegex((folder / file).read_text(), r"@[A-Z_]+@", file)
                self.case(solver)  # again, in its place
                for file in {"Allrun", "flow.py"} & files:
                    self.assertTrue(os.access(folder / file, os.X_OK), file)
                for path in sorted(folder.rglob("*"), reverse=True):
                    path.rmdir() if path.is_dir() else path.unlink()
                folder.rmdir()

    def test_flow_of_openfoam_is_the_one_asked_for(self):
        for options in ([], ["-t", "hexahedral"], ["--boundary-layer-prisms", "2"]):
            with self.subTest(str(options)):
                folder = self.case("openfoam", *options)
                self.assertAlmostEqual(self.flow_in(folder) / 1e-6, 1, delta=1e-6)

    def flow_in(self, folder):
        """The sum of velocity times area over the faces of the inlet: each by its points."""
        boundary = (folder / "constant/polyMesh/boundary").read_text()
        count, start = map(int, re.search(r"inlet\s*\{[^}]*nFaces\s+(\d+);\s*startFace\s+(\d+);", boundary).groups())
        entries = lambda name: re.split(r"\n\d+\n\(\n", (folder / name).read_text(), maxsplit=1)[1].split("\n)")[0].split("\n")  # noqa: E731
        points = [[float(x) for x in line.strip("()").split()] for line in entries("constant/polyMesh/points")]
        faces = entries("constant/polyMesh/faces")[start:start + count]
        velocities = [[float(x) for x in line.strip("()").split()] for line in entries("0/U")]
        self.assertEqual(len(velocities), count)
        flow = 0.0
        for face, velocity in zip(faces, velocities):
            corners = [points[int(v)] for v in face[face.index("(") + 1:].rstrip(")").split()]
            for b, c in zip(corners[1:], corners[2:]):
                u, v = ([q - p for p, q in zip(corners[0], corner)] for corner in (b, c))
                area = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
                flow -= sum(x * y for x, y in zip(area, velocity)) / 2
        return flow

    def test_pressures_are_at_their_outlets(self):
        folder = self.case("fenicsx", "--outlet-pressure", "100", "--outlet-pressure", "outlet_2=-50", "--rename",
                           "inlet=aorta")
        case = json.loads((folder / "case.json").read_text())
        self.assertEqual({o["name"]: o["pressure"] for o in case["outlets"]}, {"outlet_1": 100, "outlet_2": -50})
        self.assertEqual([i["name"] for i in case["inlets"]], ["aorta"])
        self.assertEqual([w["name"] for w in case["walls"]], ["wall"])
        self.assertEqual(case["flow_rate"], 1e-6)

    def test_lengths_are_in_metres(self):
        sizes = {}
        for unit in ("m", "cm", "mm", "um"):
            case = json.loads((self.case("fenicsx", "--length-unit", unit, shape="tube") / "case.json").read_text())
            sizes[unit] = case["inlets"][0]["area"]
        for unit, factor in (("cm", 1e-4), ("mm", 1e-6), ("um", 1e-12)):
            self.assertAlmostEqual(sizes[unit] / sizes["m"] / factor, 1, delta=1e-9)

    def test_inlet_of_any_shape_has_a_rim(self):
        case = json.loads((self.case("fenicsx", shape="arch") / "case.json").read_text())
        inlet = case["inlets"][0]
        self.assertEqual(len(inlet["rim"]), 256)
        self.assertLess(max(inlet["rim"]) / min(inlet["rim"]), 1.3)
        self.assertAlmostEqual(sum(r * r for r in inlet["rim"]) / 256 * 3.14159 / inlet["area"], 1, delta=0.01)

    def test_solver_of_simvascular_finds_its_files(self):
        folder = self.case("svmultiphysics", "--outlet-pressure", "5")
        root = xml.etree.ElementTree.parse(folder / "solver.xml").getroot()
        for path in [*root.iter("Mesh_file_path"), *root.iter("Face_file_path")]:
            self.assertTrue((folder / path.text.strip()).exists(), path.text)
        faces = {f.get("name") for f in root.iter("Add_face")}
        conditions = {c.get("name"): c for c in root.iter("Add_BC")}
        self.assertEqual(set(conditions), faces)
        value = lambda name: float(conditions[name].find("Value").text)  # noqa: E731
        self.assertAlmostEqual(value("inlet"), -1e-6)
        self.assertEqual(value("outlet_1"), 5)
        self.assertEqual(value("wall"), 0)

    def test_wall_alone_is_for_calculix(self):
        folder = self.case("calculix")
        deck, mesh = (folder / "wall.inp").read_text(), (folder / "mesh.inp").read_text()
        self.assertNotIn("region_lumen", mesh)
        for name in re.findall(r"^\*NSET, NSET=(\S+)", mesh, re.M):
            self.assertIn(name, {"wall", "outer_wall", "inlet_ring", "outlet_ring_1", "outlet_ring_2"})
        self.assertEqual(set(re.findall(r"^(\S+), 1, 3$", deck, re.M)), {"inlet_ring", "outlet_ring_1", "outlet_ring_2"})

    def test_results_of_a_solver_are_not_lost(self):
        folder = self.case("openfoam", shape="tube")
        (folder / "100").mkdir()
        (folder / "100" / "U").write_text("of a night")
        run = self.run_tool(self.surface("tube"), "-q", "-o", "case", "--case", "openfoam", *FLOW)
        self.assertEqual(run.returncode, 2)
        self.assertIn("100/U", run.stderr)
        self.assertEqual((folder / "100" / "U").read_text(), "of a night")

    def test_refuses_what_does_not_go_together(self):
        surface = self.surface("tube")
        for options, word in (
            (["--case", "openfoam"], "--flow-rate"),
            (["--case", "openfoam", *FLOW, "--wall", "0.2"], "--wall"),
            (["--case", "calculix", "--wall", "0.2"], "--wall-pressure"),
            (["--case", "calculix", "--wall-pressure", "1"], "--wall"),
            (["--case", "calculix", *WALL, *FLOW], "--flow-rate"),
            (["--case", "freefem", *FLOW, "-t", "mixed"], "FreeFEM"),
            (["--case", "freefem", *FLOW, "--boundary-layer-prisms", "2"], "FreeFEM"),
            (["--case", "svmultiphysics", *FLOW, "-t", "mixed"], "svMultiPhysics"),
            (["--case", "openfoam", *FLOW, "-t", "surface"], "surface"),
            (["--case", "openfoam", *FLOW, "--format", "vtu"], "--format"),
            (["--case", "openfoam", "--flow-rate", "-1"], "above 0"),
            (["--case", "openfoam", *FLOW, "--outlet-pressure", "high"], "NAME=NUMBER"),
            (["--flow-rate", "1"], "--case"),
        ):
            with self.subTest(" ".join(options)):
                run = self.run_tool(surface, "-o", "case", *options)
                self.assertEqual(run.returncode, 2, run.stderr)
                self.assertEqual(run.stderr.count("\n"), 1, run.stderr)
                self.assertIn(word, run.stderr)
                self.assertEqual(self.files(), [])
        run = self.run_tool(surface, "-q", "-o", "case", "--case", "openfoam", *FLOW, "--outlet-pressure", "absent=1")
        self.assertEqual(run.returncode, 2)
        self.assertIn('"absent"', run.stderr)
        self.assertEqual(self.files(), [])


if __name__ == "__main__":
    unittest.main()
