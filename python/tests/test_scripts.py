# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The scripts of examples/python, where what they need is installed."""

import os
import pathlib
import re
import subprocess
import sys

import numpy as np
import pytest
from shapes import tube

import tubular_meshing as tm

SCRIPTS = pathlib.Path(__file__).resolve().parents[2] / "examples" / "python"


def run(script, *arguments, cwd):
    environment = {**os.environ, "XDG_CACHE_HOME": str(cwd / "cache"), "MPLCONFIGDIR": str(cwd / "cache")}
    result = subprocess.run(
        [sys.executable, SCRIPTS / script, *map(str, arguments)], capture_output=True, text=True, cwd=cwd, env=environment
    )
    if result.returncode == 77:
        pytest.skip(result.stdout)
    return result


def test_the_radius_along_a_vessel(arch_file, tmp_path):
    result = run("radius_along_vessel.py", arch_file, cwd=tmp_path)
    assert result.returncode == 0, result.stderr
    narrowest = [float(n) for n in re.findall(r"narrowest ([0-9.]+)", result.stdout)]
    assert narrowest == pytest.approx([9.9, 5.4, 4.5, 3.1], abs=0.1)
    assert (tmp_path / "radius.png").stat().st_size > 10000


def test_the_flow_in_a_tube_is_that_of_poiseuille(tmp_path):
    (tmp_path / "stl").mkdir()
    model = tm.Model(tm.Surface(*tube(length=10, radius=2, around=32)))
    tm.mesh(model, type="surface", points_per_circumference=24).write(tmp_path / "stl" / "tube.stl")
    (tmp_path / "stl" / "no_surface.stl").write_text("solid nothing\nendsolid nothing\n")
    result = run("flow_in_dolfinx.py", "stl", "-n", 12, cwd=tmp_path)
    assert result.returncode == 1, result.stderr  # of the one that is none
    assert "no_surface.stl: The file" in result.stdout
    flow, drop = map(float, re.search(r"outlet_1: flow ([0-9.]+), pressure drop ([0-9.]+)", result.stdout).groups())
    radius = model.openings[0].radius
    assert flow == pytest.approx(1000, rel=1e-6)
    assert drop == pytest.approx(8 * 0.0035 * 10 * 1000 / (np.pi * radius**4), rel=0.05)
    assert (tmp_path / "tube.xdmf").exists()
