"""Films of matches, as `Match.film` makes them."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ._core import Match

__all__ = ["Film"]


class Film:
    """A film that is being made. `end()` ends it, as does the end of a `with` block."""

    def __init__(self, match: Match, file: str, view: str, robot: str, numbers: Sequence[float]) -> None:
        self.path = Path(file)
        self._match: Match | None = match
        words = [str(Path.cwd() / self.path), view, *(f"{number:.10g}" for number in numbers)]
        match.console("film start " + " ".join(map(_quoted, words)), robot=robot)

    def end(self) -> Path:
        """End the film, and return the file's path. Without effect after the first time."""
        if self._match is not None:
            match, self._match = self._match, None
            match.console("film stop")
        return self.path

    def __enter__(self) -> Film:
        return self

    def __exit__(self, kind: type[BaseException] | None, value: BaseException | None, trace: TracebackType | None) -> None:
        self.end()


def _quoted(word: str) -> str:
    """Return a word of a line of the console."""
    return '"' + word.replace("\\", "\\\\").replace('"', '\\"') + '"'
