"""Color tables: which color class each color of an image has.

A table is an array (64, 64, 64), uint8: the class (`representations.ColorClass`) by the upper six
bits of Y, Cb and Cr.

    table = gt2003.colors.read("config/coltable.c64")
    classes = gt2003.colors.classify(table, robot.image)
"""

from __future__ import annotations

import os
from typing import Literal

import numpy as np
import numpy.typing as npt

from . import _core, _files
from ._core import ColorStatistics, ColorTableEditor
from ._error import Error

__all__ = ["ColorStatistics", "ColorTableEditor", "classify", "read", "write"]

Table = npt.NDArray[np.uint8]


def read(
    path: str | os.PathLike[str], order: Literal["gt2003", "nao2009"] = "gt2003"
) -> Table:
    """Read a table (.c64), HSI ranges (.hsi) or TSL thresholds (.tsl) as a table.

    `order` says what the class numbers of a .c64 file mean: the report's, or those of 2009. A
    UserWarning if the table then has no green, white and gray.
    """
    return _core._read_colors(os.fspath(path), order)


def write(path: str | os.PathLike[str], table: Table) -> None:
    """Write a table as a .c64 file."""
    _files.write(path, _core._color_bytes(np.ascontiguousarray(table)))


def classify(table: Table, image: npt.NDArray[np.uint8]) -> npt.NDArray[np.uint8]:
    """Return the class of each pixel of an image of YCbCr: (height, width, 3) gives (height, width)."""
    if table.shape != (64, 64, 64) or table.dtype != np.uint8:
        raise Error("expected an array of uint8 of shape (64, 64, 64)", field="table")
    if image.ndim != 3 or image.shape[2] != 3 or image.dtype != np.uint8:
        raise Error("expected an array of uint8 of shape (height, width, 3)", field="image")
    y, cb, cr = (image >> 2).transpose(2, 0, 1)
    return table[y, cb, cr]
