"""The page of a run: every figure with the values of its seeds, its interval and its aim."""

from __future__ import annotations

from html import escape
from pathlib import Path
from typing import Any

from . import _files, _json
from ._intervals import ENOUGH, mean_interval, too_few
from ._page import BLUE, GREEN, number, page, table


def _strip(figure: dict[str, Any]) -> str:
    """Draw the values of the seeds as dots, the mean and the aim as lines."""
    runs, width = figure["runs"], 220
    aim = figure.get("aim")
    values = [*runs, *([] if aim is None else [aim])]
    low, span = min(values), (max(values) - min(values)) or 1.0

    def x(value: float) -> float:
        return 6 + (width - 12) * (value - low) / span

    parts = [f'<svg width="{width}" height="18" role="img"><line x1="6" x2="{width - 6}" y1="9" y2="9" stroke="#ddd"/>']
    if aim is not None:
        parts.append(
            f'<line x1="{x(aim):.1f}" x2="{x(aim):.1f}" y1="1" y2="17" stroke="{GREEN}" stroke-width="2" stroke-dasharray="3 2"/>'
        )
    parts += [f'<circle cx="{x(v):.1f}" cy="9" r="3.5" fill="{BLUE}" opacity="0.35"/>' for v in runs]
    mean = x(figure["value"])
    parts.append(f'<line x1="{mean:.1f}" x2="{mean:.1f}" y1="3" y2="15" stroke="#222" stroke-width="2"/></svg>')
    return "".join(parts)


def _interval(runs: list[float]) -> str:
    """Return the 95 % interval of the mean over seeds."""
    found = mean_interval(runs)
    return f"{found[0]:.4g} … {found[1]:.4g}" if found else ""


def _row(figure: dict[str, Any]) -> list[str]:
    aim = ""
    if "aim" in figure:
        aim = f'<span class="{"good" if figure["met"] else "bad"}">{number(figure["aim"])}, {"met" if figure["met"] else "missed"}</span>'
    worst = f'{number(figure["low"])} … {number(figure["high"])}'
    runs = figure.get("runs", [])
    return [escape(figure["name"]), number(figure["value"]), escape(figure["unit"]), _interval(runs), str(figure["n"]),
            _strip(figure) if runs else "", worst, aim]


def write_page(figures: Path, path: Path, note: str = "") -> None:
    """Write the page of a file of figures, which opens offline, with a note at its top."""
    groups: dict[str, list[dict[str, Any]]] = {}
    fewest = ENOUGH
    for figure in _json.parse(figures.read_text(), str(figures)):
        groups.setdefault(figure["name"].partition(".")[0], []).append(figure)
        fewest = min(fewest, figure["n"])
    parts = [
        "<p>Means over the seeds with their 95 % intervals (Student's t). Dots: each seed; black: the mean; green, dashed: the aim. "
        f"{too_few(fewest)}</p>"
    ]
    head = ["figure", "mean", "unit", "interval", "seeds", "each seed", "lowest, highest", "aim"]
    for group, members in groups.items():
        parts += [f"<h2>{escape(group)}</h2>", table(head, [_row(figure) for figure in members])]
    _files.write(path, page("Run: " + ", ".join(groups), parts, note))
