"""Measures figures of measured.toml at chosen commits, each built on this machine, and shows them on a page.

history.py COMMIT ... [--only PREFIX,...] [--core] [--out out/history]

What was measured at a commit stays in OUT/COMMIT.json; only what lacks there is measured. The page is OUT/index.html. A command or
a figure that a commit does not know is left out, and said.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from html import escape
from pathlib import Path

import kept
import measure
from against import ROOT, Failure, run, tree_of
from gt2003 import Error, _files
from gt2003._page import Dot, dots, page
from kept import Kept, Measurement

TARGETS = ("experiment", "colortable", "simgt")


@dataclass(frozen=True)
class Commit:
    """What was measured at a commit."""

    name: str
    date: str
    subject: str
    figures: Mapping[str, Kept]


def measured(tree: Path, name: str, chosen: Sequence[Measurement], out: Path) -> Mapping[str, Kept]:
    """Measure at a commit what its file lacks; return all that it has."""
    file = out / f"{name}.json"
    figures = kept.read(file)
    for i, measurement in enumerate(chosen, 1):
        lacking = [figure for figure in measurement.figure if figure.name not in figures]
        if not lacking:
            continue
        print(f"{name} {i}/{len(chosen)} {measurement.command}", file=sys.stderr, flush=True)
        written = out / name / f"{i}.json"
        try:
            seeds = ["--seeds", measurement.seeds] if measurement.seeds else []
            seconds = measure.write(measurement.command, seeds, tree / "build/release", written, tree)
            results = measure.results(written, "")
        except Error as error:
            print(f"  is not measured at {name}: {error.what}", file=sys.stderr)
            continue
        for figure in lacking:
            if figure.name in results:
                unit, sample = results[figure.name]
                figures[figure.name] = kept.keep(figure.name, unit, figure.worse, measurement.command, seconds, name, sample)
        kept.write(file, figures.values())
    return figures


def chart(name: str, commits: Sequence[Commit], worse: str) -> str:
    """Draw a figure at the commits, in their order."""
    rows = []
    for commit in commits:
        figure = commit.figures.get(name)
        if figure:
            low, high = figure.interval or (None, None)
            rows.append(Dot(f"{commit.date} {commit.name[:7]}", figure.value, low, high))
    unit = next(c.figures[name].unit for c in commits if name in c.figures)
    lacking = [commit.name[:7] for commit in commits if name not in commit.figures]
    caption = f"{unit}; {worse} is worse" + (f"; not measured at {', '.join(lacking)}" if lacking else "")
    return f"<h3>{escape(name)}</h3>" + dots(rows, zero=None, caption=caption)


def text(commits: Sequence[Commit], chosen: Sequence[Measurement]) -> str:
    """Return the page: a chart for each figure that any commit has, in the order of the list."""
    listed = "".join(f"<li>{c.date} <code>{escape(c.name)}</code> {escape(c.subject)}</li>" for c in commits)
    parts = [f"<ul>{listed}</ul>"]
    for measurement in chosen:
        shown = [figure for figure in measurement.figure if any(figure.name in c.figures for c in commits)]
        if shown:
            parts.append(f"<h2><code>{escape(measurement.command)}</code></h2>")
            parts += [chart(figure.name, commits, figure.worse) for figure in shown]
    return page("Figures over commits", parts)


def main(arguments: Sequence[str] | None = None, root: Path = ROOT) -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("commits", nargs="+")
    parser.add_argument("--only", default="", help="figures that begin with one of these names")
    parser.add_argument("--core", action="store_true", help="the core set only")
    parser.add_argument("--list", type=Path, default=measure.LIST, help="what is measured")
    parser.add_argument("--out", type=Path, default=Path("out/history"))
    given = parser.parse_args(arguments)
    try:
        chosen = measure.selected(kept.measurements(given.list), [name for name in given.only.split(",") if name], given.core)
        commits = []
        for commit in given.commits:
            tree = tree_of(commit, root, TARGETS)
            date, subject = run(["git", "show", "--no-patch", "--format=%cs %s", tree.name], root).strip().split(" ", 1)
            commits.append(Commit(tree.name, date, subject, measured(tree, tree.name, chosen, given.out.resolve())))
        _files.write(given.out / "index.html", text(commits, chosen))
    except (Error, Failure) as error:
        print(f"history: {error}", file=sys.stderr)
        return 2
    print(f"Page: {given.out / 'index.html'}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
