# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The options of tubular_mesh as keyword arguments: each has the name it has there, with _ for -."""

from __future__ import annotations

import inspect
import os
from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypeVar, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._errors import ParameterError, unknown_keywords

Path = Union[str, "os.PathLike[str]"]
Point = Union[str, Sequence[float], "np.ndarray[Any, Any]"]
Progress = Callable[[str], object]
Function = TypeVar("Function", bound=Callable[..., Any])

_DESCRIPTIONS = {option["name"].replace("-", "_"): option for option in _core.options()}
_SWITCHED_OFF = {"preserve_volume": "--no-preserve-volume", "loops": "--no-loops"}


def option_names() -> list[str]:
    """The names of all options, as keyword arguments have them."""
    return list(_DESCRIPTIONS)


def given(options: Mapping[str, object], without: Sequence[str] = ()) -> dict[str, object]:
    """Those options that are not None."""
    return {name: value for name, value in options.items() if value is not None and name not in without}


def arguments_of(options: Mapping[str, object]) -> list[str]:
    """The arguments of the command line that options stand for."""
    arguments: list[str] = []
    for name, value in options.items():
        arguments += _arguments_of(name, value)
    return arguments


def _arguments_of(name: str, value: object) -> list[str]:
    option = _DESCRIPTIONS[name]
    if option["is_flag"]:
        if not isinstance(value, (bool, np.bool_)):
            raise ParameterError(f"{name} is True or False, not {value!r}.")
        flag = "--" + option["name"]
        return [flag] if value else [_SWITCHED_OFF[name]] if name in _SWITCHED_OFF else []
    values = _repeated(name, value) if option["is_repeatable"] else [_text(name, value)]
    return [f"--{option['name']}={text}" for text in values]


def _repeated(name: str, value: Any) -> list[str]:
    """One value or several: text, or numbers; of `rename` and `refine_branch` also a dictionary."""
    if isinstance(value, (str, os.PathLike)):
        return [os.fspath(value)]
    if isinstance(value, Mapping):
        return [f"{key}={new}" if name == "rename" else _text(name, (key, new)) for key, new in value.items()]
    values = list(value)
    if any(isinstance(v, (int, float, np.number)) for v in values):
        return [_text(name, values)]  # a point, and what belongs to it
    return [v if isinstance(v, str) else _text(name, v) for v in values]


def _text(name: str, value: Any) -> str:
    """A value as the command line has it: points with commas."""
    if isinstance(value, (str, os.PathLike)):
        return os.fspath(value)
    if isinstance(value, (bool, np.bool_)):
        raise ParameterError(f"{name} is not True or False: give a number or a name.")
    if isinstance(value, (int, np.integer)):
        return str(int(value))
    if isinstance(value, (float, np.floating)):
        return repr(float(value))
    try:
        return ",".join(_text(name, v) for v in value)
    except TypeError:
        raise ParameterError(f"{name} cannot be {value!r}.") from None


def points_as_seeds(options: dict[str, object]) -> dict[str, object]:
    """Seeds that are points, not a file, as the inlet and the outlets that they are."""
    seeds = options.get("seeds")
    if seeds is None or isinstance(seeds, (str, os.PathLike)):
        return options
    points = np.asarray(seeds, dtype=float)
    if points.ndim != 2 or points.shape[1:] != (3,) or len(points) < 2:
        raise ParameterError("seeds are a file, or two points or more, an array of shape (n, 3), the inlet first.")
    if "inlet" in options or "outlet" in options:
        raise ParameterError("seeds cannot go with inlet and outlet.")
    rest = {name: value for name, value in options.items() if name != "seeds"}
    return {**rest, "inlet": points[0], "outlet": list(points[1:])}


def has_options(*own: str) -> Callable[[Function], Function]:
    """Adds the descriptions of the options that a function takes to its documentation.

    `own`: its further keywords, which are no options of the tool.
    """

    def decorate(function: Function) -> Function:
        names = keywords_of(function)
        lines = ["", "Options, None being the default of the command-line tool:", ""]
        for name in names:
            if name in own:
                continue
            option = _DESCRIPTIONS[name]
            default = f" (default: {option['default']})" if option["default"] else ""
            lines.append(f"{name}: {option['description']}{default}")
        function.__doc__ = inspect.cleandoc(function.__doc__ or "") + "\n" + "\n".join(lines) + "\n"
        return function

    return decorate


def keywords_of(function: Callable[..., Any]) -> list[str]:
    code = inspect.unwrap(function).__code__
    first = code.co_argcount
    return [name for name in code.co_varnames[first : first + code.co_kwonlyargcount] if not name.startswith("_")]


def check_known(function: Callable[..., Any], unknown: Mapping[str, object]) -> None:
    """A TypeError for keywords that a function does not have."""
    if unknown:
        unknown_keywords(function.__qualname__.split(".")[0], unknown, keywords_of(function))


def array_of(values: ArrayLike, columns: int, what: str, kind: type) -> "np.ndarray[Any, Any]":
    """A matrix of so many columns."""
    try:
        array = np.asarray(values)
        is_number = np.issubdtype(array.dtype, np.integer) or (kind is float and np.issubdtype(array.dtype, np.floating))
    except ValueError:
        is_number = False
    if not is_number or array.ndim != 2 or array.shape[1] != columns:
        numbers = "numbers" if kind is float else "integers"
        raise ParameterError(f"{what} are an array of {numbers} of shape (n, {columns}).")
    return array

