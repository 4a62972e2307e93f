"""The one way in which JSON comes into the package."""

from __future__ import annotations

import json
from typing import Any

from . import _core


def parse(text: str, file: str = "") -> Any:
    """Return the value of a text of JSON.

    Raises an Error where the programs would: if it is no JSON, nested too deeply, or an object has too many members.
    """
    _core._check_json(text, file)
    return json.loads(text)
