# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What --dry-run says of a mesh, and what the mesh then is."""

import pathlib
import time
import unittest

from program import SHARED_DATA, ProgramTest, has_tetgen, read_json

LAYERS = ["--boundary-layer-prisms", "4", "--first-height", "0.03"]
TYPES = {
    "isotropic": [],
    "isotropic, layers": LAYERS,
    "isotropic, wall": ["--wall", "0.2", "--wall-layers", "2"],
    "isotropic, two walls": ["--wall", "0.1", "--wall-layers", "2", "--second-wall", "0.1", "--second-wall-layers", "3"],
    "isotropic, wall of tetrahedra": ["--wall", "0.2", "--wall-elements", "tetrahedra"],
    "anisotropic": ["-t", "anisotropic"],
    "anisotropic, wall": ["-t", "anisotropic", "--wall", "0.2"],
    "mixed": ["-t", "mixed"],
    "mixed, layers and wall": ["-t", "mixed", "--wall", "0.2", *LAYERS],
    "hexahedral": ["-t", "hexahedral"],
    "hexahedral, layers and wall": ["-t", "hexahedral", "--wall", "0.2", *LAYERS],
    "subdivision": ["-t", "hexahedral", "--hex-method", "subdivision"],
    "subdivision, layers": ["-t", "hexahedral", "--hex-method", "subdivision", *LAYERS],
    "surface": ["-t", "surface"],
    "quads": ["-t", "surface", "--surface-elements", "quads"],
    "structured quads": ["-t", "surface", "--surface-elements", "structured-quads"],
}
TOLERANCE = 0.15


class DryRun(ProgramTest):
    def compare(self, surface, options, points):
        output = "mesh.stl" if "surface" in options else "mesh.vtu"
        self.succeed(surface, *options, "-n", points, "--dry-run", "-q", "--report", "dry.json")
        self.assertEqual(self.files(), ["dry.json"])
        dry = read_json(self.out / "dry.json")
        self.succeed(surface, *options, "-n", points, "-q", "-o", output, "--report", "mesh.json")
        mesh = read_json(self.out / "mesh.json")
        (self.out / "mesh.json").unlink()
        (self.out / output).unlink()
        what = "facets" if "surface" in options else "cells"
        total = sum(mesh[what].values())
        for kind, number in mesh[what].items():
            # each kind, as far as there are more than a few of it
            self.assertAlmostEqual(dry["estimate"][what][kind] / total, number / total, delta=TOLERANCE * max(number / total, 0.1),
                                   msg=f"{kind}: {dry['estimate'][what]}, {mesh[what]}")
        self.assertAlmostEqual(sum(dry["estimate"][what].values()) / total, 1, delta=TOLERANCE)
        return dry, mesh

    def test_counts_are_those_of_the_mesh(self):
        surface = self.surface("y")
        for name, options in TYPES.items():
            with self.subTest(name):
                if not has_tetgen() and name not in ("isotropic", "surface"):
                    continue
                self.compare(surface, options, 14)

    @unittest.skipUnless(SHARED_DATA, "needs the measurement data")
    def test_counts_are_those_of_meshes_of_real_vessels(self):
        for file, options, points in (("paper/carotid.stl", [], 12), ("paper/carotid.stl", ["-t", "mixed"], 12),
                                      ("trees/sofa_carotids.stl", LAYERS, 12), ("paper/cylemi.stl", ["-t", "anisotropic"], 12),
                                      ("paper/aorta.stl", ["-t", "hexahedral"], 16)):
            with self.subTest(file + " ".join(options)):
                self.compare(str(pathlib.Path(SHARED_DATA) / file), options, points)

    def test_openings_and_branches_are_those_of_the_mesh(self):
        dry, mesh = self.compare(self.surface("arch"), [], 10)
        self.assertEqual(len(dry["openings"]), len(mesh["openings"]))
        for told, there in zip(dry["openings"], mesh["openings"]):
            for key in ("name", "patch", "center", "normal", "area", "radius", "branch"):
                self.assertEqual(told[key], there[key])
        self.assertEqual([b["length"] for b in dry["branches"]], [b["length"] for b in mesh["branches"]])
        self.assertGreater(dry["mesh_size"]["smallest"], 0)
        self.assertGreater(dry["mesh_size"]["largest"], 2 * dry["mesh_size"]["smallest"])

    def test_large_surfaces_are_sampled(self):
        large, report = self.surface("y", "--resolution", "130"), self.out / "dry.json"
        told = {}
        types = dict(TYPES, **{"hexahedral, layers": ["-t", "hexahedral", *LAYERS]})
        for name in ("isotropic", "isotropic, layers", "mixed", "mixed, layers and wall", "anisotropic", "hexahedral",
                     "hexahedral, layers", "subdivision", "surface", "structured quads"):
            options, what = types[name], "facets" if "surface" in types[name] else "cells"
            for way in (["-q"], ["-v"]):
                self.succeed(large, *options, "-n", 14, "--dry-run", *way, "--report", report)
                dry = read_json(report)
                self.assertGreater(dry["triangles"], 100000)
                self.assertEqual(dry["branches"] is None, way == ["-q"])
                self.assertEqual(len(dry["openings"]), 3)
                told[way[0]] = sum(dry["estimate"][what].values())
            self.assertAlmostEqual(told["-q"] / told["-v"], 1, delta=TOLERANCE, msg=name)
            self.assertNotEqual(told["-q"], told["-v"])
        self.succeed(large, "--refine", "0,0,0,1,0.1", "--dry-run", "-q", "--report", report)
        self.assertIsNotNone(read_json(report)["branches"])  # which need the centerlines
        self.succeed(large, "--elements", 20000, "--dry-run", "-q", "--report", report)
        self.assertAlmostEqual(sum(read_json(report)["estimate"]["cells"].values()), 20000, delta=2000)
        told = []
        for threads in (1, 2):
            self.succeed(large, "--dry-run", "-q", "--report", report, "--threads", threads)
            told.append(read_json(report)["estimate"]["cells"])
        self.assertEqual(*told)

    def test_needs_no_output_and_little_time(self):
        begin = time.monotonic()
        run = self.succeed(self.surface("curved"), "--dry-run")
        self.assertLess(time.monotonic() - begin, 10)
        self.assertIn("tetrahedra", run.stdout)
        self.assertIn("MB of memory", run.stdout)
        self.assertEqual(self.files(), [])

    def test_with_an_output_nothing_is_written_and_all_is_checked(self):
        surface = self.surface("tube")
        self.succeed(surface, "--dry-run", "-o", "mesh.vtu", "--write-surface", "surface.stl", "-q")
        self.assertEqual(self.files(), [])
        run = self.run_tool(surface, "--dry-run", "-o", "absent/mesh.vtu")
        self.assertEqual(run.returncode, 2)

    def test_finds_the_points_for_a_number_of_elements(self):
        self.succeed(self.surface("curved"), "--dry-run", "-q", "--elements", "20000", "--report", "dry.json")
        dry = read_json(self.out / "dry.json")
        self.assertAlmostEqual(sum(dry["estimate"]["cells"].values()), 20000, delta=2000)
        self.assertNotEqual(dry["points_per_circumference"], 20)

    def test_does_not_depend_on_the_number_of_threads(self):
        surface = self.surface("y")
        for name, options in (("one", ["--threads", "1"]), ("two", ["--threads", "2"])):
            self.succeed(surface, "--dry-run", "-q", "--report", name + ".json", *options)
        one, two = read_json(self.out / "one.json"), read_json(self.out / "two.json")
        self.assertEqual(one["estimate"]["cells"], two["estimate"]["cells"])

    def test_an_output_is_required_otherwise(self):
        run = self.run_tool(self.surface("tube"))
        self.assertEqual((run.returncode, run.stderr), (2, "tubular_mesh: --output is required, a name such as mesh.vtu; see --help.\n"))


if __name__ == "__main__":
    unittest.main()
