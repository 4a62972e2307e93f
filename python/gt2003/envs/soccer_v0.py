"""``GT2003/Soccer-v0`` with an agent for each robot, by PettingZoo's parallel API."""

from __future__ import annotations

from typing import Any

from ._parallel import ParallelEnvironment

__all__ = ["parallel_env"]


def parallel_env(*, agents: str = "all", render_mode: str | None = None, **options: Any) -> ParallelEnvironment:
    """Return four against four: agents have all robots, or the red ones only (``agents="red"``)."""
    return ParallelEnvironment("Soccer", agents=agents, render_mode=render_mode, **options)
