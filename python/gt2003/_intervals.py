"""Intervals of means over few seeds, and how many seeds it takes to tell."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike

__all__ = ["ENOUGH", "around", "mean_interval", "outside", "seeds_for", "student", "too_few"]

ENOUGH = 10  # seeds; with fewer the next ones may well turn the result round
NORMAL = 1.959964  # 97.5 % of the normal distribution
MOST = 100_000  # seeds that anybody would play


def _fraction(a: float, b: float, x: float) -> float:
    """Return the continued fraction of the incomplete beta function (Abramowitz and Stegun, 26.5.8), by Lentz's method."""
    c, d = 1.0, 1 / (1 - (a + b) * x / (a + 1))
    fraction = d
    for m in range(1, 1000):
        for factor in (
            m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m)),
            -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1)),
        ):
            d = 1 / (1 + factor * d)
            c = 1 + factor / c
            fraction *= c * d
        if abs(c * d - 1) < 1e-14:
            break
    return fraction


def outside(t: float, degrees: float) -> float:
    """Return the chance that Student's t lies outside of -t and t; the degrees of freedom need not be whole."""
    if t == 0:
        return 1.0
    a, b, sum_ = degrees / 2, 0.5, degrees + t * t
    x, rest = degrees / sum_, t * t / sum_
    scale = math.exp(math.lgamma(a + b) - math.lgamma(a) - math.lgamma(b) + a * math.log(x) + b * math.log(rest))
    if x < (a + 1) / (a + b + 2):
        return scale * _fraction(a, b, x) / a
    return 1 - scale * _fraction(b, a, rest) / b


@lru_cache(maxsize=1024)
def student(degrees: int) -> float:
    """Return the 97.5 % quantile of Student's t distribution: 12.706 for one degree of freedom."""
    if degrees > 1000:  # Abramowitz and Stegun, 26.7.5
        return NORMAL + (NORMAL**3 + NORMAL) / (4 * degrees)
    low, high = 0.0, 13.0
    while high - low > 1e-9:
        middle = (low + high) / 2
        low, high = (middle, high) if outside(middle, degrees) > 0.05 else (low, middle)
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
