"""What the pages of studies, tournaments and runs share: one style, tables, and charts as SVG."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape

STYLE = """body { font: 15px/1.45 sans-serif; max-width: 1100px; margin: 2em auto; padding: 0 1em; color: #222; }
h1, h2, h3 { font-weight: 600; } h2 { margin-top: 1.8em; } table { border-collapse: collapse; margin: .6em 0; }
td, th { padding: 3px 12px; text-align: right; white-space: nowrap; border-bottom: 1px solid #ddd; } th { border-color: #888; }
td:first-child, th:first-child { text-align: left; } .good { color: #0a7a30; } .bad { color: #b02020; }
figure { margin: .6em 0; } figcaption { color: #555; } figure svg { max-width: 100%; height: auto; }
svg text { font: 12px sans-serif; fill: #444; }"""
BLUE, GREEN, RED, GRAY = "#2050b0", "#0a7a30", "#b02020", "#999"


def page(title: str, parts: Sequence[str], note: str = "") -> str:
    """Return a page that opens offline, with a note at its top."""
    head = (
        f'<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>{escape(title)}</title>'
        f"<style>{STYLE}</style></head><body><h1>{escape(title)}</h1>"
    )
    top = [f'<p class="bad">{escape(note)}</p>'] if note else []
    return "\n".join([head, *top, *parts, "</body></html>\n"])


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Return a table; its cells are HTML."""
    body = "".join("<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>\n" for row in rows)
    return f"<table><tr>{''.join(f'<th>{h}</th>' for h in head)}</tr>\n{body}</table>"


def number(value: float) -> str:
    """Return four digits of a number."""
    return f"{value:.4g}"


def interval(low: float | None, high: float | None) -> str:
    """Return the interval of a change; it is unknown of a single seed."""
    return "unknown" if low is None or high is None else f"{low:+.3g} … {high:+.3g}"


def verdict(low: float | None, high: float | None, aim: str) -> str:
    """Return the class of a change with this interval: good, bad or, if it is unknown or holds 0, none."""
    if low is None or high is None or low <= 0 <= high or aim not in ("high", "low"):
        return ""
    return "good" if (low > 0) == (aim == "high") else "bad"


@dataclass(frozen=True)
class Dot:
    """A value with its interval, if that is known."""

    label: str
    value: float
    low: float | None
    high: float | None
    color: str = BLUE


def _ticks(low: float, high: float) -> list[float]:
    """Return three to eight round numbers between two."""
    power = 10 ** math.floor(math.log10((high - low) or 1.0))
    step = power * next(s for s in (0.2, 0.5, 1.0, 2.0) if (high - low) / (power * s) <= 7)
    return [step * i for i in range(math.ceil(low / step), math.floor(high / step) + 1)]


def dots(rows: Sequence[Dot], zero: float | None = 0.0, caption: str = "") -> str:
    """Draw values with their intervals below each other; `zero` is where there is a line."""
    left, width, line = 30 + 7 * max(len(r.label) for r in rows), 560, 24
    values = [v for r in rows for v in (r.low, r.high, r.value) if v is not None] + ([] if zero is None else [zero])
    low, high = min(values), max(values)
    span = (high - low) or 1.0

    def x(value: float) -> float:
        return left + 10 + (width - 20) * (value - low) / span

    height = line * len(rows)
    parts = [f'<figure><svg viewBox="0 0 {left + width + 90} {height + 24}" width="{left + width + 90}" role="img">']
    for at in _ticks(low, high):
        parts.append(
            f'<line x1="{x(at):.1f}" x2="{x(at):.1f}" y1="0" y2="{height}" stroke="#eee"/>'
            f'<text x="{x(at):.1f}" y="{height + 16}" text-anchor="middle">{at:.6g}</text>'
        )
    if zero is not None:
        parts.append(f'<line x1="{x(zero):.1f}" x2="{x(zero):.1f}" y1="0" y2="{height}" stroke="#888"/>')
    for i, r in enumerate(rows):
        y = line * i + line / 2
        low_, high_ = r.value if r.low is None else r.low, r.value if r.high is None else r.high
        parts.append(
            f'<text x="{left - 8}" y="{y + 4:.0f}" text-anchor="end">{escape(r.label)}</text>'
            f'<line x1="{x(low_):.1f}" x2="{x(high_):.1f}" y1="{y:.0f}" y2="{y:.0f}" stroke="{r.color}" stroke-width="3" '
            f'stroke-linecap="round" opacity="0.45"/><circle cx="{x(r.value):.1f}" cy="{y:.0f}" r="5" fill="{r.color}"/>'
            f'<text x="{left + width + 8}" y="{y + 4:.0f}">{r.value:.4g}</text>'
        )
    parts.append("</svg>" + (f"<figcaption>{escape(caption)}</figcaption>" if caption else "") + "</figure>")
    return "".join(parts)
