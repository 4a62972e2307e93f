"""Files that are written whole, or not at all."""

from __future__ import annotations

import os

from . import _core


def write(path: str | os.PathLike[str], content: str | bytes) -> None:
    """Write a file, under another name until it is whole. An Error if that fails; what was there before stays then."""
    _core._write_file(os.fspath(path), content.encode() if isinstance(content, str) else content)
