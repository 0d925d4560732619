# SPDX-License-Identifier: MIT
"""Arrays as users give them, checked: what is wrong with one is a ValueError that says so."""

from __future__ import annotations

from typing import Any

import numpy as np

SCALARS: dict[str, np.dtype[Any]] = {"float": np.dtype(np.float32), "double": np.dtype(np.float64)}


def shape_error(name: str, array: np.ndarray, expected: str) -> ValueError:
    return ValueError(f"{name}: shape {array.shape}; expected {expected}")


def scalar_dtype(scalar: Any) -> np.dtype:
    """The dtype of "float" or "double" (or of float32 or float64)."""
    if isinstance(scalar, str) and scalar in SCALARS:
        return SCALARS[scalar]
    try:
        dtype = np.dtype(scalar)
    except TypeError:
        dtype = np.dtype(object)
    if dtype not in SCALARS.values():
        raise ValueError(f"scalar: {scalar!r}; expected 'float' or 'double'")
    return dtype


def numbers(name: str, values: Any, dtype: np.dtype | None = None) -> np.ndarray:
    """The values as an array of float or double; copied only where they are not one already.

    Without a dtype float32 stays float32, and whatever else becomes float64.
    """
    try:
        array = np.asarray(values)
    except ValueError as error:
        raise ValueError(f"{name}: not an array of numbers: {error}") from None
    if array.dtype.kind not in "fiu":
        raise ValueError(f"{name}: dtype {array.dtype}; expected float32 or float64")
    if dtype is None:
        dtype = np.dtype(np.float32 if array.dtype.itemsize == 4 and array.dtype.kind == "f" else np.float64)
    # Unaligned or byte-swapped numbers can't be read in place.
    return np.require(array, dtype.newbyteorder("="), "A")


def integers(name: str, values: Any, dtype: type) -> np.ndarray:
    """The values as a contiguous array of that integer type; copied only where they are not one."""
    array = np.asarray(values)
    if array.size == 0:
        array = array.astype(dtype)
    if array.dtype.kind not in "iu":
        raise ValueError(f"{name}: dtype {array.dtype}; expected integers")
    if array.dtype == np.dtype(dtype):
        return np.ascontiguousarray(array)
    most = np.iinfo(dtype).max
    if array.size and (array.min() < 0 or array.max() > most):
        raise ValueError(f"{name}: from {array.min()} to {array.max()}; expected 0 to {most}")
    return np.ascontiguousarray(array, dtype)


def whole_number(name: str, value: Any, least: int, most: int) -> int:
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, np.integer)):
        raise ValueError(f"{name}: {value!r}; expected a whole number from {least} to {most}")
    if not least <= value <= most:
        raise ValueError(f"{name}: {value}; expected {least} to {most}")
    return int(value)
