"""The representations of the robots and all that they consist of, as classes.

Made from the fields that the C++ structs declare: a class for each struct and enumeration, with
the same names. Vectors, arrays of numbers and lists of these are NumPy arrays; `describe` tells
units, ranges and shapes. Types of different structs that share a name are numbered: ``Type2``.
"""

from __future__ import annotations

import enum
from typing import Any

from . import _core
from ._record import Field, Record

__all__: list[str] = []

_types: list[dict[str, Any]] = []


def _annotation(about: dict[str, Any]) -> str:
    """The type of an attribute in Python's notation."""
    if about["dtype"] is not None:
        return f"numpy.typing.NDArray[numpy.{about['dtype'] + '_' * (about['dtype'] == 'bool')}]"
    kind = about["kind"]
    if kind in ("array", "list"):
        return f"list[{_annotation(_types[about['element']])}]"
    if kind == "number":
        return "float" if about["number"].startswith("float") else "int"
    simple = {"boolean": "bool", "text": "str"}
    return simple[kind] if kind in simple else about["class"]


def _name_for(about: dict[str, Any]) -> str:
    plain = "".join(c for c in about["name"] if c.isalnum())
    name, number = plain, 1
    while name in globals():
        number += 1
        name = f"{plain}{number}"
    return name


def _doc(about: dict[str, Any], fields: tuple[Field, ...]) -> str:
    lines = [f"{about['class']}."]
    for field in fields:
        facts = [field.annotation, field.unit, field.doc]
        if field.range is not None:
            facts.append(f"from {field.range[0]:g} to {field.range[1]:g}")
        if field.index_names:
            facts.append("of " + ", ".join(field.index_names))
        lines.append(f"    {field.name}: " + "; ".join(fact for fact in facts if fact))
    return "\n".join(lines)


def _make_record(index: int, about: dict[str, Any]) -> type:
    fields = []
    for part in about["parts"]:
        kind = _types[part["type"]]
        names = tuple(kind["index_names"])
        fields.append(
            Field(part["name"], part["unit"], part["doc"], part["range"], _annotation(kind), names)
        )
    members = {
        "__slots__": tuple(field.name for field in fields),
        "__module__": __name__,
        "__doc__": _doc(about, tuple(fields)),
        "fields": tuple(fields),
        "_default": classmethod(lambda cls: _core._default(index)),
    }
    return type(about["class"], (Record,), members)


def _make(index: int, about: dict[str, Any]) -> None:
    """Make the class of a type, of which C++ knows the index; called for each type in order."""
    _types.append(about)
    if about["kind"] not in ("record", "enumeration") or about["vector"]:
        return
    about["class"] = _name_for(about)
    if about["kind"] == "record":
        made: type = _make_record(index, about)
    else:
        made = enum.IntEnum(
            about["class"],
            {name: number for number, name in enumerate(about["names"])},
            module=__name__,
        )
    globals()[about["class"]] = made
    __all__.append(about["class"])
    _core._adopt(index, made)


def class_name(index: int) -> str:
    """Return how the class of C++'s type with this index is written in a stub."""
    about = _types[index]
    return about.get("class", _annotation(about))


for _index, _about in enumerate(_core._types()):
    _make(_index, _about)
