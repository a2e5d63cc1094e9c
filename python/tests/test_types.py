# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Types, by mypy, where it is installed."""

import pathlib
import shutil
import subprocess

import pytest

PACKAGE = pathlib.Path(__file__).resolve().parents[1] / "tubular_meshing"

USER = """
import tubular_meshing as tm

surface = tm.read_surface("aorta.stl")
surface, repairs = tm.repair(surface, smooth=True)
model = tm.Model(surface, inlet=(0.0, 1.0, 2.0))
radius: float = model.openings[0].radius
mesh = tm.mesh(model, type="hexahedral", points_per_circumference=24, boundary_layer=0.3)
least = mesh.quality["scaled_jacobian"].min()
area: float = mesh.patches["inlet"].area
mesh.write("aorta.vtu")
"""
WRONG = USER + """
tm.mesh(model, points_per_circumfrence=24)
tm.mesh(model, type=3)
"""


def mypy(*arguments, cwd):
    if shutil.which("mypy") is None:
        pytest.skip("mypy is not installed")
    return subprocess.run(
        ["mypy", "--cache-dir", str(cwd / "cache"), *map(str, arguments)], capture_output=True, text=True, cwd=cwd
    )


def test_the_package(tmp_path):
    result = mypy("--strict", "--ignore-missing-imports", PACKAGE, cwd=tmp_path)
    assert result.returncode == 0, result.stdout


@pytest.mark.parametrize("program, errors", [(USER, 0), (WRONG, 2)])
def test_a_program(tmp_path, monkeypatch, program, errors):
    (tmp_path / "program.py").write_text(program)
    monkeypatch.setenv("MYPYPATH", str(PACKAGE.parent))
    result = mypy("--strict", "--ignore-missing-imports", "--follow-imports", "silent", tmp_path / "program.py", cwd=tmp_path)
    assert result.stdout.count("program.py:") == errors, result.stdout
