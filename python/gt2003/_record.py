"""What the classes of representations have in common."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np


@dataclass(frozen=True)
class Field:
    """What is to be known about an attribute of a record, as C++ declares it."""

    name: str
    unit: str
    doc: str
    range: tuple[float, float] | None
    annotation: str
    index_names: tuple[str, ...]


class Record:
    """A value that consists of fields, with the names, units and defaults of its C++ struct."""

    __slots__ = ()
    fields: ClassVar[tuple[Field, ...]] = ()

    def __init__(self, **values: Any) -> None:
        default = self._default()
        for field in self.fields:
            value = values.pop(field.name) if field.name in values else getattr(default, field.name)
            setattr(self, field.name, value)
        if values:
            name = type(self).__name__
            raise TypeError(f"{name} has no field {', '.join(sorted(values))}")

    @classmethod
    def _default(cls) -> Record:
        raise TypeError(f"{cls.__name__} cannot be made without a value")

    def __repr__(self) -> str:
        values = (f"{field.name}={getattr(self, field.name)!r}" for field in self.fields)
        return f"{type(self).__name__}({', '.join(values)})"

    def __eq__(self, other: object) -> bool:
        if type(self) is not type(other):
            return NotImplemented
        return all(
            _equal(getattr(self, field.name), getattr(other, field.name)) for field in self.fields
        )

    __hash__ = None  # type: ignore[assignment]


def _equal(a: Any, b: Any) -> bool:
    if isinstance(a, np.ndarray) or isinstance(b, np.ndarray):
        return np.array_equal(a, b)
    if isinstance(a, list) and isinstance(b, list):
        return len(a) == len(b) and all(map(_equal, a, b))
    return bool(a == b)
