# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
# What the compiled module has, for type checkers: see the classes of the package for what it means.

from collections.abc import Mapping, Sequence
from typing import Any, Callable, Optional

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Progress = Optional[Callable[[str], object]]

version: str

def options() -> list[dict[str, Any]]: ...
def check_options(arguments: Sequence[str], has_output: bool) -> None: ...
def mesh_formats() -> list[str]: ...

class Surface:
    points: Floats
    triangles: NDArray[np.uint64]
    labels: Optional[NDArray[np.int32]]
    label_names: dict[int, str]
    point_arrays: dict[str, list[float]]
    cell_arrays: dict[str, list[float]]
    notes: list[str]
    is_repaired: bool
    repairs: list[tuple[str, int, float, Optional[Floats], str]]

def read_surface(file: str, faces: str, progress: Progress) -> Surface: ...
def surface_of_arrays(
    points: Floats,
    triangles: NDArray[Any],
    labels: Optional[NDArray[Any]],
    array: str,
    names: Mapping[int, str],
    wall: Optional[int],
    point_arrays: Mapping[str, Floats],
    cell_arrays: Mapping[str, Floats],
) -> Surface: ...
def repair(surface: Surface, arguments: Sequence[str], progress: Progress) -> Surface: ...

class Model:
    def __init__(
        self, surface: Surface, arguments: Sequence[str], lines: Sequence[Floats], source: str, progress: Progress
    ) -> None: ...
    number_of_vessels: int
    openings: list[tuple[str, int, Floats, Floats, float, float, float, Optional[int]]]
    branches: list[tuple[Floats, Floats, Floats, float, float, float, list[int], list[int]]]
    centerlines: tuple[Floats, Floats, list[NDArray[np.uint64]]]
    surface: tuple[Floats, NDArray[np.uint32], NDArray[np.int32]]
    def sections(
        self, spacing: float, threads: int
    ) -> tuple[
        NDArray[np.uint64], Floats, Floats, Floats, Floats, Floats, Floats, Floats, Floats, Floats, Floats, Floats
    ]: ...
    def write_centerlines(self, file: str) -> None: ...
    def write_surface(self, file: str) -> None: ...

class Mesh:
    points: Floats
    point_arrays: dict[str, Floats]
    cell_arrays: dict[str, Floats]
    patch_names: dict[int, str]
    region_names: dict[int, str]
    measures: list[str]
    is_surface: bool
    fallbacks: list[str]
    def elements(self, kind: str) -> tuple[NDArray[np.uint32], NDArray[np.int32]]: ...
    def quality(self, measure: str) -> Floats: ...
    def json_report(self) -> str: ...
    def print_summary(self, verbose: bool) -> None: ...
    def write(self, file: str, format: str) -> None: ...
    def write_surface(self, file: str) -> None: ...
    def changes_in(self, file: str, format: str) -> list[str]: ...

def mesh(model: Model, arguments: Sequence[str], source: str, prints: bool, progress: Progress) -> Mesh: ...
