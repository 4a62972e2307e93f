"""Figures as `bench` writes them; those that are kept in docs/figures.json have more (kept.py)."""

from __future__ import annotations

import json
import statistics
from pathlib import Path

Figure = dict[str, object]


def figure(
    name: str, unit: str, runs: list[float], aim: tuple[str, float] | None = None, seeds: list[int] | None = None
) -> Figure:
    """A figure as `bench` writes it: the mean over its runs, and how these spread. seeds: those of the runs, if they have some."""
    ordered = sorted(runs)
    value = statistics.fmean(runs)
    made: Figure = {
        "name": name,
        "value": value,
        "unit": unit,
        "n": len(runs),
        "low": ordered[0],
        "high": ordered[-1],
        "median": statistics.median(runs),
        "p95": ordered[min(len(ordered) - 1, int(0.95 * len(ordered)))],
    }
    if aim:
        kind, limit = aim
        made["aim"] = limit
        made["met"] = value >= limit if kind == "at least" else value <= limit
    if seeds is not None:
        made["seeds"] = seeds
    return made | {"runs": runs}


def add(measured: list[Figure], file: Path) -> None:
    """Prints figures, and has them replace those of the same names in a file, whose folder is made if it is missing."""
    file.parent.mkdir(parents=True, exist_ok=True)
    for made in measured:
        met = {True: "met", False: "not met"}.get(made.get("met"), "")  # type: ignore[call-overload]
        print(f"{made['name']:40} {made['value']:12.4g} {made['unit']:4} {met}", flush=True)
    known = json.loads(file.read_text()) if file.exists() else []
    names = {made["name"] for made in measured}
    kept = [made for made in known if made["name"] not in names]
    file.write_text(json.dumps(kept + measured, indent=1) + "\n")
