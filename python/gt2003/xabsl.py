"""The compiler and the engine of XABSL, the language of behaviors.

    compiled = gt2003.xabsl.compile("behavior/GT2003.xabsl")
    for diagnostic in compiled.diagnostics:
        print(diagnostic)
    engine = gt2003.xabsl.Engine(compiled.behavior, {"ball.seen": lambda: True, "walk": walk})
    engine.execute(now=0)
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Literal

from . import _core
from ._core import Behavior, Engine
from ._error import Error

__all__ = ["Activation", "Behavior", "Compilation", "Diagnostic", "Engine", "compile"]


@dataclass(frozen=True)
class Diagnostic:
    """A message of the compiler or the engine about a place in a file."""

    severity: Literal["error", "warning"]
    file: str
    line: int
    """From 1; 0: about the file as a whole."""
    column: int
    message: str
    source: str
    """The line itself, if it is known."""

    def __str__(self) -> str:
        place = f"{self.file}:{self.line}:{self.column}" if self.line else self.file
        return f"{place}: {'warning: ' * (self.severity == 'warning')}{self.message}"


@dataclass(frozen=True)
class Activation:
    """An option or basic behavior that a cycle executed."""

    kind: Literal["option", "behavior"]
    depth: int
    """Of the call; the root option is at 0."""
    name: str
    state: str
    """Of an option: its active state."""
    target: bool
    """Whether that is a target state."""
    option_time: int
    """Since the option became active: ms."""
    state_time: int
    """Since the state became active: ms."""
    parameters: dict[str, str]


@dataclass(frozen=True)
class Compilation:
    """A behavior, if there is no error, and all messages."""

    behavior: Behavior | None
    diagnostics: list[Diagnostic]

    def checked(self) -> Behavior:
        """Return the behavior; raise the first error if there is none."""
        if self.behavior is not None:
            return self.behavior
        first = next(d for d in self.diagnostics if d.severity == "error")
        raise Error(first.message, first.file, first.line)


def compile(path: str | os.PathLike[str], files: dict[str, str] | None = None) -> Compilation:
    """Compile the file with the agents (text, or XML 2.1 or 3.1) and all that it includes.

    From the disk, or from `files`: their texts by path.
    """
    return Compilation(*_core._compile_xabsl(os.fspath(path), files))
