# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the program share: a folder for each, surfaces, and runs."""

import json
import os
import pathlib
import shutil
import subprocess
import unittest

TOOL, GENERATOR = os.environ["TUBULAR_MESH"], os.environ["GENERATOR"]
SCRATCH, DATA = pathlib.Path(os.environ["SCRATCH"]), pathlib.Path(os.environ["DATA"])
SHARED_DATA = os.environ.get("SHARED_DATA", "")


class ProgramTest(unittest.TestCase):
    def setUp(self):
        self.folder = SCRATCH / "program" / self.id().replace("__main__.", "")
        shutil.rmtree(self.folder, ignore_errors=True)
        self.out = self.folder / "out"
        self.out.mkdir(parents=True)

    def tearDown(self):
        if all(not found for _, found in getattr(self._outcome, "errors", [])):
            shutil.rmtree(self.folder, ignore_errors=True)

    def surface(self, shape, *options):
        file = self.folder / ("_".join([shape, *options]).replace("--", "") + ".stl")
        if not file.exists():
            subprocess.run([GENERATOR, shape, *options, "-o", str(file)], check=True, stdout=subprocess.DEVNULL)
        return str(file)

    def run_tool(self, *arguments, **options):
        return subprocess.run([TOOL, *map(str, arguments)], cwd=self.out, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              universal_newlines=True, **options)

    def succeed(self, *arguments):
        run = self.run_tool(*arguments)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run

    def files(self):
        """All that is in the folder for output, hidden files and folders included."""
        return sorted(str(f.relative_to(self.out)) for f in self.out.rglob("*"))


def has_tetgen():
    """Whether surface meshes are filled: by the program's own word."""
    run = subprocess.run([TOOL, "none.stl", "-o", os.devnull + ".vtu", "--volume-mesher", "tetgen"],
                         stderr=subprocess.PIPE, universal_newlines=True)
    return "without TetGen" not in run.stderr


def read_json(file):
    with open(file) as text:
        return json.load(text)
