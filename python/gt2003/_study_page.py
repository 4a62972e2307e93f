"""The page of a study: convergence, old against new parameters, importance."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from pathlib import Path
from typing import Any

STYLE = """body { font: 15px/1.45 sans-serif; max-width: 1000px; margin: 2em auto; padding: 0 1em; color: #222; }
h1, h2 { font-weight: 600; } h2 { margin-top: 1.8em; } table { border-collapse: collapse; }
td, th { padding: 3px 12px; text-align: right; border-bottom: 1px solid #ddd; } th { border-color: #888; }
td:first-child, th:first-child { text-align: left; } .good { color: #0a7a30; } .bad { color: #b02020; }
svg text { font: 12px sans-serif; fill: #444; }"""


def _table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    body = "".join("<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>" for row in rows)
    return f"<table><tr>{''.join(f'<th>{h}</th>' for h in head)}</tr>{body}</table>"


def _number(value: float) -> str:
    return f"{value:.4g}"


def _interval(low: float, high: float) -> str:
    return f"{low:+.3g} … {high:+.3g}"


def _chart(history: Sequence[Any]) -> str:
    """Draw the costs of the generations: the best candidate's and the median."""
    width, height, left, top = 720, 300, 60, 10
    kept = [g for g in history if g.median < 1e5] or list(history)
    low = min(g.best for g in kept)
    high = max(g.median for g in kept)
    span = (high - low) or 1.0

    def x(i: int) -> float:
        return left + i * width / max(1, len(history) - 1)

    def y(cost: float) -> float:
        return top + height * (high - min(cost, high)) / span

    parts = [f'<svg width="{width + left + 110}" height="{height + 50}" role="img">']
    for k in range(5):
        cost = low + span * k / 4
        parts.append(
            f'<line x1="{left}" x2="{left + width}" y1="{y(cost):.1f}" y2="{y(cost):.1f}" stroke="#ddd"/>'
            f'<text x="{left - 8}" y="{y(cost) + 4:.1f}" text-anchor="end">{cost:.3g}</text>'
        )
    for name, color in (("best", "#0a7a30"), ("median", "#2050b0")):
        points = " ".join(f"{x(i):.1f},{y(getattr(g, name)):.1f}" for i, g in enumerate(history))
        end = y(getattr(history[-1], name))
        parts.append(f'<polyline fill="none" stroke="{color}" stroke-width="2" points="{points}"/>')
        parts.append(f'<text x="{left + width + 8}" y="{end + (14 if name == "best" else -4):.1f}">{name}</text>')
    for i in range(0, len(history), max(1, len(history) // 10)):
        parts.append(f'<text x="{x(i):.1f}" y="{height + top + 18}" text-anchor="middle">{i + 1}</text>')
    parts.append(f'<text x="{left + width / 2}" y="{height + top + 36}" text-anchor="middle">generation</text></svg>')
    return "".join(parts)


def write_page(
    study: Any, path: Path, jobs: int, history: Sequence[Any], comparisons: Sequence[Any], importance: Sequence[Any]
) -> None:
    """Write the page, which opens offline."""
    aims = {f.name: f.aim for f in study.figure}

    def verdict(c: Any) -> str:
        text = _interval(c.low, c.high)
        if c.name not in aims or c.low <= 0 <= c.high:
            return text
        good = (c.low > 0) == (aims[c.name] == "high")
        return f'<span class="{"good" if good else "bad"}">{text}</span>'

    ranges = {p.path: p for p in study.parameter}
    goals = ", ".join(f"{escape(f.name)} {f.aim} (weight {f.weight:g}, unit {f.unit:g})" for f in study.figure)
    parts = [
        f'<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>{escape(study.title)}</title>'
        f"<style>{STYLE}</style></head><body><h1>{escape(study.title)}</h1>",
        f"<p>{len(study.parameter)} parameters, {len(history)} generations of {study.population} candidates, {jobs} jobs "
        f"<code>{escape(study.job)}</code>. Figures to improve: {goals}.</p>",
        "<h2>Old and new parameters on unseen seeds</h2>"
        f"<p>Seeds {study.test_seeds}; means, and the change with its 95 % interval (paired bootstrap).</p>",
    ]
    for test in study.test:
        parts.append(f"<h3>{escape(test.name)}</h3>")
        rows = [
            [("<b>{}</b>" if c.name in aims else "{}").format(escape(c.name)), _number(c.old), _number(c.new),
             escape(c.unit), f"{c.new - c.old:+.3g}", verdict(c)]
            for c in comparisons
            if c.test == test.name
        ]
        parts.append(_table(["figure", "old", "new", "unit", "change", "interval"], rows))
    parts.append(
        "<h2>Parameters</h2><p>Importance: by how much the cost grows if this parameter alone has its old value again.</p>"
    )
    rows = [
        [escape(i.path), _number(i.old), _number(i.new), f"{ranges[i.path].low:g} … {ranges[i.path].high:g}",
         f"{i.change:+.3g}", _interval(i.low, i.high)]
        for i in importance
    ]
    parts.append(_table(["parameter", "old", "new", "range", "importance", "interval"], rows))
    parts.append(
        "<h2>Convergence</h2><p>Costs of the candidates, each generation on seeds of its own.</p>" + _chart(history)
    )
    parts.append("</body></html>\n")
    path.write_text("\n".join(parts))
