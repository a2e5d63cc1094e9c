# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes to test with, made here, and the sample of the project."""

import pathlib
import sys

import numpy as np
import pytest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from shapes import tube  # noqa: E402

import tubular_meshing as tm  # noqa: E402

DATA = pathlib.Path(__file__).resolve().parents[2] / "data"


@pytest.fixture(scope="session")
def arch_file():
    return DATA / "aortic_arch.stl"


@pytest.fixture(scope="session")
def arch(arch_file):
    return tm.Model(arch_file)


@pytest.fixture(scope="session")
def straight():
    """A straight tube of radius 1 and length 8 along z."""
    return tm.Model(tm.Surface(*tube(length=8)))


@pytest.fixture(scope="session")
def straight_mesh(straight):
    return tm.mesh(straight, points_per_circumference=10)


@pytest.fixture
def rng():
    return np.random.default_rng(1)
