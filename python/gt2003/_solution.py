"""Solutions that are written in Python: what their `update` declares."""

from __future__ import annotations

import inspect
import typing
from dataclasses import dataclass
from typing import Annotated, Any, TypeVar

import numpy as np

from . import _core, representations
from ._error import Error

T = TypeVar("T")

Previous = Annotated[T, "previous"]
"""An input of `update` as it was at the end of the last cycle: `Previous[RobotPose]`.

So a solution reads what its own task provides, or what tasks provide that read its output.
"""


@dataclass(frozen=True)
class SolutionFailure:
    """A solution written in Python that raised an exception, or returned what does not fit."""

    robot: str
    task: str
    solution: str
    time: int
    """Of the cycle: ms."""
    trace: str


def _known() -> dict[str, tuple[str, type]]:
    """The representations by the names of inputs: their own names, and classes."""
    return {
        _core._input_name(name): (name, getattr(representations, representations.class_name(i)))
        for name, i in _core._representations().items()
    }


def describe(solution: Any, task: str, outputs: list[str]) -> tuple[str, Any, list[tuple]]:
    """Return a solution's name, its `update`, and the inputs of that.

    Each is a tuple of an argument's name, its representation (empty: a generator of random numbers)
    and whether it is that of the last cycle. Raises an Error if `update` does not fit the task.
    """
    name = type(solution).__name__
    update = getattr(solution, "update", None)
    if not inspect.ismethod(update):
        raise Error(f"has no method `update`: a solution of {task} needs one", field=name)
    code = update.__func__.__code__
    place = {"file": code.co_filename, "line": code.co_firstlineno}
    try:
        hints = typing.get_type_hints(update, include_extras=True)
    except Exception as error:
        what = f"its annotations cannot be read: {type(error).__name__}: {error}"
        raise Error(what, field=f"{name}.update", **place) from None
    known = _known()
    inputs = []
    for argument in inspect.signature(update).parameters.values():
        field = f"{name}.update.{argument.name}"
        hint = hints.get(argument.name)
        if argument.kind in (argument.VAR_POSITIONAL, argument.VAR_KEYWORD):
            raise Error("an input has to be named", field=field, **place)
        if argument.kind == argument.POSITIONAL_ONLY:
            raise Error("is given by its name, so it must not be positional only", field=field, **place)
        if hint is np.random.Generator:
            inputs.append((argument.name, "", False))
            continue
        if argument.name not in known:
            what = "there is no representation of this name: an input is called as in gt2003.modules"
            raise Error(what, field=field, **place)
        representation, wanted = known[argument.name]
        previous = hint == Previous[wanted]
        if hint is not wanted and not previous:
            raise Error(f"must be annotated as {wanted.__name__}", field=field, **place)
        inputs.append((argument.name, representation, previous))
    classes = [known[_core._input_name(output)][1] for output in outputs]
    expected = classes[0] if len(classes) == 1 else tuple.__class_getitem__(tuple(classes))
    if hints.get("return") != expected:
        names = ", ".join(made.__name__ for made in classes)
        what = f"must be annotated to return {names if len(classes) == 1 else f'tuple[{names}]'}"
        raise Error(what, field=f"{name}.update", **place)
    return name, update, inputs
