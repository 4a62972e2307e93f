"""Intervals of means over few seeds, and how many seeds it takes to tell."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike

__all__ = ["ENOUGH", "around", "mean_interval", "seeds_for", "student", "too_few"]

ENOUGH = 10  # seeds; with fewer the next ones may well turn the result round
NORMAL = 1.959964  # 97.5 % of the normal distribution
MOST = 100_000  # seeds that anybody would play


def _inside(t: float, degrees: int) -> float:
    """Return the chance that Student's t lies within -t and t: Abramowitz and Stegun, 26.7.3 and 26.7.4."""
    angle = math.atan2(t, math.sqrt(degrees))
    cosine = math.cos(angle)
    term = cosine if degrees % 2 else 1.0
    series = term if degrees > 1 else 0.0
    for k in range(3 if degrees % 2 else 2, degrees - 1, 2):
        term *= (k - 1) / k * cosine**2
        series += term
    if degrees % 2:
        return 2 / math.pi * (angle + math.sin(angle) * series)
    return math.sin(angle) * series


@lru_cache(maxsize=1024)
def student(degrees: int) -> float:
    """Return the 97.5 % quantile of Student's t distribution: 12.706 for one degree of freedom."""
    if degrees > 1000:  # Abramowitz and Stegun, 26.7.5
        return NORMAL + (NORMAL**3 + NORMAL) / (4 * degrees)
    low, high = 0.0, 13.0
    while high - low > 1e-9:
        middle = (low + high) / 2
        low, high = (middle, high) if _inside(middle, degrees) < 0.95 else (low, middle)
    return high


def around(middle: float, values: ArrayLike) -> tuple[float, float] | None:
    """Return the 95 % interval of the values' mean, around a number; None of fewer than two values."""
    array = np.asarray(values, dtype=float)
    if len(array) < 2:
        return None
    half = student(len(array) - 1) * float(array.std(ddof=1)) / math.sqrt(len(array))
    return middle - half, middle + half


def mean_interval(values: ArrayLike) -> tuple[float, float] | None:
    """Return the 95 % interval of a mean by Student's t distribution; None of fewer than two values."""
    array = np.asarray(values, dtype=float)
    return around(float(array.mean()), array) if len(array) else None


def seeds_for(deviation: float, half: float) -> int | None:
    """Return how many seeds it takes until the interval is no wider than the mean +- half; None if no number does.

    deviation: standard deviation of the values of the seeds.
    """
    if half <= 0:
        return None
    low, high = 2, MOST
    if student(high - 1) * deviation > half * math.sqrt(high):
        return None
    while low < high:
        middle = (low + high) // 2
        if student(middle - 1) * deviation <= half * math.sqrt(middle):
            high = middle
        else:
            low = middle + 1
    return low


def too_few(seeds: int) -> str:
    """Return the sentence for a page or a person if that many seeds tell little; empty if they are enough."""
    if seeds >= ENOUGH:
        return ""
    return f"Too few seeds to tell: {seeds}, where {ENOUGH} are the least. The next ones may turn the result round."
