"""Dataclasses that are read from files of TOML or JSON: what is missing, unknown or of another type is an Error."""

from __future__ import annotations

import math
import os
import tomllib
from dataclasses import fields, is_dataclass
from typing import Any, TypeVar, get_args, get_origin, get_type_hints

from ._error import Error

Kind = TypeVar("Kind")


def load(path: str | os.PathLike[str]) -> dict[str, Any]:
    """Return the tables of a file of TOML."""
    file = os.fspath(path)
    try:
        with open(file, "rb") as text:
            return tomllib.load(text)
    except OSError as error:
        raise Error(error.strerror or "cannot be read", file) from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError, RecursionError) as error:
        raise Error(str(error), file) from None


def made(kind: type[Kind], table: object, file: str, where: str = "") -> Kind:
    """Make a dataclass of a table. Its field `file` is not read; where: the table's place in the file, for errors."""
    if not isinstance(table, dict):
        raise Error("expected a table", file, field=where)
    prefix = f"{where}." if where else ""
    types = get_type_hints(kind)
    known = {f.name: f for f in fields(kind) if f.name != "file"}  # type: ignore[arg-type]
    for name in table:
        if name not in known:
            raise Error(f"is unknown; expected one of: {', '.join(known)}", file, field=prefix + name)
    values: dict[str, Any] = {}
    for name, f in known.items():
        if name in table:
            values[name] = _value(types[name], table[name], file, prefix, name)
        elif f.default is f.default_factory:  # both are missing
            raise Error("is missing", file, field=prefix + name)
    return kind(**values)


def _value(expected: Any, value: object, file: str, prefix: str, name: str) -> Any:
    """Return the value of a field, whose lists are tuples."""
    if get_origin(expected) is not tuple:
        return _scalar(expected, value, file, prefix + name)
    element = get_args(expected)[0]
    if is_dataclass(element):
        if not isinstance(value, list) or not value:
            raise Error(f"expected tables [[{prefix + name}]]", file, field=prefix + name)
        return tuple(made(element, v, file, f"{prefix}{name} {i}") for i, v in enumerate(value, 1))
    if not isinstance(value, list):
        raise Error(f"expected a list of {element.__name__}", file, field=prefix + name)
    return tuple(_scalar(element, v, file, f"{prefix}{name} {i}") for i, v in enumerate(value, 1))


def _scalar(expected: type, value: object, file: str, where: str) -> object:
    accepted = (int, float) if expected is float else expected
    if not isinstance(value, accepted) or isinstance(value, bool) != (expected is bool):
        raise Error(f"expected {expected.__name__}", file, field=where)
    if isinstance(value, float) and not math.isfinite(value):
        raise Error("expected a finite number", file, field=where)
    return value
