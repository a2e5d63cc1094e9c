# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What goes wrong, as exceptions with their data."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import NoReturn, Optional

Place = tuple[float, float, float]


class Error(Exception):
    """The base of this package's exceptions: one sentence that says what is wrong, where, and what to do.

    Attributes
    ----------
    sentence : str
    places : list of (x, y, z)
        The places that the sentence names, in the unit of the surface.
    place : (x, y, z) or None
        The first of them.
    stage : str
        The stage of meshing in which it happened, as ``progress`` receives it; empty outside of one.
    file : str or None
        The file that the sentence names.
    line, byte, vertex, face : int or None
        Where in that file, or which one of the surface, as the sentence counts them.
    """

    def __init__(self, sentence: str, places: Optional[list[Place]] = None, stage: str = "") -> None:
        super().__init__(sentence)
        self.sentence = sentence
        self.places = [tuple(p) for p in places or []]
        self.place = self.places[0] if self.places else None
        self.stage = stage
        self.file = _file(sentence)
        self.line = _number("line", sentence)
        self.byte = _number("byte", sentence)
        self.vertex = _number("(?:vertex|point)", sentence)
        self.face = _number("(?:face|triangle)", sentence)


class InputError(Error, ValueError):
    """The input cannot be read, or cannot be used."""


class ParameterError(Error, ValueError):
    """An option has a value outside of its range, or cannot go with another one."""


class MeshingError(Error, RuntimeError):
    """The input is usable, but no valid mesh came out of it."""


class OutputError(Error, OSError):
    """A file cannot be written. The file that was there before, if any, is as it was."""


def _file(sentence: str) -> Optional[str]:
    found = re.search(r'(?:\b[Ff](?:ile|older)|cannot be written to|^Line \d+ of) "([^"]+)"', sentence)
    return found.group(1) if found else None


def _number(word: str, sentence: str) -> Optional[int]:
    found = re.search(r"\b" + word + r" (\d+)", sentence, re.IGNORECASE)
    return int(found.group(1)) if found else None


def in_python(sentence: str) -> str:
    """A sentence of the command-line tool, with options as they are called here."""
    sentence = re.sub(r"(?<![\w-])--(no-)?([a-z][a-z-]*[a-z])", _keyword, sentence)
    return sentence.replace("; see help.", ".")


def _keyword(option: re.Match[str]) -> str:
    return ((option.group(1) or "") + option.group(2)).replace("-", "_")


def error_of(kind: str, sentence: str, places: list[Place], stage: str) -> Error:
    """The exception for one of the library's; called by the compiled module."""
    types = {t.__name__: t for t in (InputError, ParameterError, MeshingError, OutputError)}
    return types.get(kind, Error)(in_python(sentence), places, stage)


def unknown_keywords(function: str, unknown: Mapping[str, object], known: list[str]) -> NoReturn:
    """Refuses keywords that a function does not have, naming the nearest one that it has."""
    import difflib

    name = next(iter(unknown))
    nearest = difflib.get_close_matches(name.replace("-", "_"), known, 1, 0.5)
    raise TypeError(
        f"{function}() has no option {name!r}" + (f"; did you mean {nearest[0]!r}?" if nearest else ".")
    )
