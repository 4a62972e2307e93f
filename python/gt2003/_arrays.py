"""How arrays get from Python to C++."""

from __future__ import annotations

import numpy as np


def as_array(value: object, dtype: str, shape: tuple[int | None, ...]) -> np.ndarray:
    """Return a value as an array that has this type and shape, in which None is any length.

    Numbers may become floats, and integers of any width those that can hold them. Everything else
    is a TypeError or ValueError, and so are numbers that are not finite.
    """
    array = np.asarray(value)
    wanted = np.dtype(dtype)
    if array.size == 0 and array.ndim == 1 and None in shape:
        array = array.reshape([length or 0 for length in shape])
    matches = array.ndim == len(shape) and all(
        length is None or length == given for length, given in zip(shape, array.shape)
    )
    if not matches:
        text = ", ".join("any" if length is None else str(length) for length in shape)
        raise ValueError(f"expected an array of shape ({text}), got {array.shape}")
    integers = "iu"
    if array.size == 0:
        pass
    elif wanted.kind in integers and array.dtype.kind in integers:
        limits = np.iinfo(wanted)
        if array.min() < limits.min or array.max() > limits.max:
            raise ValueError(f"has numbers that are no {wanted}")
    elif array.dtype.kind not in integers + "fb" or not np.can_cast(
        array.dtype, wanted, "same_kind"
    ):
        raise TypeError(f"expected an array of {wanted}, got {array.dtype}")
    elif (array.dtype.kind == "b") != (wanted.kind == "b"):
        raise TypeError(f"expected an array of {wanted}, got {array.dtype}")
    if array.dtype.kind == "f" and not np.isfinite(array).all():
        raise ValueError("expected finite numbers")
    return np.ascontiguousarray(array, dtype=wanted)
