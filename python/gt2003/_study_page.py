"""The page of a study: old against new parameters, their importance, convergence."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from pathlib import Path
from typing import Any

from . import _files
from ._intervals import too_few
from ._page import BLUE, GRAY, GREEN, RED, Dot, dots, interval, number, page, table, verdict

COLORS = {"good": GREEN, "bad": RED, "": GRAY}


def _chart(history: Sequence[Any]) -> str:
    """Draw the generations: the costs from the best candidate's to the median, and the step below."""
    width, height, low_height, left, top = 720, 260, 80, 60, 10
    kept = [g for g in history if g.median < 1e5] or list(history)
    low = min(g.best for g in kept)
    high = max(g.median for g in kept)
    span = (high - low) or 1.0
    step_top = top + height + 30
    most = max(g.step for g in history) or 1.0

    def x(i: int) -> float:
        return left + i * width / max(1, len(history) - 1)

    def y(cost: float) -> float:
        return top + height * (high - min(cost, high)) / span

    def of_step(step: float) -> float:
        return step_top + low_height * (1 - step / most)

    bottom = step_top + low_height
    parts = [f'<figure><svg viewBox="0 0 {width + left + 110} {bottom + 44}" width="{width + left + 110}" role="img">']
    for k in range(5):
        cost = low + span * k / 4
        parts.append(
            f'<line x1="{left}" x2="{left + width}" y1="{y(cost):.1f}" y2="{y(cost):.1f}" stroke="#ddd"/>'
            f'<text x="{left - 8}" y="{y(cost) + 4:.1f}" text-anchor="end">{cost:.3g}</text>'
        )
    best = [f"{x(i):.1f},{y(g.best):.1f}" for i, g in enumerate(history)]
    median = [f"{x(i):.1f},{y(g.median):.1f}" for i, g in enumerate(history)]
    parts.append(f'<polygon points="{" ".join(best + median[::-1])}" fill="{BLUE}" opacity="0.12"/>')
    for name, color, points in (("best", GREEN, best), ("median", BLUE, median)):
        end = y(getattr(history[-1], name)) + (14 if name == "best" else -4)
        parts.append(f'<polyline fill="none" stroke="{color}" stroke-width="2" points="{" ".join(points)}"/>')
        parts.append(f'<text x="{left + width + 8}" y="{end:.1f}">{name}</text>')
    steps = " ".join(f"{x(i):.1f},{of_step(g.step):.1f}" for i, g in enumerate(history))
    parts.append(
        f'<line x1="{left}" x2="{left + width}" y1="{bottom}" y2="{bottom}" stroke="#ddd"/>'
        f'<polyline fill="none" stroke="{GRAY}" stroke-width="2" points="{steps}"/>'
        f'<text x="{left - 8}" y="{of_step(most) + 4:.1f}" text-anchor="end">{most:.2g}</text>'
        f'<text x="{left - 8}" y="{bottom + 4}" text-anchor="end">0</text>'
        f'<text x="{left + width + 8}" y="{of_step(history[-1].step) + 4:.1f}">step</text>'
    )
    for i in range(0, len(history), max(1, len(history) // 10)):
        parts.append(f'<text x="{x(i):.1f}" y="{bottom + 18}" text-anchor="middle">{i + 1}</text>')
    seeds = sorted({g.repetitions for g in history})
    told = f"{seeds[0]}" if len(seeds) == 1 else f"{seeds[0]} to {seeds[-1]}"
    parts.append(
        f'<text x="{left + width / 2}" y="{bottom + 36}" text-anchor="middle">generation</text></svg>'
        f"<figcaption>Costs of the candidates, each generation on {told} seeds of its own; below: the search's standard "
        "deviation, as a share of the ranges.</figcaption></figure>"
    )
    return "".join(parts)


def _range(parameter: Any, old: float, new: float) -> str:
    """Draw where the old value (ring) and the new one lie in the range."""
    width = 150

    def x(value: float) -> float:
        return 6 + (width - 12) * float(parameter.place(value))

    return (
        f'<svg width="{width}" height="14" role="img"><line x1="6" x2="{width - 6}" y1="7" y2="7" stroke="#bbb"/>'
        f'<line x1="{x(old):.1f}" x2="{x(new):.1f}" y1="7" y2="7" stroke="{BLUE}" stroke-width="3" opacity="0.4"/>'
        f'<circle cx="{x(old):.1f}" cy="7" r="4" fill="#fff" stroke="{GRAY}" stroke-width="2"/>'
        f'<circle cx="{x(new):.1f}" cy="7" r="4.5" fill="{BLUE}"/></svg>'
    )


def _share(change: float | None, of: float) -> float | None:
    return None if change is None else 100 * change / abs(of)


def _changes(comparisons: Sequence[Any], aims: dict[str, str], test: str) -> list[str]:
    """Draw the changes of the figures to improve, in percent of the old values."""
    rows = [
        Dot(c.name, 100 * (c.new - c.old) / abs(c.old), _share(c.low, c.old), _share(c.high, c.old),
            COLORS[verdict(c.low, c.high, aims[c.name])])
        for c in comparisons
        if c.test == test and c.name in aims and c.old != 0
    ]
    return [dots(rows, 0, "change in % of the old value; green: better, red: worse, gray: not certain")] if rows else []


def write_page(
    study: Any, path: Path, jobs: int, history: Sequence[Any], comparisons: Sequence[Any], importance: Sequence[Any], seeds: int
) -> None:
    """Write the page, which opens offline. `seeds` is how many the changes are measured on."""
    aims = {f.name: f.aim for f in study.figure}
    ranges = {p.path: p for p in study.parameter}
    goals = ", ".join(f"<code>{escape(f.name)}</code> ({f.aim})" for f in study.figure)
    parts = [
        f"<p>{len(study.parameter)} parameters, {len(history)} generations of {study.population} candidates, {jobs} jobs "
        f"<code>{escape(study.job)}</code>. Figures to improve: {goals}.</p>",
        "<h2>Old and new parameters on unseen seeds</h2>"
        f"<p>Seeds {study.test_seeds}; means, and the change with its 95 % interval (Student's t, of the differences on each seed). "
        f"{too_few(seeds)}</p>",
    ]
    for test in study.test:
        settings = f" <small><code>{escape(' '.join(test.settings))}</code></small>" if test.settings else ""
        parts += [f"<h3>{escape(test.name)}{settings}</h3>", *_changes(comparisons, aims, test.name)]
        rows = [
            [("<b>{}</b>" if c.name in aims else "{}").format(escape(c.name)), number(c.old), number(c.new),
             escape(c.unit), f"{c.new - c.old:+.3g}",
             f'<span class="{verdict(c.low, c.high, aims.get(c.name, ""))}">{interval(c.low, c.high)}</span>']
            for c in comparisons
            if c.test == test.name
        ]
        parts.append(table(["figure", "old", "new", "unit", "change", "interval"], rows))
    parts += [
        "<h2>Importance of each parameter</h2><p>By how much the cost grows if this parameter alone has its old value again.</p>",
        dots([Dot(i.path.partition(".")[2], i.change, i.low, i.high, BLUE if (i.low or 0) > 0 else GRAY) for i in importance]),
        table(
            ["parameter", "old", "new", "range", "old ○, new ●", "importance", "interval"],
            [[escape(i.path), number(i.old), number(i.new), f"{ranges[i.path].low:g} … {ranges[i.path].high:g}",
              _range(ranges[i.path], i.old, i.new), f"{i.change:+.3g}", interval(i.low, i.high)] for i in importance],
        ),
        "<h2>Convergence</h2>",
        _chart(history),
    ]
    _files.write(path, page(study.title, parts))
