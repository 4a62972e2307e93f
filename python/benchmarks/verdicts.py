"""Whether measured figures are better or worse than those of before, by statistics.

A difference up to a figure's tolerance does not matter. What is tested is whether the true difference is larger: by Student's test on the
differences of the seeds if both were measured on the same ones, else by Welch's. A value without chance (one run) is judged by its
tolerance alone. Over all figures that are judged together, a false alarm has a chance of 5 % at most: Holm, A simple sequentially
rejective multiple test procedure, Scandinavian Journal of Statistics 6 (1979).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from gt2003._intervals import outside

ALARMS = 0.05  # chance of a false alarm in all figures together
KINDS = ("different", "greater", "less")  # what counts as worse
ROUNDING = 1e-9  # of values, as a share


@dataclass(frozen=True)
class Sample:
    """The values of a figure. Seeds are in the order of the runs; empty if the runs have none."""

    runs: tuple[float, ...]
    seeds: tuple[int, ...] = ()


@dataclass(frozen=True)
class Chances:
    """How probable so large a difference would be if the figure had not become worse (or better)."""

    worse: float
    better: float


def _moments(values: Sequence[float]) -> tuple[float, float, int]:
    """Return the mean, its squared standard error and its degrees of freedom; without error if there is one value."""
    n = len(values)
    mean = math.fsum(values) / n
    if n == 1:
        return mean, 0.0, 1
    return mean, math.fsum((v - mean) ** 2 for v in values) / (n - 1) / n, n - 1


def _difference(before: Sample, now: Sample) -> tuple[float, float, float]:
    """Return the mean difference, its standard error and its degrees of freedom."""
    if now.seeds and set(now.seeds) == set(before.seeds):
        old = dict(zip(before.seeds, before.runs, strict=True))
        mean, square, degrees = _moments([run - old[seed] for seed, run in zip(now.seeds, now.runs, strict=True)])
        return mean, math.sqrt(square), degrees
    means, squares, freedoms = zip(*(_moments(s.runs) for s in (before, now)), strict=True)
    shares = sum(square**2 / freedom for square, freedom in zip(squares, freedoms, strict=True))
    return means[1] - means[0], math.sqrt(sum(squares)), sum(squares) ** 2 / shares if shares else 1


def _beyond(difference: float, error: float, degrees: float, tolerance: float) -> float:
    """Return how probable so large a difference would be if the true one were no greater than the tolerance."""
    excess = difference - tolerance
    if error <= ROUNDING * (abs(difference) + tolerance):
        return 0.0 if excess > ROUNDING * (abs(difference) + tolerance) else 1.0
    both = outside(excess / error, degrees) / 2
    return both if excess > 0 else 1 - both


def comparable(before: Sample, now: Sample) -> bool:
    """Whether a verdict is possible: a single run says nothing beside several."""
    return (len(before.runs) == 1) == (len(now.runs) == 1)


def chances(before: Sample, now: Sample, worse: str, tolerance: float = 0) -> Chances:
    """Return the chances of a figure of which greater, less or different values are worse."""
    difference, error, degrees = _difference(before, now)
    greater = _beyond(difference, error, degrees, tolerance)
    less = _beyond(-difference, error, degrees, tolerance)
    if worse == "different":
        return Chances(min(1.0, 2 * min(greater, less)), 1.0)
    return Chances(greater, less) if worse == "greater" else Chances(less, greater)


def _found(probabilities: Sequence[float]) -> set[int]:
    """Return which of some tests reject, by Holm's method."""
    order = sorted(range(len(probabilities)), key=lambda i: probabilities[i])
    found: set[int] = set()
    for rank, i in enumerate(order):
        if probabilities[i] > ALARMS / (len(order) - rank):
            break
        found.add(i)
    return found


def verdicts(tests: Sequence[Chances]) -> list[str]:
    """Return "worse", "better" or "same" for each of the figures that are judged together."""
    worse, better = _found([t.worse for t in tests]), _found([t.better for t in tests])
    return ["worse" if i in worse else "better" if i in better else "same" for i in range(len(tests))]


def fits(before: Sample, now: Sample, worse: str, tolerance: float = 0) -> bool:
    """Whether a figure, measured again on some of its seeds, is not worse by more than its runs differ from each other."""
    old = dict(zip(before.seeds, before.runs, strict=True)) if before.seeds else dict(enumerate(before.runs))
    seeds = now.seeds or range(len(now.runs))
    difference = math.fsum(run - old[seed] for seed, run in zip(seeds, now.runs, strict=True)) / len(now.runs)
    mean = math.fsum(before.runs) / len(before.runs)
    spread = math.sqrt(math.fsum((run - mean) ** 2 for run in before.runs) / max(1, len(before.runs) - 1))
    amount = {"greater": difference, "less": -difference, "different": abs(difference)}[worse]
    return amount <= max(tolerance, spread)
