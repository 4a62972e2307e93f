"""Each module by itself: a class for each task, whose objects are solutions of it.

    locator = gt2003.modules.SelfLocator("Kalman")
    pose, particles, state = locator.update(landmarks_percept=landmarks, odometry_data=odometry)

Made from the table of solutions; `solutions` lists it.
"""

from __future__ import annotations

from typing import Any

from . import _core
from ._core import Module

__all__ = ["Module", "solutions"]


def solutions() -> dict[str, list[str]]:
    """Return the solutions of each task; the first of a task is its default."""
    return {task: list(known) for task, known in _core._solutions().items()}


def _make(task: str, known: list[str]) -> type[Module]:
    def __init__(
        self: Module, solution: str = known[0], *, seed: int = 1, root: str = ""
    ) -> None:
        Module.__init__(self, task, solution, seed=seed, root=root)

    members: dict[str, Any] = {
        "__init__": __init__,
        "__module__": __name__,
        "__doc__": f"A solution of the task {task}: {', '.join(known)}.",
    }
    return type(task, (Module,), members)


for _task, _known in solutions().items():
    if _known:
        globals()[_task] = _make(_task, _known)
        __all__.append(_task)
